#include "app/worker/drawing_worker.h"

#include "app/worker/sculpt_worker.h"

#include "core/util/file_error.h"
#include "ui/drawing/drawing_sheet.h"
#include "ui/util/error_messages.h"

#include <QDir>
#include <QFileInfo>

#include <chrono>
#include <utility>

namespace app
{
namespace
{
constexpr auto rest = std::chrono::milliseconds(250); ///< without a change: the fine drawing is made
constexpr std::size_t maxEdges = 300'000, mostInterimEdges = 40'000;
constexpr int finePixels = 2048, shadedPixels = 1024, interimPixels = 640; ///< along the longest side

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
        const std::lock_guard lock(m_desk->mutex);
        m_desk->isStopping = true;
        m_desk->stop.request_stop();
        m_desk->stopFine.request_stop();
    }
    m_desk->wake.notify_all();
    m_thread.join();
}

double DrawingWorker::latencyMs() const
{
    const std::lock_guard lock(m_desk->mutex);
    return m_desk->latencyMs;
}

void DrawingWorker::watch(bool isSeen, bool shaded)
{
    {
        const std::lock_guard lock(m_desk->mutex);
        if (isSeen == m_desk->isSeen && shaded == m_desk->shaded)
            return;
        m_desk->shaded = shaded;
        m_desk->hasNews = true;
        m_desk->stop.request_stop();
        m_desk->stopFine.request_stop();
        if (isSeen != m_desk->isSeen) {
            m_desk->isSeen = isSeen;
            m_desk->inbox = isSeen ? std::make_shared<PatchInbox>() : nullptr;
            m_desk->hasPatch = false;
            if (isSeen)
                connect(
                    m_desk->inbox.get(), &PatchInbox::filled, m_desk->inbox.get(),
                    [desk = std::weak_ptr(m_desk)] { tellOfPatch(desk); }, Qt::DirectConnection);
            m_worker->setInbox(Source::Drawings, m_desk->inbox);
        }
    }
    m_desk->wake.notify_all();
}

void DrawingWorker::exportTo(const QString& path, const QString& modelName, bool shaded)
{
    if (!ui::drawingEndings().contains(QFileInfo(path).suffix().toLower())) {
        Q_EMIT refused(ui::ErrorMessages::notADrawing(path));
        return;
    }
    m_worker->post([desk = m_desk, order = Order{path, modelName, shaded, {}}](const core::Sculptor& sculptor) mutable {
        order.model = sculptor.wholePatch();
        const std::lock_guard lock(desk->mutex);
        desk->orders.push_back(std::move(order));
        desk->wake.notify_all();
    });
}

/// On the mesh thread.
void DrawingWorker::tellOfPatch(const std::weak_ptr<Desk>& weak)
{
    if (const auto desk = weak.lock()) {
        const std::lock_guard lock(desk->mutex);
        desk->hasPatch = true;
        desk->changedNs = desk->changedNs != 0 ? desk->changedNs : steadyNs();
        desk->stopFine.request_stop();
        desk->wake.notify_all();
    }
}

void DrawingWorker::run()
{
    std::unique_lock lock(m_desk->mutex);
    while (wait(lock)) {
        if (!m_desk->orders.empty()) {
            const Order order = std::move(m_desk->orders.front());
            m_desk->orders.pop_front();
            lock.unlock();
            write(order);
        } else {
            lock.unlock();
            draw();
        }
        lock.lock();
    }
}

/// For something to do, or for a coarse drawing's finer one; false when all ends.
bool DrawingWorker::wait(std::unique_lock<std::mutex>& lock)
{
    const auto isAwake = [this] {
        return m_desk->isStopping || m_desk->hasPatch || m_desk->hasNews || !m_desk->orders.empty();
    };
    if (m_isFine)
        m_desk->wake.wait(lock, isAwake);
    else
        m_desk->wake.wait_for(lock, rest, isAwake);
    return !m_desk->isStopping;
}

void DrawingWorker::draw()
{
    const Turn turn = takeTurn();
    if (turn.inbox != std::exchange(m_inbox, turn.inbox)) {
        m_drawer.reset();
        m_changedNs = 0;
    }
    m_isFine = true;
    if (!m_inbox)
        return;
    if (!m_drawer)
        m_drawer.emplace(interimPixels, mostInterimEdges);
    const auto patch = m_inbox->take();
    if (patch) {
        m_drawer->apply(*patch);
        if (patch->sampledNs != 0 && m_changedNs == 0)
            m_changedNs = turn.changedNs;
    }
    if (m_drawer->model().faces.empty())
        return;
    if (patch || turn.hasNews)
        show(m_drawer->draw(turn.shaded, turn.stop), false);
    else
        show(core::drawLines(m_drawer->model(), {turn.shaded ? shadedPixels : finePixels, turn.shaded, maxEdges},
                             turn.stopFine),
             true);
}

DrawingWorker::Turn DrawingWorker::takeTurn()
{
    const std::lock_guard lock(m_desk->mutex);
    m_desk->hasPatch = false;
    m_desk->stop = {};
    m_desk->stopFine = {};
    return {m_desk->inbox,
            m_desk->shaded,
            std::exchange(m_desk->hasNews, false),
            std::exchange(m_desk->changedNs, 0),
            m_desk->stop.get_token(),
            m_desk->stopFine.get_token()};
}

/// If it was stopped, something newer is to be drawn.
void DrawingWorker::show(std::optional<core::LineDrawing> drawing, bool isFine)
{
    m_isFine = drawing && isFine;
    if (!drawing)
        return;
    drawing->isInterim = !isFine;
    if (m_changedNs != 0) {
        const std::lock_guard lock(m_desk->mutex);
        m_desk->latencyMs = msSince(std::exchange(m_changedNs, 0));
    }
    m_mail.post([this, made = std::make_shared<const core::LineDrawing>(*std::move(drawing))] { Q_EMIT drawn(made); });
}

void DrawingWorker::write(const Order& order)
{
    core::DrawArrays model;
    model.apply(order.model);
    auto drawing = core::drawLines(model, ui::sheetDetail(order.shaded), {});
    try {
        ui::writeSheet(order.path.toStdU16String(),
                       {order.modelName, QDate::currentDate(), *std::move(drawing), order.shaded});
        m_mail.post(
            [this, path = order.path] { Q_EMIT noticed(tr("%1 was written.").arg(QDir::toNativeSeparators(path))); });
    } catch (const core::FileError& error) {
        m_mail.post([this, sentence = ui::ErrorMessages::sentence(error)] { Q_EMIT refused(sentence); });
    }
}
} // namespace app
