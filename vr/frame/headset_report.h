#pragma once

#include <QCoreApplication>
#include <QString>

namespace vr
{
/// The stage of a visit to VR.
enum class HeadsetStage {
    Starting, ///< the runtime is starting, or the session has not begun yet
    Hidden,   ///< the session runs, but the headset shows another program
    Visible,  ///< the headset shows Fettle, but the runtime's menu is open and has the wands
    Running,  ///< the headset shows Fettle, and Fettle has the wands
    TakenOff, ///< the headset is not worn; nothing is drawn until it is put on again
    Ended
};

/// The reason for the end of a visit.
enum class HeadsetEnd {
    Left,               ///< Fettle asked for the end
    EndedByRuntime,     ///< the runtime asked for the end
    Unavailable,        ///< no runtime, no headset, or a runtime that accepts no pictures of this OpenGL
    NoBinding,          ///< the runtime does not support OpenGL contexts of this window system
    CannotRender,       ///< FrameClient::create() failed
    RuntimeLost,        ///< the runtime has stopped or restarts
    SessionLost,        ///< the session is lost, for example because the headset is unplugged
    NotResponding,      ///< Fettle asked for the end, and the runtime did not answer in time
    StillNotResponding, ///< an earlier visit still does not respond, so this one could not begin
    Failed
};

struct HeadsetReport
{
    Q_DECLARE_TR_FUNCTIONS(vr::HeadsetReport)

public:
    HeadsetStage stage = HeadsetStage::Starting;
    HeadsetEnd end = HeadsetEnd::Left; ///< valid if the stage is Ended
    QString text;                      ///< one or two sentences for the user

    static HeadsetReport of(HeadsetStage stage, const QString& headset);
    /// `detail`: for Unavailable the whole text, for NoBinding the platform's name, for Failed the call that failed.
    static HeadsetReport ended(HeadsetEnd end, const QString& detail = {});

    bool isEnded() const { return stage == HeadsetStage::Ended; }

private:
    static QString textOf(HeadsetEnd end, const QString& detail);
};
} // namespace vr
