#include "app/worker/drawing_worker.h"

#include "app/worker/sculpt_worker.h"

#include "core/sculpt/sculptor.h"
#include "core/util/file_error.h"
#include "ui/drawing/drawing_sheet.h"
#include "ui/util/error_messages.h"

#include <QFileInfo>

#include <chrono>
#include <utility>

namespace app
{
namespace
{
constexpr auto idleDelay = std::chrono::milliseconds(250); ///< time without changes before the fine drawing is made
constexpr std::size_t maxEdges = 300'000, maxInterimEdges = 40'000;
constexpr int finePixels = 2048, shadedPixels = 1024, interimPixels = 640; ///< size of the drawing's longer side

double msSince(std::int64_t start)
{
    return static_cast<double>(steadyNs() - start) * 1e-6;
}
} // namespace

DrawingWorker::DrawingWorker(SculptWorker* worker, QObject* parent)
    : QObject(parent)
    , m_worker(worker)
    , m_thread([this] { run(); })
{}

DrawingWorker::~DrawingWorker()
{
    m_worker->setInbox(Source::Drawings, nullptr);
    {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->isStopping = true;
        m_shared->stop.request_stop();
        m_shared->stopFine.request_stop();
    }
    m_shared->wake.notify_all();
    m_thread.join();
}

double DrawingWorker::latencyMs() const
{
    const std::lock_guard lock(m_shared->mutex);
    return m_shared->latencyMs;
}

void DrawingWorker::watch(bool isSeen, bool shaded)
{
    {
        const std::lock_guard lock(m_shared->mutex);
        if (isSeen == m_shared->isSeen && shaded == m_shared->shaded)
            return;
        m_shared->shaded = shaded;
        m_shared->hasChanged = true;
        m_shared->stop.request_stop();
        m_shared->stopFine.request_stop();
        if (isSeen != m_shared->isSeen) {
            m_shared->isSeen = isSeen;
            m_shared->inbox = isSeen ? std::make_shared<PatchInbox>() : nullptr;
            m_shared->hasPatch = false;
            if (isSeen)
                connect(
                    m_shared->inbox.get(), &PatchInbox::filled, m_shared->inbox.get(),
                    [shared = std::weak_ptr(m_shared)] { onPatch(shared); }, Qt::DirectConnection);
            m_worker->setInbox(Source::Drawings, m_shared->inbox);
        }
    }
    m_shared->wake.notify_all();
}

void DrawingWorker::exportTo(const QString& path, const QString& modelName, bool shaded)
{
    if (!ui::drawingEndings().contains(QFileInfo(path).suffix().toLower())) {
        Q_EMIT refused(ui::ErrorMessages::notADrawing(path));
        return;
    }
    m_worker->post(
        [shared = m_shared, request = Request{path, modelName, shaded, {}}](const core::Sculptor& sculptor) mutable {
            request.model = sculptor.wholePatch();
            const std::lock_guard lock(shared->mutex);
            shared->requests.push_back(std::move(request));
            shared->wake.notify_all();
        });
}

/// Called on the mesh thread.
void DrawingWorker::onPatch(const std::weak_ptr<SharedState>& weak)
{
    if (const auto shared = weak.lock()) {
        const std::lock_guard lock(shared->mutex);
        shared->hasPatch = true;
        shared->changedNs = shared->changedNs != 0 ? shared->changedNs : steadyNs();
        shared->stopFine.request_stop();
        shared->wake.notify_all();
    }
}

void DrawingWorker::run()
{
    std::unique_lock lock(m_shared->mutex);
    while (wait(lock)) {
        if (!m_shared->requests.empty()) {
            const Request request = std::move(m_shared->requests.front());
            m_shared->requests.pop_front();
            lock.unlock();
            write(request);
        } else {
            lock.unlock();
            draw();
        }
        lock.lock();
    }
}

/// Waits until there is work, or until a fine drawing is due. Returns false when the thread has to end.
bool DrawingWorker::wait(std::unique_lock<std::mutex>& lock)
{
    const auto isAwake = [this] {
        return m_shared->isStopping || m_shared->hasPatch || m_shared->hasChanged || !m_shared->requests.empty();
    };
    if (m_isFine)
        m_shared->wake.wait(lock, isAwake);
    else
        m_shared->wake.wait_for(lock, idleDelay, isAwake);
    return !m_shared->isStopping;
}

void DrawingWorker::draw()
{
    const Assignment assignment = takeAssignment();
    if (assignment.inbox != std::exchange(m_inbox, assignment.inbox)) {
        m_incremental.reset();
        m_changedNs = 0;
    }
    m_isFine = true;
    if (!m_inbox)
        return;
    if (!m_incremental)
        m_incremental.emplace(interimPixels, maxInterimEdges);
    const auto patch = m_inbox->take();
    if (patch) {
        m_incremental->apply(*patch);
        if (patch->sampledNs != 0 && m_changedNs == 0)
            m_changedNs = assignment.changedNs;
    }
    if (m_incremental->model().faces.empty())
        return;
    if (patch || assignment.hasChanged)
        show(m_incremental->draw(assignment.shaded, assignment.stop), false);
    else
        show(core::drawLines(m_incremental->model(),
                             {assignment.shaded ? shadedPixels : finePixels, assignment.shaded, maxEdges},
                             assignment.stopFine),
             true);
}

DrawingWorker::Assignment DrawingWorker::takeAssignment()
{
    const std::lock_guard lock(m_shared->mutex);
    m_shared->hasPatch = false;
    m_shared->stop = {};
    m_shared->stopFine = {};
    return {m_shared->inbox,
            m_shared->shaded,
            std::exchange(m_shared->hasChanged, false),
            std::exchange(m_shared->changedNs, 0),
            m_shared->stop.get_token(),
            m_shared->stopFine.get_token()};
}

/// Emits the drawing. An empty `drawing` was cancelled, because something newer has to be drawn.
void DrawingWorker::show(std::optional<core::LineDrawing> drawing, bool isFine)
{
    m_isFine = drawing && isFine;
    if (!drawing)
        return;
    drawing->isInterim = !isFine;
    if (m_changedNs != 0) {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->latencyMs = msSince(std::exchange(m_changedNs, 0));
    }
    m_mailbox.post(
        [this, result = std::make_shared<const core::LineDrawing>(*std::move(drawing))] { Q_EMIT drawn(result); });
}

void DrawingWorker::write(const Request& request)
{
    core::DrawArrays model;
    model.apply(request.model);
    auto drawing = core::drawLines(model, ui::sheetDetail(request.shaded), {});
    try {
        ui::writeSheet(request.path.toStdU16String(),
                       {request.modelName, QDate::currentDate(), *std::move(drawing), request.shaded});
        m_mailbox.post(
            [this, path = request.path] { Q_EMIT noticed(tr("Saved %1.").arg(QFileInfo(path).fileName())); });
    } catch (const core::FileError& error) {
        m_mailbox.post([this, sentence = ui::ErrorMessages::sentence(error)] { Q_EMIT refused(sentence); });
    }
}
} // namespace app
