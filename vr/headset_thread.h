#pragma once

#include "frame_client.h"
#include "headset_report.h"

#include <QObject>

#include <deque>
#include <memory>
#include <mutex>
#include <thread>

namespace vr
{
class GlContext;
class LeaveBell;

/// Enters the headset and leaves it, any number of times: each visit has a thread, an OpenGL context and an OpenXR session of its own, and
/// leaves none of them behind. All on the thread that made this one, which has to be the gui's.
class HeadsetThread : public QObject
{
    Q_OBJECT

public:
    explicit HeadsetThread(QObject* parent = nullptr);
    /// Leaves, and waits for the end.
    ~HeadsetThread() override;

    /// Returns at once; reported() tells how it goes. False, and nothing happens, while there is a visit that has not ended. The client is
    /// used on the visit's thread until it has ended.
    bool enter(std::shared_ptr<FrameClient> client);
    /// Returns at once; reported() tells of the end.
    void leave();
    bool isIn() const { return m_visit != nullptr; }

    /// Of this visit, or of the last.
    const FrameCosts& costs() const { return *m_costs; }

Q_SIGNALS:
    /// The last one of each visit has ended; then VR can be entered again, from here too.
    void reported(const vr::HeadsetReport& report);

private:
    struct Visit;

    HeadsetReport run(Visit& visit);
    HeadsetReport runWith(Visit& visit);
    void post(const HeadsetReport& report);
    Q_INVOKABLE void open();

    std::shared_ptr<FrameCosts> m_costs;
    std::unique_ptr<Visit> m_visit;
    std::mutex m_mutex; ///< of the next
    std::deque<HeadsetReport> m_reports;
    std::thread m_thread; ///< last: it uses the others
};
} // namespace vr
