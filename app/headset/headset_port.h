#pragma once

#include "app/worker/sculpt_worker.h"

#include "vr/sculpt/document_port.h"

#include <QObject>

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace app
{
/// Messages of a visit to the gui thread since they were last taken.
struct HeadsetMessages
{
    std::deque<vr::DocumentRequest> requests;
    std::optional<vr::AvatarState> avatar; ///< the newest
    bool wasRefused = false;               ///< a stroke, because somebody at the window has taken over
};

/// The document of one visit to the headset. Strokes go straight to the mesh thread, requests to the gui thread. A
/// stroke that begins after a request that changes or saves the model is held here until the request is done, so that
/// both arrive in the order in which they were made; nobody waits.
class HeadsetPort : public QObject, public vr::DocumentPort, public std::enable_shared_from_this<HeadsetPort>
{
    Q_OBJECT

public:
    /// The worker must outlive the gui thread's side. Thread: gui.
    explicit HeadsetPort(SculptWorker* worker);

    // The gui thread's side.

    /// From now on the worker's patches and answers come here.
    void begin();
    /// A stroke that is open ends. Held strokes go to the worker when their request is done. Later calls by the
    /// headset's thread, as from an abandoned visit, have no effect.
    void end();
    void setUpdate(vr::DocumentUpdate update);
    HeadsetMessages takeMessages();
    /// One more request that holds strokes (holdsStrokes) is done.
    void requestDone();
    static bool holdsStrokes(const vr::DocumentRequest& request);
    /// While another model is on its way: no stroke begins.
    void setRefusing(bool refuses);
    /// While somebody at the window has taken over: no stroke begins, and an open one ends as it is. What was drawn
    /// before is done all the same.
    void setTakenOver(bool isTakenOver);

    // The headset's thread.

    std::optional<core::MeshPatch> takePatch() override;
    std::optional<vr::DocumentUpdate> takeUpdate() override;
    bool beginStroke(const core::StrokeSettings& settings) override;
    void addSample(const core::StrokeSample& sample) override;
    void endStroke() override;
    vr::StrokeEffect takeEffect() override;
    void querySurface(const vr::SurfaceQuery& query) override;
    std::optional<vr::SurfaceQueryResult> takeQueryResult() override;
    void request(const vr::DocumentRequest& request) override;
    void show(const vr::AvatarState& avatar) override;

Q_SIGNALS:
    /// Emitted once until the messages are taken, on the headset's thread: connect it queued.
    void messagesArrived();

private:
    enum class Stroke { None, Posted, Held };

    struct HeldStroke
    {
        quint64 after; ///< that many requests
        core::StrokeSettings settings;
        std::vector<core::StrokeSample> samples; ///< at most JobQueue::maxWaitingSamples
        bool hasEnded = false;
    };

    void send(const std::function<void()>& write);
    void endOpenStroke();
    void postHeld();
    void post(const HeldStroke& stroke);
    static void thin(std::vector<core::StrokeSample>& samples);

    SculptWorker* m_worker;
    std::shared_ptr<PatchInbox> m_inbox = std::make_shared<PatchInbox>();
    QMetaObject::Connection m_queryConnection, m_sampleConnection;

    std::mutex m_mutex; ///< of the rest
    std::optional<vr::DocumentUpdate> m_update;
    std::optional<vr::SurfaceQueryResult> m_queryResult;
    vr::StrokeEffect m_effect;
    HeadsetMessages m_messages;
    bool m_isNotified = false;
    bool m_isRefusing = false, m_isTakenOver = false;
    bool m_hasEnded = false;
    quint64 m_requested = 0, m_done = 0; ///< requests that hold strokes
    Stroke m_open = Stroke::None;
    std::deque<HeldStroke> m_held;
};
} // namespace app
