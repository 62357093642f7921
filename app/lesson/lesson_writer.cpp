#include "app/lesson/lesson_writer.h"

#include "app/document/document.h"
#include "app/lesson/lesson_model.h"
#include "app/lesson/lesson_recorder.h"
#include "app/lesson/lesson_saving.h"
#include "app/model/model_loader.h"
#include "app/worker/sculpt_worker.h"

#include "core/mesh/mesh.h"
#include "core/sculpt/sculptor.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/window/main_window.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace app
{
namespace
{
constexpr qsizetype maxRemarks = 8; ///< largest number of remarks shown
} // namespace

LessonWriter::LessonWriter(ui::MainWindow& window, Document& document, const core::LessonDraft* draft,
                           const LessonRecorder* recorder)
    : m_window(&window)
    , m_document(&document)
    , m_draft(draft)
    , m_recorder(recorder)
{}

void LessonWriter::save(const QString& before)
{
    m_window->viewport()->input()->finish();
    const QString missing = LessonSaving::missing(*m_draft);
    if (!missing.isEmpty())
        return m_window->showProblem(missing);
    const QString former = QFileInfo(before).completeBaseName();
    ui::askForLessonTarget(
        m_window, former.isEmpty() ? fileNameOf(m_draft->lesson()) : former, [this](const QString& path) {
            m_document->queue().enqueue([this, path] {
                if (!m_recorder->isOn())
                    return check(path, *m_draft, {});
                m_document->worker().post([this, path, draft = *m_draft](core::Sculptor& sculptor) {
                    const std::uint64_t hash = sculptor.mesh().meshHash();
                    QMetaObject::invokeMethod(
                        this, [this, path, draft, hash] { check(path, draft, hash); }, Qt::QueuedConnection);
                });
            });
        });
}

void LessonWriter::check(const QString& path, const core::LessonDraft& draft, const std::optional<std::uint64_t>& hash)
{
    BackgroundJob& job = m_document->job();
    if (job.isBusy())
        return m_window ? m_window->showNotice(tr("Please wait: another operation on the model is still running."))
                        : void();
    const core::JobControl control = job.beginCancellable(tr("Playing the lesson to its end"));
    job.run([draft, path, hash, control] { return LessonSaving::check(draft, toPath(path), hash, control); },
            [this, path, revision = draft.revision()](const CheckedLesson& checked) {
                onChecked(path, checked, revision);
            });
}

void LessonWriter::onChecked(const QString& path, const CheckedLesson& checked, std::uint64_t revision)
{
    m_document->job().commit();
    m_document->job().end();
    if (!m_window)
        return;
    if (!checked.problem.isEmpty())
        return m_window->showProblem(checked.problem);
    if (!checked.lesson)
        return m_window->showNotice(tr("%1 was not written.").arg(QFileInfo(path).fileName()));
    if (checked.remarks.isEmpty())
        return write(path, checked.lesson, revision);
    QStringList remarks = checked.remarks.mid(0, maxRemarks);
    if (checked.remarks.size() > maxRemarks)
        remarks << tr("And %n more.", nullptr, static_cast<int>(checked.remarks.size() - maxRemarks));
    auto* box = new QMessageBox(QMessageBox::Question, tr("Save the lesson"),
                                tr("Not all goals of the lesson are met."), QMessageBox::Cancel, m_window);
    box->setObjectName(QStringLiteral("lessonRemarks"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(remarks.join(QLatin1Char('\n')));
    const QPushButton* all = box->addButton(tr("Save All the Same"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::buttonClicked, this,
            [this, all, path, checked, revision](const QAbstractButton* pressed) {
                if (pressed == all)
                    write(path, checked.lesson, revision);
            });
    box->open();
}

void LessonWriter::write(const QString& path, const std::shared_ptr<const core::Lesson>& lesson, std::uint64_t revision)
{
    BackgroundJob& job = m_document->job();
    if (job.isBusy())
        return m_window->showNotice(tr("Please wait: another operation on the model is still running."));
    job.begin(tr("Saving %1").arg(QFileInfo(path).fileName()));
    job.run([path, lesson] { return LessonSaving::write(*lesson, toPath(path)); },
            [this, path, revision](const QString& problem) {
                m_document->job().end();
                if (!m_window)
                    return;
                if (!problem.isEmpty())
                    return m_window->showProblem(problem);
                Q_EMIT written(path, revision);
                m_window->showNotice(tr("Saved %1.").arg(QFileInfo(path).fileName()));
            });
}
} // namespace app
