#include "app/classroom/class_work.h"

#include "app/document/document.h"

#include "ui/classroom/class_bar.h"

#include <QDir>
#include <QPointer>

#include <future>
#include <utility>

namespace app
{
namespace
{
constexpr int retryMs = 60'000;
} // namespace

ClassWork::ClassWork(Document* document, ui::ClassBar* bar, WorkArchive archive)
    : m_document(document)
    , m_bar(bar)
    , m_archive(std::move(archive))
{
    m_retryTimer.setSingleShot(true);
    connect(&m_retryTimer, &QTimer::timeout, this, [this] { deliver(); });
}

void ClassWork::begin()
{
    m_background.run([archive = m_archive] { archive.removeUnfinished(); });
    deliver();
}

bool ClassWork::save(const QString& what, const ClassTurn& turn, const TurnRecord& before, Done done)
{
    const auto ended = std::make_shared<EndedTurn>(EndedTurn{turn, {}, {}});
    const auto problem = std::make_shared<QString>();
    const auto save = [archive = m_archive, turn, before, ended, problem](const ModelSaver::Present& present) {
        const QDateTime end = turn.ended.isValid() ? turn.ended : QDateTime::currentDateTime();
        ended->record = joined(before, present.steps);
        TurnWork work{turn.id,      turn.pupil,   turn.begun,       end,          present.step,
                      present.mesh, present.hash, present.metadata, ended->record};
        if (turn.begun.isValid())
            work.usedMs = turn.usedMs;
        if (turn.lesson)
            work.lesson = LessonResult::of(*turn.lesson, *present.mesh);
        const ArchivedWork archived = archive.add(work);
        ended->folder = archived.folder;
        *problem = archived.problem;
        return archived.problem.isEmpty();
    };
    const auto finish = [self = QPointer(this), ended, problem, done = std::move(done)](bool) {
        if (!self)
            return;
        done(*ended, *problem);
        self->setPaused(false, self->m_isHeld);
        self->deliver();
    };
    setPaused(true, m_isHeld); // before the work is saved, because `done` may hold it
    if (m_document->saver().saveExternally(what, save, finish))
        return true;
    setPaused(false, m_isHeld);
    deliver();
    return false;
}

void ClassWork::setPaused(bool isSaving, bool isHeld)
{
    m_isSaving = isSaving;
    m_isHeld = isHeld;
    m_isPaused = isSaving || isHeld;
}

void ClassWork::deliver(const std::function<void()>& then)
{
    if (m_isPaused) {
        if (then)
            then();
        return;
    }
    const auto written = std::make_shared<std::promise<void>>();
    m_answering.run([written] { written->set_value(); }); // runs after the answers given so far are written
    const auto deliver = [this, archive = m_archive, written] {
        written->get_future().wait();
        return archive.deliver([this] { return m_isPaused.load(); });
    };
    m_background.run(deliver, [this, then](const Delivery& delivery) {
        onDelivered(delivery);
        if (then)
            then();
    });
    m_background.run([archive = m_archive] { return archive.pupilsOf(QDate::currentDate()); },
                     [this](const QStringList& pupils) { Q_EMIT pupilsFound(pupils); });
}

void ClassWork::copyWaiting(const QString& folder, const std::function<void(const Delivery& copied)>& done)
{
    // m_background may be waiting for a slow folder
    m_answering.run([archive = m_archive, folder] { return archive.copy(folder); }, done);
}

void ClassWork::setHeld(bool isHeld)
{
    setPaused(m_isSaving, isHeld);
    deliver();
}

void ClassWork::keepAnswers(const EndedTurn& ended, const ui::Questionnaire& answers)
{
    const auto keep = [archive = m_archive, folder = ended.folder, id = ended.turn.id, answers] {
        return archive.addAnswers(folder, {id, answers});
    };
    m_answering.run(keep, [this](const QString& problem) {
        if (!problem.isEmpty())
            Q_EMIT noticed(problem);
    });
}

void ClassWork::onDelivered(const Delivery& delivery)
{
    if (m_ended)
        m_ended->folder = delivery.moved.value(m_ended->folder, m_ended->folder);
    if (delivery.isPaused) // the next complete delivery reports the undelivered works
        return;
    m_bar->setUndelivered(
        delivery.undelivered,
        tr("%1 Until then they are in %2.").arg(delivery.problem, QDir::toNativeSeparators(m_archive.outbox())));
    m_problem = delivery.problem;
    const bool hasChanged = std::exchange(m_undelivered, delivery.undelivered) != delivery.undelivered;
    if (delivery.undelivered == 0)
        return;
    if (hasChanged)
        Q_EMIT noticed(tr("The class folder cannot be reached. The work is saved on this computer and will be moved "
                          "there as soon as possible."));
    m_retryTimer.start(retryMs);
}
} // namespace app
