#pragma once

#include "vr/frame/frame_client.h"
#include "vr/frame/headset_report.h"
#include "vr/openxr/runtime_thread.h"

#include <QTimer>

namespace vr
{
/// Enters the headset and leaves it, any number of times: each visit has a thread, an OpenGL context and an OpenXR
/// session of its own, and leaves none of them behind. All on the thread that made this one, which has to be the gui's.
///
/// A visit that was to be left and has not ended in time, because the headset's program does not answer, is abandoned:
/// it counts as ended, and when that program wakes it ends by itself, which nobody is told of.
class HeadsetThread : public QObject
{
    Q_OBJECT

public:
    /// `exitTimeout`: the time that a visit has to end.
    explicit HeadsetThread(std::chrono::milliseconds exitTimeout = RuntimeThread::responseTimeout,
                           QObject* parent = nullptr);
    /// Leaves, and waits for the end until that timeout. What then goes on goes on without this: see RuntimeThread.
    ~HeadsetThread() override;

    /// Returns at once; reported() tells how it goes. False, and nothing happens, while there is a visit that has not
    /// ended, abandoned or not. The client is used on the visit's thread until it has ended.
    bool enter(std::shared_ptr<FrameClient> client);
    /// Returns at once; reported() tells of the end, and of nothing before it.
    void leave();
    /// A visit has begun, and its end was not told.
    bool isActive() const { return m_visit && !m_isAbandoned; }
    /// A visit was abandoned and has not ended: VR cannot be entered.
    bool isStuck() const { return m_visit && m_isAbandoned; }

    /// Of this visit, or of the last.
    const FrameTimings& timings() const { return *m_timings; }

Q_SIGNALS:
    /// The last one of each visit has ended; then VR can be entered again, from here too, unless isStuck().
    void reported(const vr::HeadsetReport& report);

private:
    struct Visit;

    void handleReport(const HeadsetReport& report);
    void abandon();
    void finish();

    std::shared_ptr<FrameTimings> m_timings;
    std::shared_ptr<Visit> m_visit; ///< its thread's, too
    bool m_isLeaving = false;
    bool m_isAbandoned = false;
    QTimer m_exitTimer;     ///< runs while we leave
    RuntimeThread m_thread; ///< last
};
} // namespace vr
