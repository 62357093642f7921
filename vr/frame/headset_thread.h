#pragma once

#include "vr/frame/frame_client.h"
#include "vr/frame/headset_report.h"
#include "vr/openxr/runtime_thread.h"

#include <QTimer>

namespace vr
{
/// Enters the headset and leaves it, any number of times: each visit has a thread, an OpenGL context and an OpenXR session of its own, and
/// leaves none of them behind. All on the thread that made this one, which has to be the gui's.
///
/// A visit that was to be left and has not ended in time, because the headset's program does not answer, is given up: it counts as ended,
/// and when that program wakes it ends by itself, which nobody is told of.
class HeadsetThread : public QObject
{
    Q_OBJECT

public:
    /// `patience`: with a visit that is to end.
    explicit HeadsetThread(std::chrono::milliseconds patience = RuntimeThread::patience, QObject* parent = nullptr);
    /// Leaves, and waits for the end while there is patience. What then goes on goes on without this: see RuntimeThread.
    ~HeadsetThread() override;

    /// Returns at once; reported() tells how it goes. False, and nothing happens, while there is a visit that has not ended, given up or
    /// not. The client is used on the visit's thread until it has ended.
    bool enter(std::shared_ptr<FrameClient> client);
    /// Returns at once; reported() tells of the end, and of nothing before it.
    void leave();
    /// A visit has begun, and its end was not told.
    bool isIn() const { return m_visit && !m_isGivenUp; }
    /// A visit was given up and has not ended: VR cannot be entered.
    bool isStuck() const { return m_visit && m_isGivenUp; }

    /// Of this visit, or of the last.
    const FrameCosts& costs() const { return *m_costs; }

Q_SIGNALS:
    /// The last one of each visit has ended; then VR can be entered again, from here too, unless isStuck().
    void reported(const vr::HeadsetReport& report);

private:
    struct Visit;

    void take(const HeadsetReport& report);
    void giveUp();
    void finish();

    std::shared_ptr<FrameCosts> m_costs;
    std::shared_ptr<Visit> m_visit; ///< its thread's, too
    bool m_isLeaving = false;
    bool m_isGivenUp = false;
    QTimer m_patience;      ///< runs while we leave
    RuntimeThread m_thread; ///< last
};
} // namespace vr
