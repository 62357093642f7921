#include "app/document/document.h"

#include "app/document/stroke_command.h"
#include "app/model/command_names.h"
#include "app/model/model_change_job.h"
#include "app/model/model_loader.h"
#include "app/worker/stroke_step.h"

#include "core/journal/journal.h"
#include "ui/util/error_messages.h"

#include <algorithm>
#include <utility>

namespace app
{
Document::Document(SculptWorker* worker, QObject* parent)
    : QObject(parent)
    , m_worker(worker)
    , m_history([worker](auto job) { worker->post(std::move(job)); })
{
    connect(&m_job, &BackgroundJob::busy, this, &Document::busy);
    connect(&m_job, &BackgroundJob::cancellable, this, &Document::cancellable);
    connect(&m_job, &BackgroundJob::progressed, this, &Document::progressed);
    connect(&m_job, &BackgroundJob::idle, this, &Document::idle);
    connect(&m_job, &BackgroundJob::idle, this, &Document::openWaiting, Qt::QueuedConnection);
    connect(worker, &SculptWorker::strokeFinished, this, &Document::onReport);
    connect(worker, &SculptWorker::modelSet, this, &Document::takeModel);
    connect(worker, &SculptWorker::confirmed, this, &Document::onConfirmed);
    connect(worker, &SculptWorker::factsChanged, this, &Document::takeFacts);
    connect(worker, &SculptWorker::strokeRefused, this, [this] {
        if (m_isChanging)
            Q_EMIT noticed(tr("Sculpting rests until the model is ready."));
    });
    connect(&m_stack, &QUndoStack::indexChanged, this, &Document::notifyStateChanged);
    connect(&m_stack, &QUndoStack::indexChanged, this, [this] { m_isDiscardAgreed = false; });
    connect(&m_stack, &QUndoStack::cleanChanged, this, &Document::notifyStateChanged);
    connect(&m_history, &HistoryStore::expired, this, &Document::notifyStateChanged);
    connect(&m_history, &HistoryStore::lost, this, &Document::loseHistory);
}

Document::~Document()
{
    m_job.cancel();
    m_worker->stop();
    m_stack.disconnect(this);
}

void Document::setDiscardPrompt(MayDiscard canDiscard)
{
    m_mayDiscard = std::move(canDiscard);
}

void Document::setCompleteMetadata(std::function<void(core::DocumentMetadata&)> complete)
{
    m_completeMetadata = std::move(complete);
}

bool Document::canDiscard(const std::function<void()>& proceed) const
{
    return !isModified() || !m_mayDiscard || m_mayDiscard(proceed);
}

// --- the whole model

void Document::apply(const core::ModelCommand& command)
{
    if (!m_job.isBusy())
        request([this, command] { startChange(command, {}); });
}

void Document::insert(const ui::InsertRequest& insertion)
{
    if (!m_job.isBusy())
        request([this, insertion] { startChange(core::Insert{{}, insertion.place, insertion.centre}, insertion); });
}

void Document::cancelJob()
{
    m_next.reset();
    m_job.cancel();
}

/// Until it is finished, strokes are refused and undo waits: the mesh stays the one that was copied.
void Document::startChange(core::ModelCommand command, const ui::InsertRequest& insertion)
{
    if (m_job.isBusy())
        return;
    if (!m_worker->hold()) // another hand was faster
        return request([this, command = std::move(command), insertion] { startChange(command, insertion); });
    if (auto* const reset = std::get_if<core::Reset>(&command))
        reset->start = m_start;
    m_isChanging = true;
    const core::JobControl control = m_job.beginCancellable(CommandNames::progress(command));
    m_worker->post([this, command = std::move(command), insertion, control](core::Sculptor& sculptor) {
        auto copy = ModelChangeJob::copyOf(sculptor.mesh());
        auto work = [this, copy = std::move(copy), command, insertion, control]() mutable {
            return ModelChangeJob::run(
                copy, command, insertion, [this](const QString& what) { m_job.rename(what); }, control);
        };
        m_job.run(std::move(work), [this, command, insertion](ModelChangeOutcome outcome) {
            finishChange(command, insertion, std::move(outcome));
        });
    });
}

void Document::finishChange(const core::ModelCommand& command, const ui::InsertRequest& insertion,
                            ModelChangeOutcome outcome)
{
    if (m_job.wasCancelled() || !outcome.change.changes)
        return endChange(command, insertion, outcome);
    m_job.commit();
    auto delta = std::make_shared<core::MeshDelta>(std::move(outcome.change.delta));
    const StepMarks marks{
        CommandNames::icon(command), 0, 0,
        std::make_shared<const core::FileEntry>(core::FileCommand{command, insertion.path.toStdString()})};
    m_worker->post([delta, step = StrokeStep::forJournal(CommandNames::name(command), marks),
                    journal = m_journal](core::Sculptor& sculptor) {
        sculptor.swap(*delta);
        if (journal)
            journal->changed(sculptor.mesh(), *delta, step);
    });
    whenRecorded([this, command, insertion, outcome = std::move(outcome), delta, marks] {
        const int index = m_stack.index();
        m_history.add(index, delta);
        m_stack.push(new StrokeCommand(CommandNames::name(command), marks, &m_history, index));
        m_lastReport.reset();
        Q_EMIT stepped(*marks.recordedStep);
        endChange(command, insertion, outcome);
    });
}

/// What was posted before is told of then: not before it would survive the program.
void Document::whenRecorded(std::function<void()> done)
{
    m_unconfirmed.push_back(std::move(done));
    m_worker->confirm();
}

void Document::onConfirmed()
{
    const auto done = std::move(m_unconfirmed.front());
    m_unconfirmed.pop_front();
    done();
}

void Document::endChange(const core::ModelCommand& command, const ui::InsertRequest& insertion,
                         const ModelChangeOutcome& outcome)
{
    m_isChanging = false;
    m_worker->release();
    m_job.end();
    if (!m_job.wasCancelled())
        reportOutcome(command, insertion, outcome);
    notifyStateChanged();
    runRequests();
}

void Document::reportOutcome(const core::ModelCommand& command, const ui::InsertRequest& insertion,
                             const ModelChangeOutcome& outcome)
{
    if (std::holds_alternative<core::Insert>(command) && outcome.isRepairable && !insertion.repair)
        return Q_EMIT insertionRepairable(insertion, outcome.problem);
    if (!outcome.problem.isEmpty())
        return Q_EMIT refused(outcome.problem);
    if (!outcome.change.changes)
        return Q_EMIT noticed(CommandNames::unchanged(command));
    if (!outcome.notice.isEmpty())
        Q_EMIT noticed(outcome.notice);
    if (!outcome.repairs.isEmpty())
        Q_EMIT insertedRepaired(QFileInfo(insertion.path).fileName(), outcome.repairs);
}

// --- strokes and history

void Document::beginStroke(const core::StrokeSettings& settings)
{
    m_strokeOpen = true;
    m_lastStep = StrokeStep::textOf(settings.tool);
    strokeRequest([this, settings] { m_worker->beginStroke(Source::Desktop, settings); });
    notifyStateChanged();
}

void Document::addSample(const core::StrokeSample& sample)
{
    strokeRequest([this, sample] { m_worker->addSample(Source::Desktop, sample); });
}

void Document::endStroke()
{
    strokeRequest([this] { m_worker->endStroke(Source::Desktop); });
    m_strokeOpen = false;
    std::move(m_afterStroke.begin(), m_afterStroke.end(), std::back_inserter(m_requests));
    m_afterStroke.clear();
    runRequests();
}

void Document::addSphere(const core::StrokeSettings& settings, const core::StrokeSample& sample)
{
    m_lastStep = StrokeStep::textOfAdding(settings.model != nullptr);
    strokeRequest([this, settings, sample] { m_worker->addSphere(Source::Desktop, settings, sample); });
    notifyStateChanged();
}

void Document::undo()
{
    request([this] {
        if (m_history.canUndo(m_stack.index()))
            moveTo(m_stack.index() - 1);
    });
}

void Document::redo()
{
    request([this] {
        if (m_stack.canRedo() && m_history.canRedo(m_stack.index()))
            moveTo(m_stack.index() + 1);
    });
}

void Document::goTo(int index)
{
    request([this, index] { moveTo(std::clamp(index, m_history.firstIndex(), m_history.lastIndex())); });
}

void Document::moveTo(int index)
{
    if (!m_worker->hold()) // another hand was faster
        return goTo(index);
    comeTo(index);
    m_worker->release();
}

void Document::comeTo(int index)
{
    ++m_moves;
    m_stack.setIndex(index);
    whenRecorded([this] {
        --m_moves;
        notifyStateChanged();
    });
}

/// What must see the model as all strokes before it left it.
void Document::request(std::function<void()> run)
{
    (m_strokeOpen ? m_afterStroke : m_requests).push_back({true, std::move(run)});
    runRequests();
}

void Document::strokeRequest(std::function<void()> run)
{
    m_requests.push_back({false, std::move(run)});
    runRequests();
}

void Document::runRequests()
{
    while (!m_requests.empty() &&
           !(m_requests.front().afterReports && (hasUnreported() || m_isInstalling || m_isChanging))) {
        const auto run = std::move(m_requests.front().run);
        m_requests.pop_front();
        run();
    }
}

bool Document::hasUnreported() const
{
    return m_reported < m_worker->strokesBegun();
}

void Document::onReport(const StrokeReport& report)
{
    ++m_reported;
    if (!m_isInstalling) {
        if (report.delta) {
            const int index = m_stack.index();
            m_history.add(index, report.delta);
            const StepDescription words = StrokeStep::descriptionOf(report);
            m_stack.push(new StrokeCommand(words.text, words.marks, &m_history, index));
            m_lastReport = report;
            m_lastReport->delta = nullptr;
            m_lastIndex = index;
            if (!report.isReplacement)
                countWork();
            Q_EMIT stepped(*report.recordedStep);
        }
        const bool isSeen = report.shortfall == core::Shortfall::Blocked && report.delta; // other dabs did something
        if (report.shortfall != core::Shortfall::None && !isSeen)
            Q_EMIT noticed(ui::ErrorMessages::shortfall(report.shortfall));
        else if (report.asymmetric)
            Q_EMIT noticed(ui::ErrorMessages::asymmetric());
        else if (report.sequential)
            Q_EMIT noticed(ui::ErrorMessages::sequentialSectors());
        takeFacts(report.facts);
        describeToJournal();
    }
    onStrokeReplaced(report);
    notifyStateChanged();
    runRequests();
}

void Document::countWork()
{
    core::WorkDone work = m_modelInfo.metadata.work.value_or(core::WorkDone());
    m_workTimer.count(work, steadyNs());
    m_modelInfo.metadata.work = work;
}

void Document::takeFacts(const MeshFacts& facts)
{
    m_modelInfo.vertices = facts.vertices;
    m_modelInfo.faces = facts.faces;
    m_modelInfo.box = facts.box;
    m_modelInfo.area = facts.area;
    m_modelInfo.uniformDetail = facts.uniformDetail;
    m_modelInfo.minDetail = facts.minDetail;
    m_modelInfo.size = facts.box.isEmpty() ? core::Vec3::Zero() : core::Vec3(facts.box.sizes());
    if (!m_isInstalling)
        Q_EMIT modelInfoChanged(m_modelInfo);
}

void Document::loseHistory()
{
    m_changedBeyondHistory = isModified();
    m_history.clear();
    m_stack.clear();
    m_lastReport.reset();
    m_isHistoryWhole = false;
    if (m_journal)
        m_worker->post([journal = m_journal](core::Sculptor&) { journal->forget(); });
    describeToJournal();
    notifyStateChanged();
    Q_EMIT refused(
        tr("The earlier steps cannot be undone any more: their file on disk cannot be read. The model is in order."));
}

bool Document::isModified() const
{
    return m_changedBeyondHistory || !m_stack.isClean() || hasUnreported();
}

bool Document::isSettled() const
{
    return !m_strokeOpen && m_requests.empty() && !hasUnreported() && !m_isChanging && m_moves == 0;
}

bool Document::canUndo() const
{
    return m_strokeOpen || hasUnreported() || m_history.canUndo(m_stack.index());
}

bool Document::canRedo() const
{
    return !m_strokeOpen && !hasUnreported() && m_stack.canRedo() && m_history.canRedo(m_stack.index());
}

QString Document::undoText() const
{
    if (!canUndo())
        return {};
    return m_strokeOpen || hasUnreported() ? m_lastStep : m_stack.undoText();
}

QString Document::redoText() const
{
    return canRedo() ? m_stack.redoText() : QString();
}

void Document::notifyStateChanged()
{
    Q_EMIT historyChanged();
    if (m_moves == 0 && std::exchange(m_toldModified, isModified()) != isModified())
        Q_EMIT modifiedChanged(m_toldModified);
}
} // namespace app
