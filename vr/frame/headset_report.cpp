#include "vr/frame/headset_report.h"

namespace vr
{
HeadsetReport HeadsetReport::of(HeadsetStage stage, const QString& headset)
{
    const auto report = [stage](const QString& text) { return HeadsetReport{stage, HeadsetEnd::Left, text}; };
    switch (stage) {
    case HeadsetStage::Starting:
        return report(tr("VR starts. Put on the headset."));
    case HeadsetStage::Hidden:
        return report(tr("VR is on, but the headset shows another program."));
    case HeadsetStage::Visible:
        return report(tr("The headset's own menu is open: the controllers are paused here."));
    //: %1: a headset's name
    case HeadsetStage::Running:
        return report(tr("In VR with %1.").arg(headset));
    case HeadsetStage::TakenOff:
        return report(tr("The headset is not worn. Put it on to continue."));
    case HeadsetStage::Ended:
        break;
    }
    return ended(HeadsetEnd::Left);
}

HeadsetReport HeadsetReport::ended(HeadsetEnd end, const QString& detail)
{
    return {HeadsetStage::Ended, end, textOf(end, detail)};
}

QString HeadsetReport::textOf(HeadsetEnd end, const QString& detail)
{
    switch (end) {
    case HeadsetEnd::Left:
        return tr("Left VR.");
    case HeadsetEnd::EndedByRuntime:
        return tr("VR was ended in the headset's own program.");
    case HeadsetEnd::Unavailable:
        return detail;
    case HeadsetEnd::NoBinding:
        //: %1: a window system, such as wayland
        return tr("The headset's program does not support the window system “%1”. Start Fettle with "
                  "QT_QPA_PLATFORM=xcb and QT_XCB_GL_INTEGRATION=xcb_glx, then enter VR again.")
            .arg(detail);
    case HeadsetEnd::CannotRender:
        return tr("VR cannot be drawn with this OpenGL.");
    case HeadsetEnd::RuntimeLost:
        return tr(
            "The headset's program has stopped. The model is as it was; when the program runs again, enter VR again.");
    case HeadsetEnd::SessionLost:
        return tr("The headset is gone. The model is as it was; plug the headset in, then enter VR again.");
    case HeadsetEnd::NotResponding:
        return tr("The headset's program does not answer. The model is as it was; restart that program, then enter VR "
                  "again.");
    case HeadsetEnd::StillNotResponding:
        return tr("The headset's program still does not answer, and VR cannot be entered. Restart that program; if "
                  "that does not help, save the model and restart Fettle.");
    case HeadsetEnd::Failed:
        //: %1: a call of OpenXR and its result, such as xrCreateSession: XR_ERROR_RUNTIME_FAILURE
        return tr("VR ended: the headset's program reports a fault (%1). The model is as it was; try to enter VR "
                  "again.")
            .arg(detail);
    }
    return {};
}
} // namespace vr
