#include "app/document/history_visit.h"

#include "app/document/document.h"
#include "app/model/model_change_job.h"
#include "app/model/model_history.h"
#include "app/worker/sculpt_worker.h"

#include "core/sculpt/sculptor.h"

#include <chrono>
#include <future>
#include <utility>

namespace app
{
namespace
{
constexpr std::chrono::milliseconds pollInterval(50); ///< interval for checking whether the visit was cancelled

struct VisitRequest
{
    Document* document;
    Visit visit;
    std::function<void()> done;
    core::JobControl control;
};

/// Returns the history without its mesh. Its changes are copied on the mesh thread when they are requested, one at a
/// time.
ModelHistory modelHistoryOf(Document& document, const std::stop_token& stop)
{
    HistoryStore& store = document.history().store();
    ModelHistory history{nullptr, store.firstIndex(), document.history().stack().index(), {}};
    std::vector<std::shared_ptr<StoredDelta>> changes;
    for (int i = history.first; i < history.present; ++i)
        changes.push_back(store.at(i));
    history.change = [worker = &document.worker(), changes, first = history.first,
                      stop](int index) -> std::optional<core::MeshDelta> {
        auto answer = std::make_shared<std::promise<std::optional<core::MeshDelta>>>();
        auto copied = answer->get_future();
        const auto change = changes.at(static_cast<std::size_t>(index - first));
        worker->post([answer = std::move(answer), change](core::Sculptor&) { answer->set_value(change->copy()); });
        while (copied.wait_for(pollInterval) != std::future_status::ready)
            if (stop.stop_requested()) // the mesh thread may have ended
                return std::nullopt;
        return copied.get();
    };
    return history;
}

void finish(const VisitRequest& request)
{
    Document& document = *request.document;
    document.job().commit();
    document.job().end();
    document.queue().setPause(DocumentQueue::Pause::None);
    document.worker().strokes().release();
    request.done();
    document.notifyStateChanged();
    document.queue().run();
}

void start(const VisitRequest& request)
{
    DocumentQueue& queue = request.document->queue();
    if (!queue.hold([request] { start(request); }))
        return;
    queue.setPause(DocumentQueue::Pause::Changing);
    request.document->worker().post(
        [request, history = modelHistoryOf(*request.document, request.control.stop)](core::Sculptor& sculptor) mutable {
            history.mesh = ModelChangeJob::copyOf(sculptor.mesh());
            auto work = [request, history] {
                request.visit(history, request.control);
                return 0;
            };
            request.document->job().run(std::move(work), [request](int) { finish(request); });
        });
}
} // namespace

bool visitHistory(Document& document, const QString& what, Visit visit, std::function<void()> done)
{
    BackgroundJob& job = document.job();
    if (job.isBusy())
        return false;
    const VisitRequest request{&document, std::move(visit), std::move(done), job.beginCancellable(what)};
    document.queue().enqueue([request] { start(request); });
    return true;
}
} // namespace app
