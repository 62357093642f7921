#pragma once

#include <QCoreApplication>
#include <QString>

namespace vr
{
/// How far a visit to the headset is.
enum class HeadsetStage {
    Starting, ///< the runtime is asked, or lets us wait
    Hidden,   ///< it runs, and people see something else
    Visible,  ///< people see us, but the wands are the runtime's: its menu is open
    Running,  ///< all is ours
    TakenOff, ///< the headset rests; nothing is drawn until it is put on again
    Ended
};

/// Why it ended.
enum class HeadsetEnd {
    Left,               ///< we wanted it
    EndedByRuntime,     ///< the runtime wanted it
    Unavailable,        ///< no runtime, no headset, or one that takes no pictures of this OpenGL
    NoBinding,          ///< the window's OpenGL is of a kind that the runtime does not take
    CannotRender,       ///< the room cannot be drawn here
    RuntimeLost,        ///< or it restarts
    SessionLost,        ///< as when the headset is unplugged
    NotResponding,      ///< we wanted it, and the runtime did not answer in time
    StillNotResponding, ///< the same, at an earlier visit: this one could not begin
    Failed
};

struct HeadsetReport
{
    Q_DECLARE_TR_FUNCTIONS(vr::HeadsetReport)

public:
    HeadsetStage stage = HeadsetStage::Starting;
    HeadsetEnd end = HeadsetEnd::Left; ///< once it has ended
    QString text;                      ///< a sentence or two for people

    static HeadsetReport of(HeadsetStage stage, const QString& headset);
    /// `detail`: the whole text of Unavailable; a platform's name with NoBinding; the call that failed with Failed.
    static HeadsetReport ended(HeadsetEnd end, const QString& detail = {});

    bool isEnded() const { return stage == HeadsetStage::Ended; }

private:
    static QString textOf(HeadsetEnd end, const QString& detail);
};
} // namespace vr
