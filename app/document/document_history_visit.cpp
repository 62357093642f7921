// Going back through the document's steps on a copy.

#include "app/document/document.h"

#include "app/model/model_change_job.h"

#include <chrono>
#include <future>
#include <utility>

namespace app
{
namespace
{
constexpr std::chrono::milliseconds pollInterval(50); ///< between two looks whether it was stopped
} // namespace

bool Document::visitHistory(const QString& what, Visit look, std::function<void()> done)
{
    if (m_job.isBusy())
        return false;
    const core::JobControl control = m_job.beginCancellable(what);
    request([this, look = std::move(look), done = std::move(done), control] { startVisit(look, done, control); });
    return true;
}

void Document::startVisit(const Visit& look, const std::function<void()>& done, const core::JobControl& control)
{
    if (!m_worker->hold()) // another hand was faster
        return request([this, look, done, control] { startVisit(look, done, control); });
    m_isChanging = true; // what is asked for waits
    ModelHistory history{nullptr, m_history.firstIndex(), m_stack.index(), {}};
    std::vector<std::shared_ptr<StoredDelta>> changes;
    for (int i = history.first; i < history.present; ++i)
        changes.push_back(m_history.at(i));
    history.change = [worker = m_worker, changes, first = history.first,
                      stop = control.stop](int index) -> std::optional<core::MeshDelta> {
        auto answer = std::make_shared<std::promise<std::optional<core::MeshDelta>>>();
        auto copied = answer->get_future();
        const auto change = changes.at(static_cast<std::size_t>(index - first));
        worker->post([answer = std::move(answer), change](core::Sculptor&) { answer->set_value(change->copy()); });
        while (copied.wait_for(pollInterval) != std::future_status::ready)
            if (stop.stop_requested()) // the mesh thread may have ended
                return std::nullopt;
        return copied.get();
    };
    m_worker->post([this, look, done, control, history](core::Sculptor& sculptor) mutable {
        history.mesh = ModelChangeJob::copyOf(sculptor.mesh());
        auto work = [look, history, control] {
            look(history, control);
            return 0;
        };
        m_job.run(std::move(work), [this, done](int) {
            m_job.commit();
            m_job.end();
            m_isChanging = false;
            m_worker->release();
            done();
            notifyStateChanged();
            runRequests();
        });
    });
}
} // namespace app
