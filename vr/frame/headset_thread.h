#pragma once

#include "vr/frame/frame_client.h"
#include "vr/frame/headset_report.h"
#include "vr/openxr/runtime_thread.h"

#include <QTimer>

namespace vr
{
/// Enters and leaves VR any number of times. Each visit has its own thread, OpenGL context and OpenXR session, and
/// leaves none of them behind.
///
/// A visit that does not end in time after leave(), because the runtime does not answer, is abandoned: it counts as
/// ended. If the runtime answers later, the visit ends without a report.
///
/// Thread: the gui thread, which also made this object.
class HeadsetThread : public QObject
{
    Q_OBJECT

public:
    /// `exitTimeout`: time that a visit has to end after leave().
    explicit HeadsetThread(std::chrono::milliseconds exitTimeout = RuntimeThread::responseTimeout,
                           QObject* parent = nullptr);
    /// Leaves VR and waits for the visit's end, at most for the exit timeout. A visit that has not ended by then is
    /// detached: see RuntimeThread.
    ~HeadsetThread() override;

    /// Starts a visit and returns at once; reported() reports its progress. Returns false, and does nothing, while an
    /// earlier visit has not ended, abandoned or not. The visit's thread uses `client` until the visit has ended.
    bool enter(std::shared_ptr<FrameClient> client);
    /// Asks the visit to end and returns at once. From then on reported() reports only the end.
    void leave();
    /// Returns whether a visit has begun and its end is not reported yet.
    bool isActive() const { return m_visit && !m_isAbandoned; }
    /// Returns whether an abandoned visit has not ended. VR cannot be entered then.
    bool isStuck() const { return m_visit && m_isAbandoned; }

    /// Returns the timings of the current visit, or else of the last one.
    const FrameTimings& timings() const { return *m_timings; }

Q_SIGNALS:
    /// Reports the progress of a visit. The last report of a visit has isEnded(); VR can then be entered again, even
    /// from the slot, unless isStuck().
    void reported(const vr::HeadsetReport& report);

private:
    struct Visit;

    void handleReport(const HeadsetReport& report);
    void abandon();
    void finish();

    std::shared_ptr<FrameTimings> m_timings;
    std::shared_ptr<Visit> m_visit; ///< shared with the visit's thread
    bool m_isLeaving = false;
    bool m_isAbandoned = false;
    QTimer m_exitTimer;     ///< runs from leave() to the end of the visit
    RuntimeThread m_thread; ///< declared last, so that it is destroyed first
};
} // namespace vr
