#include "app/classroom/class_file_controller.h"

#include "app/classroom/class_file.h"
#include "app/classroom/class_paths.h"
#include "app/classroom/class_pin.h"
#include "app/classroom/work_archive.h"
#include "app/document/document.h"
#include "app/lesson/lesson_cards.h"

#include "ui/classroom/classroom_dialog.h"
#include "ui/classroom/waiting_works_note.h"
#include "ui/files/model_files.h"
#include "ui/settings/settings.h"
#include "ui/util/format_filters.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace app
{
ClassFileController::ClassFileController(ui::MainWindow& window, Document& document)
    : QObject(&window)
    , m_window(window)
{
    connect(window.action(QStringLiteral("edit.classroom")), &QAction::triggered, this, [this] { edit(); });
    const auto stay = [this] { m_next.clear(); }; // the window stays open after all
    connect(&document, &Document::stepped, this, stay);
    connect(&document, &Document::opened, this, stay);
    connect(&document.saver(), &ModelSaver::saveFailed, this, stay);
    connect(window.files(), &ui::ModelFiles::discardDeclined, this, stay);
}

void ClassFileController::edit()
{
    if (m_dialog)
        return m_dialog->raise();
    m_dialog =
        new ui::ClassroomDialog(&m_window, m_window.commands(), ui::Settings().lastFolder(), bundledLessonCards());
    connect(m_dialog, &ui::ClassroomDialog::openRequested, this, &ClassFileController::load);
    connect(m_dialog, &ui::ClassroomDialog::drafted, this, &ClassFileController::write);
    connect(m_dialog->waitingWorks(), &ui::WaitingWorksNote::moveRequested, this, &ClassFileController::moveWaiting);
    showWaiting();
    m_dialog->open();
}

void ClassFileController::edit(const ui::Classroom& classroom, const QString& path)
{
    edit();
    m_dialog->load(classroom, path);
}

void ClassFileController::load(const QString& path)
{
    try {
        m_dialog->load(ClassFile::read(path), path);
    } catch (const ClassFileError& error) {
        m_dialog->showFault(error.sentence);
    }
}

/// Writes the class file. If that fails, the dialog stays open with its input.
void ClassFileController::write(const ui::ClassroomDraft& draft)
{
    ui::Classroom classroom = draft.classroom;
    if (!draft.pin.isEmpty())
        classroom.pin = pinRecord(draft.pin);
    const QString fault = ClassFile::lessonProblem(classroom);
    const QString problem = fault.isEmpty() ? ClassFile::write(draft.path, classroom) : fault;
    if (!problem.isEmpty())
        return m_dialog->showFault(problem);
    m_dialog->done(QDialog::Accepted);
    m_window.showNotice(tr("Saved %1.").arg(QFileInfo(draft.path).fileName()));
    askToBegin(classroom, draft.path,
               ui::isClassFile(draft.path) ? tr("A double click on %1 begins it, on every computer that has Fettle.")
                                                 .arg(QDir::toNativeSeparators(draft.path))
                                           : QString());
}

void ClassFileController::offer(const QString& path)
{
    try {
        askToBegin(ClassFile::read(path), path, {});
    } catch (const ClassFileError& error) {
        m_window.showProblem(error.sentence);
    }
}

void ClassFileController::askToBegin(const ui::Classroom& classroom, const QString& path, const QString& how)
{
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Classroom"), tr("Begin the class \"%1\" now?").arg(classroom.title),
                        QMessageBox::NoButton, &m_window);
    question->setObjectName(QStringLiteral("beginClass"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setTextFormat(Qt::PlainText);
    question->setInformativeText(
        QStringList{how, tr("This window closes, and only the class is there. Leaving it asks for your PIN.")}
            .join(u'\n')
            .trimmed());
    auto* begins = question->addButton(tr("&Begin the Class Now"), QMessageBox::AcceptRole);
    connect(begins, &QPushButton::clicked, this, [this, path] { begin(path); });
    auto* changes = question->addButton(tr("C&hange…"), QMessageBox::ActionRole);
    connect(changes, &QPushButton::clicked, this, [this, classroom, path] { edit(classroom, path); });
    question->addButton(tr("&Not Now"), QMessageBox::RejectRole);
    question->setDefaultButton(begins);
    question->open();
}

/// Closes the window once the question is closed, because closing may ask about unsaved changes.
void ClassFileController::begin(const QString& path)
{
    m_next = path;
    QMetaObject::invokeMethod(&m_window, &QWidget::close, Qt::QueuedConnection);
}

// --- undelivered works on this computer

void ClassFileController::showWaiting(const QString& outcome)
{
    if (!m_dialog)
        return;
    QStringList sentences;
    for (const WaitingWorks& works : ClassPaths::waiting())
        sentences << (works.folder.isEmpty()
                          ? tr("%n models of a class are still on this computer.", nullptr, works.count)
                          : tr("%n models are still on this computer and not in %1.", nullptr, works.count)
                                .arg(QDir::toNativeSeparators(works.folder)));
    if (!sentences.isEmpty())
        sentences << tr("They go to the class folder when the class begins and its folder is there.");
    m_dialog->waitingWorks()->setWaiting(sentences.join(u'\n'), outcome);
}

void ClassFileController::moveWaiting(const QString& folder)
{
    const auto move = [folder] {
        Delivery all;
        for (const WaitingWorks& works : ClassPaths::waiting()) {
            const Delivery one = WorkArchive(folder, works.outbox).deliver();
            all.moved.insert(one.moved);
            if (all.problem.isEmpty())
                all.problem = one.problem;
        }
        return all;
    };
    m_background.run(move, [this, folder](const Delivery& moved) {
        showWaiting(moved.problem.isEmpty()
                        ? tr("%n models were moved to %1.", nullptr, static_cast<int>(moved.moved.size()))
                              .arg(QDir::toNativeSeparators(folder))
                        : moved.problem);
    });
}
} // namespace app
