#include "app/lesson/lesson_editor_controller.h"

#include "app/document/document.h"
#include "app/lesson/lesson_library.h"
#include "app/lesson/lesson_model.h"
#include "app/model/command_names.h"
#include "app/worker/stroke_step.h"

#include "core/lesson/checkpoint.h"
#include "core/mesh/mesh_builder.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/util/error_messages.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <cmath>

namespace app
{
namespace
{
constexpr qsizetype mostRemarks = 8; ///< that are shown

ui::LessonStroke describe(const core::FileEntry& entry)
{
    if (const auto* const command = std::get_if<core::FileCommand>(&entry))
        return {LessonSaving::nameOf(entry), ModelWords::icon(command->command)};
    return {LessonSaving::lineOf(std::get<core::Stroke>(entry)),
            StrokeStep::iconOf(std::get<core::Stroke>(entry).settings.tool)};
}

/// Of no draft.
constexpr std::uint64_t nothingWritten = ~std::uint64_t(0);

/// By name and title alone.
QList<ui::LessonCard> titleCards()
{
    QList<ui::LessonCard> all;
    for (const QString& name : shippedLessons())
        if (const auto lesson = tryToReadLesson(name).lesson)
            all.append({name, inOurLanguage(lesson->title), {}, {}});
    return all;
}

/// What one is asked for most: a whole number of millimetres that the model itself has.
std::vector<core::FactBounds> factsOf(const core::TriangleMesh& mesh)
{
    using core::Fact;
    core::Checkpoint all;
    for (const Fact fact : {Fact::Genus, Fact::Components, Fact::Height, Fact::PrintReady})
        all.facts.push_back({fact});
    std::vector<core::FactBounds> facts;
    for (const core::FactVerdict& verdict : core::evaluate(all, mesh, nullptr).facts) {
        const double value = verdict.measured.value_or(0);
        if (verdict.asked.fact == Fact::Height)
            facts.push_back({Fact::Height, std::floor(value)});
        else if (verdict.asked.fact != Fact::PrintReady || value > 0)
            facts.push_back({verdict.asked.fact, value, value});
    }
    return facts;
}
} // namespace

LessonEditorDesk::LessonEditorDesk(ui::MainWindow& window, Document& document, SculptWorker& worker)
    : QObject(&document)
    , m_window(&window)
    , m_panel(window.findChild<ui::LessonEditor*>())
    , m_document(&document)
    , m_worker(&worker)
    , m_recorder(document)
{
    m_panel->setDescribe(describe);
    showLessons();
    connectAll();
    window.setGuard([this] { return mayClose(); });
}

void LessonEditorDesk::keepLessons(const std::filesystem::path& root)
{
    m_keeper = std::make_unique<LessonKeeper>(root, [this] { return hasChanges() ? &m_draft : nullptr; });
    showLessons();
    if (m_window && !m_keeper->left().isEmpty())
        m_window->showNotice(
            tr("A lesson that was not saved is kept: Sculpt > Record Lesson has it among the lessons."));
}

/// Those that were not saved first.
void LessonEditorDesk::showLessons()
{
    QList<ui::LessonCard> cards;
    for (const QString& file : m_keeper ? m_keeper->left() : QStringList()) {
        const auto read = tryToReadLesson(file);
        cards.append({file, tr("Not saved: %1").arg(read.lesson ? inOurLanguage(read.lesson->title) : file), {}, {}});
    }
    m_panel->setLessons(cards + titleCards());
}

void LessonEditorDesk::connectAll()
{
    using ui::LessonEditor;
    connect(m_panel, &LessonEditor::startChosen, this, &LessonEditorDesk::start);
    connect(m_panel, &LessonEditor::lessonChosen, this, &LessonEditorDesk::read);
    connect(m_panel, &LessonEditor::fileRequested, this,
            [this] { ui::askForLesson(m_window, [this](const QString& path) { read(lessonOrItsFolder(path)); }); });
    connect(m_panel, &LessonEditor::aboutToChange, this, &LessonEditorDesk::stopRecording);
    connect(m_panel, &LessonEditor::recordRequested, this, &LessonEditorDesk::record);
    connect(m_panel, &LessonEditor::factsRequested, this, &LessonEditorDesk::takeFacts);
    connect(m_panel, &LessonEditor::saveRequested, this, &LessonEditorDesk::save);
    connect(m_panel, &LessonEditor::closeRequested, this, [this] { askThen([this] { leave(); }); });
    connect(m_document, &Document::opened, this, &LessonEditorDesk::begin);
    connect(m_document, &Document::stepped, this, [this] { m_isOurs = m_isOurs && m_recorder.isOn(); });
    connect(&m_recorder, &LessonRecorder::recorded, this, [this] {
        if (m_panel)
            m_panel->showChanges();
    });
    connect(&m_recorder, &LessonRecorder::ended, this, &LessonEditorDesk::stopRecording);
    connect(&m_recorder, &LessonRecorder::refused, this, [this] {
        if (m_window)
            m_window->showNotice(tr("This was taken back: a lesson cannot hold images and models from other files."));
    });
}

// --- what is worked on

void LessonEditorDesk::start(const std::optional<core::Starter>& starter)
{
    m_window->viewport()->finish();
    if (!starter)
        return startFromModel();
    core::Lesson lesson;
    lesson.start = *starter;
    take(std::move(lesson), {});
    openEnd(false);
}

/// Its file is made of the model as it is; and that becomes the document, as pupils will have it.
void LessonEditorDesk::startFromModel()
{
    const auto bytes = std::make_shared<std::string>();
    const auto problem = std::make_shared<QString>();
    const auto keep = [bytes, problem](const Document::Present& present) {
        try {
            *bytes = lessonStartOf(*present.mesh);
            if (bytes->size() > core::LessonLimits::maxBytes)
                *problem = tr("The model is too large for a lesson.");
        } catch (const core::FileError& error) {
            *problem = ui::ErrorMessages::sentence(error);
        }
        return false;
    };
    const auto done = [this, bytes, problem](bool) {
        if (!m_window)
            return;
        if (!problem->isEmpty())
            return m_window->showProblem(*problem);
        core::Lesson lesson;
        lesson.start = lessonStart;
        lesson.files.emplace(lessonStart, std::move(*bytes));
        take(std::move(lesson), {});
        openEnd(true, m_document->isModified());
    };
    if (!m_document->handOver(tr("Preparing the lesson"), keep, done))
        m_window->showNotice(tr("Not yet: other work on the model is not done."));
}

void LessonEditorDesk::read(const QString& pathOrName)
{
    if (m_keeper && m_keeper->left().contains(pathOrName))
        return goOnWith(pathOrName);
    m_aside.run([pathOrName] { return tryToReadLesson(pathOrName); },
                [this, pathOrName](const ReadLesson& read) {
                    if (!m_window)
                        return;
                    if (!read.lesson)
                        return m_window->showProblem(read.problem);
                    take(*read.lesson, pathOrName);
                });
}

/// Still not saved, and no file's.
void LessonEditorDesk::goOnWith(const QString& kept)
{
    const ReadLesson read = tryToReadLesson(kept);
    if (!read.lesson)
        return m_window->showProblem(read.problem);
    take(LessonKeeper::withoutStandIns(*read.lesson), {});
    m_written = nothingWritten;
    m_keeper->takeOver(kept);
    showLessons();
}

/// A lesson without steps gets one.
void LessonEditorDesk::take(core::Lesson lesson, const QString& path)
{
    stopRecording();
    m_panel->showStarts();
    m_draft = core::LessonDraft(std::move(lesson));
    m_path = path;
    m_panel->showDraft(&m_draft);
    if (m_draft.steps() == 0)
        m_panel->addStep();
    m_written = m_draft.revision();
}

void LessonEditorDesk::leave()
{
    stopRecording();
    m_panel->showStarts();
    m_draft = core::LessonDraft();
    m_written = 0;
}

// --- recording

void LessonEditorDesk::record(bool on)
{
    m_window->viewport()->finish();
    on ? openEnd(m_isOurs) : m_document->inTurn([this] { stopRecording(); });
}

/// The model that the steps leave, to the bit as the lesson will be played.
void LessonEditorDesk::openEnd(bool losesChanges, bool isUnsaved)
{
    m_coming = std::make_shared<const core::Lesson>(m_draft.complete({}));
    const LessonModel model{m_coming, toPath(m_path), m_draft.steps()};
    const auto make = [model, isUnsaved](const core::JobControl& control) {
        LoadedModel loaded = model.load(control);
        loaded.isUnsaved = isUnsaved;
        return loaded;
    };
    m_document->openMade({tr("Playing the lesson to its end"), make, m_coming, losesChanges});
}

void LessonEditorDesk::begin()
{
    const std::shared_ptr<const core::Lesson> coming = std::exchange(m_coming, nullptr);
    m_isOurs = coming && m_document->mark() == coming;
    if (!m_isOurs)
        return stopRecording();
    m_recorder.begin(&m_draft);
    if (m_panel)
        m_panel->setRecording(true);
}

void LessonEditorDesk::stopRecording()
{
    m_coming = nullptr;
    m_recorder.end();
    if (m_panel && m_panel->isOpen())
        m_panel->setRecording(false);
}

void LessonEditorDesk::takeFacts()
{
    m_document->inTurn([this] {
        m_worker->post([this](core::Sculptor& sculptor) {
            auto mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
            m_aside.run([mesh] { return factsOf(*mesh); },
                        [this](const std::vector<core::FactBounds>& facts) {
                            if (!m_panel || !m_panel->isOpen())
                                return;
                            for (const core::FactBounds& bounds : facts)
                                m_draft.setFact(m_panel->step(), bounds);
                            m_panel->showChanges();
                        });
        });
    });
}

// --- writing

void LessonEditorDesk::save()
{
    m_window->viewport()->finish();
    const QString missing = LessonSaving::missing(m_draft);
    if (!missing.isEmpty())
        return m_window->showProblem(missing);
    const QString title = QFileInfo(m_path).completeBaseName();
    ui::askForLessonTarget(m_window, title.isEmpty() ? tr("lesson") : title, [this](const QString& path) {
        m_document->inTurn([this, path] {
            if (!m_recorder.isOn())
                return attempt(path, m_draft, {});
            m_worker->post([this, path, draft = m_draft](core::Sculptor& sculptor) {
                const std::uint64_t hash = sculptor.mesh().meshHash();
                QMetaObject::invokeMethod(
                    this, [this, path, draft, hash] { attempt(path, draft, hash); }, Qt::QueuedConnection);
            });
        });
    });
}

void LessonEditorDesk::attempt(const QString& path, const core::LessonDraft& draft,
                               const std::optional<std::uint64_t>& hash)
{
    LongWork* work = m_document->longWork();
    if (work->isBusy())
        return m_window ? m_window->showNotice(tr("Not yet: other work on the model is not done.")) : void();
    const core::JobControl control = work->beginStoppable(tr("Playing the lesson to its end"));
    work->run(
        [draft, path, hash, control] { return LessonSaving::attempt(draft, toPath(path), hash, control); },
        [this, path, revision = draft.revision()](const TriedLesson& tried) { takeAttempt(path, tried, revision); });
}

void LessonEditorDesk::takeAttempt(const QString& path, const TriedLesson& tried, std::uint64_t revision)
{
    m_document->longWork()->keep();
    m_document->longWork()->end();
    if (!m_window)
        return;
    if (!tried.problem.isEmpty())
        return m_window->showProblem(tried.problem);
    if (!tried.lesson)
        return m_window->showNotice(tr("%1 was not written.").arg(QDir::toNativeSeparators(path)));
    if (tried.remarks.isEmpty())
        return write(path, tried.lesson, revision);
    QStringList remarks = tried.remarks.mid(0, mostRemarks);
    if (tried.remarks.size() > mostRemarks)
        remarks << tr("And %n more.", nullptr, static_cast<int>(tried.remarks.size() - mostRemarks));
    auto* box = new QMessageBox(QMessageBox::Question, tr("Save the lesson"),
                                tr("Not everything is as the lesson asks for."), QMessageBox::Cancel, m_window);
    box->setObjectName(QStringLiteral("lessonRemarks"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(remarks.join(QLatin1Char('\n')));
    const QPushButton* all = box->addButton(tr("Save All the Same"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::buttonClicked, this, [this, all, path, tried, revision](const QAbstractButton* pressed) {
        if (pressed == all)
            write(path, tried.lesson, revision);
    });
    box->open();
}

void LessonEditorDesk::write(const QString& path, const std::shared_ptr<const core::Lesson>& lesson,
                             std::uint64_t revision)
{
    LongWork* work = m_document->longWork();
    if (work->isBusy())
        return m_window->showNotice(tr("Not yet: other work on the model is not done."));
    work->begin(tr("Saving %1").arg(QFileInfo(path).fileName()));
    work->run([path, lesson] { return LessonSaving::write(*lesson, toPath(path)); },
              [this, path, revision](const QString& problem) {
                  m_document->longWork()->end();
                  if (!m_window)
                      return;
                  if (!problem.isEmpty())
                      return m_window->showProblem(problem);
                  m_path = path;
                  m_written = revision;
                  m_window->showNotice(tr("%1 was written.").arg(QDir::toNativeSeparators(path)));
              });
}

// --- what would be lost

bool LessonEditorDesk::hasChanges() const
{
    return m_panel && m_panel->isOpen() && m_draft.revision() != m_written;
}

void LessonEditorDesk::askThen(std::function<void()> then)
{
    if (!hasChanges())
        return then();
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Unsaved lesson"), tr("The lesson has changes that were not saved."),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
    box->setObjectName(QStringLiteral("lessonQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Save);
    connect(box, &QDialog::finished, this, [this, then = std::move(then)](int answer) {
        if (answer == QMessageBox::Save)
            save();
        else if (answer == QMessageBox::Discard)
            then();
    });
    box->open();
}

bool LessonEditorDesk::mayClose()
{
    if (!hasChanges())
        return true;
    askThen([this] {
        leave();
        m_window->close();
    });
    return false;
}
} // namespace app
