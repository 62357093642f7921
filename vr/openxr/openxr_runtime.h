#pragma once

#include <QCoreApplication>
#include <QString>
#include <QVersionNumber>

namespace vr
{
/// The availability of VR at this moment, with the runtime and the headset that offer it.
struct HeadsetStatus
{
    enum class State {
        NoRuntime, ///< no runtime is installed, or none answers
        NoHeadset, ///< there is a runtime, but no headset that is ready
        NoOpenGl,  ///< there is a headset, but its runtime does not accept OpenGL pictures
        InUse,     ///< this program is using the headset already
        Ready
    };

    State state = State::NoRuntime;
    QString runtime; ///< name and version, if there is one
    QString headset; ///< the headset's name, if there is one
    QString reason;  ///< name of an OpenXR result, such as XR_ERROR_RUNTIME_UNAVAILABLE
    QString text;    ///< one or two sentences for the user, including the reason
};

/// Asks the OpenXR loader what is available. Never throws: a missing runtime or headset is a normal result. Thread:
/// any. Cost: up to seconds, because a runtime may have to start; not for the gui thread.
class OpenXrRuntime
{
    Q_DECLARE_TR_FUNCTIONS(vr::OpenXrRuntime)

public:
    static HeadsetStatus probe();

    /// Returns one or two sentences for the user, including the reason. Reads the files that describe the active
    /// runtime if there is none.
    static QString textOf(const HeadsetStatus& status);

    /// Returns the message that the runtime refuses the present OpenGL version, which is earlier than the version it
    /// asks for.
    static QString openGlRefusal(const QString& runtime, const QVersionNumber& asked, const QVersionNumber& present);
};
} // namespace vr
