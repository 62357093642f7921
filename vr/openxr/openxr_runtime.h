#pragma once

#include <QCoreApplication>
#include <QString>
#include <QVersionNumber>

namespace vr
{
/// What the machine offers for VR at this moment.
struct HeadsetStatus
{
    enum class State {
        NoRuntime, ///< none installed, or it does not answer
        NoHeadset, ///< a runtime, but no headset that is ready
        NoOpenGl,  ///< a headset, but its runtime takes no OpenGL pictures
        InUse,     ///< by this very program
        Ready
    };

    State state = State::NoRuntime;
    QString runtime; ///< name and version, if there is one
    QString headset; ///< the system's name, if there is one
    QString reason;  ///< a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE
    QString text;    ///< one or two sentences for people, with the reason
};

/// Asks the OpenXR loader. May take as long as a runtime takes to start, up to seconds: not for the gui thread. Any
/// thread. Never throws: no runtime and no headset are answers.
class OpenXrRuntime
{
    Q_DECLARE_TR_FUNCTIONS(vr::OpenXrRuntime)

public:
    static HeadsetStatus probe();

    /// One or two sentences for people, with the reason.
    static QString textOf(const HeadsetStatus& status);

    /// Says so where the runtime refuses the OpenGL that is present, which is earlier than it asks for.
    static QString openGlRefusal(const QString& runtime, const QVersionNumber& asked, const QVersionNumber& present);
};
} // namespace vr
