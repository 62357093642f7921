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
/// Messages that a headset visit sends to the gui thread, collected until they are taken.
struct HeadsetMessages
{
    std::deque<vr::DocumentRequest> requests;
    std::optional<vr::AvatarState> avatar; ///< the latest state
    bool wasRefused = false;               ///< whether a stroke was refused because the desktop user has taken over
};

/// The document of one visit to the headset. Strokes are posted directly to the mesh thread, requests to the gui
/// thread. A stroke that begins after a request that changes or saves the model is held here until that request is
/// done. Strokes and requests thus arrive in the order in which they were made, and no thread blocks.
class HeadsetPort : public QObject, public vr::DocumentPort, public std::enable_shared_from_this<HeadsetPort>
{
    Q_OBJECT

public:
    /// Precondition: the worker exists during every call of the functions for the gui thread. Thread: gui.
    explicit HeadsetPort(SculptWorker* worker);

    // Functions for the gui thread.

    /// Begins to receive the worker's patches and answers.
    void begin();
    /// Ends an open stroke. Held strokes are posted when their request is done. Later calls by the headset's thread,
    /// which may belong to an abandoned visit, have no effect.
    void end();
    void setUpdate(vr::DocumentUpdate update);
    HeadsetMessages takeMessages();
    /// Records that a request with holdsStrokes() is done, and posts the strokes that waited only for it.
    void requestDone();
    /// Returns whether strokes that begin later are held until the request is done.
    static bool holdsStrokes(const vr::DocumentRequest& request);
    /// Sets whether strokes are refused, because another model is being opened, or a change is only previewed.
    void setRefusing(bool refuses);
    /// Sets whether the desktop user has taken over. No stroke then begins, and an open stroke ends, keeping its dabs.
    /// Strokes held earlier are still done.
    void setTakenOver(bool isTakenOver);

    // Functions for the headset's thread.

    std::optional<core::MeshPatch> takePatch() override;
    std::optional<vr::DocumentUpdate> takeUpdate() override;
    bool beginStroke(const core::StrokeSettings& settings) override;
    void addSample(const core::StrokeSample& sample) override;
    void endStroke() override;
    vr::StrokeEffect takeEffect() override;
    void querySurface(const vr::SurfaceQuery& query) override;
    std::optional<vr::SurfaceQueryResult> takeQueryResult() override;
    void queryPart() override;
    std::optional<vr::MovablePart> takePart() override;
    void request(const vr::DocumentRequest& request) override;
    bool isSettled() override;
    void show(const vr::AvatarState& avatar) override;

Q_SIGNALS:
    /// Emitted for the first request or avatar after takeMessages(). Thread: the headset's; use a queued connection.
    void messagesArrived();

private:
    enum class Stroke { None, Posted, Held };

    struct HeldStroke
    {
        quint64 after; ///< value of m_done from which the stroke can be posted
        core::StrokeSettings settings;
        std::vector<core::StrokeSample> samples; ///< at most JobQueue::maxWaitingSamples samples
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

    std::mutex m_mutex; ///< guards the following members
    std::optional<vr::DocumentUpdate> m_update;
    std::optional<vr::SurfaceQueryResult> m_queryResult;
    std::optional<vr::MovablePart> m_movablePart;
    vr::StrokeEffect m_effect;
    HeadsetMessages m_messages;
    bool m_isNotified = false;
    bool m_isRefusing = false, m_isTakenOver = false;
    bool m_hasEnded = false;
    quint64 m_requested = 0, m_done = 0; ///< requests that hold strokes: number received, and number done
    Stroke m_open = Stroke::None;
    std::deque<HeldStroke> m_held;
};
} // namespace app
