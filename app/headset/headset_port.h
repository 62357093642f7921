#pragma once

#include "app/worker/sculpt_worker.h"

#include "vr/sculpt/document_port.h"

#include <QObject>

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace app
{
/// What a visit to the headset has left for the gui thread since it was last taken.
struct HeadsetMail
{
    std::deque<vr::DocumentRequest> wishes;
    std::optional<vr::AvatarState> presence; ///< the newest
    bool wasRefused = false;                 ///< a stroke, because somebody at the window has taken over
};

/// The document of one visit to the headset. Strokes go straight to the mesh thread, wishes to the gui thread. A stroke
/// that begins after a wish that changes or saves the model is held here until that is done, so that both come in the
/// order in which they were made, and nobody waits.
class HeadsetPort : public QObject, public vr::DocumentPort, public std::enable_shared_from_this<HeadsetPort>
{
    Q_OBJECT

public:
    /// The worker must outlive the gui thread's side. Gui thread.
    explicit HeadsetPort(SculptWorker* worker);

    // The gui thread's side.

    /// From now on the worker's patches and answers come here.
    void begin();
    /// A stroke that is open ends. What is held goes to the worker when its wish is done. Whatever the headset's thread
    /// calls from now on, as that of a visit that was given up may, comes to nothing.
    void end();
    void tell(vr::DocumentUpdate news);
    HeadsetMail takeMail();
    /// One more of the wishes that hold strokes (holdsStrokes).
    void wishDone();
    static bool holdsStrokes(const vr::DocumentRequest& wish);
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
    void querySurface(const vr::SurfaceQuery& question) override;
    std::optional<vr::SurfaceQueryResult> takeQueryResult() override;
    void request(const vr::DocumentRequest& wish) override;
    void show(const vr::AvatarState& presence) override;

Q_SIGNALS:
    /// Once until the mail is taken, on the headset's thread: connect it queued.
    void mailCame();

private:
    enum class Stroke { None, Posted, Held };

    struct HeldStroke
    {
        quint64 after; ///< so many wishes
        core::StrokeSettings settings;
        std::vector<core::StrokeSample> samples; ///< at most JobQueue::maxWaitingSamples
        bool hasEnded = false;
    };

    void ring(bool isNew);
    void keepAnswer(vr::SurfaceQueryResult answer);
    void keepEffect(quint64 fusions, core::Shortfall shortfall);
    void endOpenStroke();
    void postHeld();
    void post(const HeldStroke& stroke);
    static void thin(std::vector<core::StrokeSample>& samples);

    SculptWorker* m_worker;
    std::shared_ptr<PatchInbox> m_inbox = std::make_shared<PatchInbox>();
    QMetaObject::Connection m_answers, m_samples;

    std::mutex m_mutex; ///< of the rest
    std::optional<vr::DocumentUpdate> m_news;
    std::optional<vr::SurfaceQueryResult> m_answer;
    vr::StrokeEffect m_effect;
    HeadsetMail m_mail;
    bool m_hasRung = false;
    bool m_isRefusing = false, m_isTakenOver = false;
    bool m_hasEnded = false;
    quint64 m_wished = 0, m_done = 0; ///< of the wishes that hold strokes
    Stroke m_open = Stroke::None;
    std::deque<HeldStroke> m_held;
};
} // namespace app
