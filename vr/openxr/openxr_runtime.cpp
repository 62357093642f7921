#include "vr/openxr/openxr_runtime.h"

#include "vr/openxr/active_runtime.h"
#include "vr/openxr/xr_instance.h"

namespace vr
{
HeadsetStatus OpenXrRuntime::probe()
{
    HeadsetStatus status = Instance(std::try_to_lock).status();
    status.text = textOf(status);
    return status;
}

QString OpenXrRuntime::openGlRefusal(const QString& runtime, const QVersionNumber& asked, const QVersionNumber& present)
{
    //: %1: the headset's program; %2, %3: versions, such as 4.5
    return tr("%1 asks for OpenGL %2 and refuses OpenGL %3, which Fettle uses. Another OpenXR runtime may accept it.")
        .arg(runtime, asked.toString(), present.toString());
}

QString OpenXrRuntime::textOf(const HeadsetStatus& status)
{
    switch (status.state) {
    case HeadsetStatus::State::NoRuntime:
        if (status.reason == resultName(XR_ERROR_RUNTIME_UNAVAILABLE))
            if (const QString fault = ActiveRuntime::faultOf(ActiveRuntime::manifest(), status.reason);
                !fault.isEmpty())
                return fault;
        if (status.reason == resultName(XR_ERROR_API_VERSION_UNSUPPORTED))
            //: %1: a name from OpenXR, such as XR_ERROR_API_VERSION_UNSUPPORTED
            return tr("The OpenXR runtime needs OpenXR 1.1, which this computer's OpenXR loader does not know (%1). "
                      "Install a newer loader, or choose another runtime.")
                .arg(status.reason);
        //: %1: a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE
        return tr("No OpenXR runtime answers (%1). Start SteamVR, Monado or the headset's own program, then ask again.")
            .arg(status.reason);
    case HeadsetStatus::State::NoHeadset:
        return tr("%1 is running, but no headset is ready (%2). Plug it in and switch it on, then ask again.")
            .arg(status.runtime, status.reason);
    case HeadsetStatus::State::NoOpenGl:
        return tr("%1 supports %2, but it does not support OpenGL.").arg(status.runtime, status.headset);
    case HeadsetStatus::State::InUse:
        return tr("The headset is in use here.");
    case HeadsetStatus::State::Ready:
        return tr("%1 is ready, through %2.").arg(status.headset, status.runtime);
    }
    return {};
}
} // namespace vr
