#include "app/lesson/lesson_editor_controller.h"

#include "app/document/document.h"
#include "app/lesson/lesson_library.h"
#include "app/lesson/lesson_model.h"
#include "app/lesson/lesson_saving.h"
#include "app/model/command_names.h"
#include "app/worker/sculpt_worker.h"
#include "app/worker/stroke_step.h"

#include "core/lesson/checkpoint.h"
#include "core/mesh/mesh_builder.h"
#include "core/sculpt/sculptor.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/util/error_messages.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/window/main_window.h"

#include <QMessageBox>

#include <cmath>
#include <numbers>

namespace app
{
namespace
{
ui::LessonStroke describe(const core::FileEntry& entry)
{
    if (const auto* const command = std::get_if<core::FileCommand>(&entry))
        return {LessonSaving::nameOf(entry), CommandNames::icon(command->command)};
    return {LessonSaving::lineOf(std::get<core::Stroke>(entry)),
            StrokeStep::iconOf(std::get<core::Stroke>(entry).settings.tool)};
}

/// a revision that no draft has
constexpr std::uint64_t nothingWritten = ~std::uint64_t(0);

/// Returns cards of the bundled lessons with name and title only.
QList<ui::LessonCard> titleCards()
{
    QList<ui::LessonCard> all;
    for (const QString& name : bundledLessons())
        if (const auto lesson = tryToReadLesson(name).lesson)
            all.append({name, inOurLanguage(lesson->title), {}, {}});
    return all;
}

/// Returns suggested goals that the model meets: genus, components, minimum height in whole mm, and printability.
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

LessonEditorController::LessonEditorController(ui::MainWindow& window, Document& document)
    : QObject(&document)
    , m_window(&window)
    , m_panel(window.findChild<ui::LessonEditor*>())
    , m_document(&document)
    , m_recorder(document)
    , m_writer(window, document, &m_draft, &m_recorder)
{
    m_panel->setDescribe(describe);
    showLessons();
    using ui::LessonEditor;
    connect(m_panel, &LessonEditor::startChosen, this, &LessonEditorController::start);
    connect(m_panel, &LessonEditor::lessonChosen, this, &LessonEditorController::read);
    connect(m_panel, &LessonEditor::fileRequested, this,
            [this] { ui::askForLesson(m_window, [this](const QString& path) { read(lessonOrItsFolder(path)); }); });
    connect(m_panel, &LessonEditor::aboutToChange, this, &LessonEditorController::stopRecording);
    connect(m_panel, &LessonEditor::recordRequested, this, &LessonEditorController::record);
    connect(m_panel, &LessonEditor::factsRequested, this, &LessonEditorController::addFacts);
    connect(m_panel, &LessonEditor::saveRequested, this, [this] { m_writer.save(m_path); });
    connect(&m_writer, &LessonWriter::written, this, [this](const QString& path, std::uint64_t revision) {
        m_path = path;
        m_written = revision;
    });
    connect(m_panel, &LessonEditor::closeRequested, this, [this] { confirmDiscard([this] { leave(); }); });
    connect(m_document, &Document::opened, this, &LessonEditorController::begin);
    connect(m_document, &Document::stepped, this, [this] { m_isAllRecorded = m_isAllRecorded && m_recorder.isOn(); });
    connect(&m_recorder, &LessonRecorder::recorded, this, [this] {
        if (m_panel)
            m_panel->showChanges();
    });
    connect(&m_recorder, &LessonRecorder::ended, this, &LessonEditorController::stopRecording);
    connect(&m_recorder, &LessonRecorder::refused, this, [this] {
        if (m_window)
            m_window->showNotice(tr("Undone: a lesson cannot contain images or models from other files."));
    });
    window.setGuard([this] {
        if (!hasChanges())
            return true;
        confirmDiscard([this] {
            leave();
            m_window->close();
        });
        return false;
    });
}

void LessonEditorController::enableAutosave(const std::filesystem::path& root)
{
    m_autosave = std::make_unique<LessonAutosave>(root, [this] { return hasChanges() ? &m_draft : nullptr; });
    showLessons();
    if (m_window && !m_autosave->abandoned().isEmpty())
        m_window->showNotice(tr("An unsaved lesson was kept: Sculpt > Record Lesson lists it."));
}

/// Lists the lessons, unsaved ones first.
void LessonEditorController::showLessons()
{
    QList<ui::LessonCard> cards;
    for (const QString& file : m_autosave ? m_autosave->abandoned() : QStringList()) {
        const auto read = tryToReadLesson(file);
        cards.append({file, tr("Not saved: %1").arg(read.lesson ? inOurLanguage(read.lesson->title) : file), {}, {}});
    }
    m_panel->setLessons(cards + titleCards());
}

// --- opening and closing lessons

void LessonEditorController::start(const std::optional<core::Starter>& starter)
{
    m_window->viewport()->input()->finish();
    if (!starter)
        return startFromModel();
    core::Lesson lesson;
    lesson.start = *starter;
    setLesson(std::move(lesson), {});
    openAtEnd(false);
}

/// Makes a new lesson whose start file is the present model. Opens that file as the document, so that the teacher has
/// the same model as the pupils.
void LessonEditorController::startFromModel()
{
    const auto bytes = std::make_shared<std::string>();
    const auto problem = std::make_shared<QString>();
    const auto save = [bytes, problem](const ModelSaver::Present& present) {
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
        setLesson(std::move(lesson), {});
        openAtEnd(true, m_document->savedState().isModified());
    };
    if (!m_document->saver().saveExternally(tr("Preparing the lesson"), save, done))
        m_window->showNotice(tr("Please wait: another operation on the model is still running."));
}

void LessonEditorController::read(const QString& pathOrName)
{
    if (m_autosave && m_autosave->abandoned().contains(pathOrName))
        return resumeUnsaved(pathOrName);
    m_background.run([pathOrName] { return tryToReadLesson(pathOrName); },
                     [this, pathOrName](const ReadLesson& read) {
                         if (!m_window)
                             return;
                         if (!read.lesson)
                             return m_window->showProblem(read.problem);
                         setLesson(*read.lesson, pathOrName);
                     });
}

/// Opens an autosaved lesson. It still counts as unsaved and has no file of its own.
void LessonEditorController::resumeUnsaved(const QString& unsaved)
{
    const ReadLesson read = tryToReadLesson(unsaved);
    if (!read.lesson)
        return m_window->showProblem(read.problem);
    setLesson(LessonAutosave::withoutStandIns(*read.lesson), {});
    m_written = nothingWritten;
    m_autosave->adopt(unsaved);
    showLessons();
}

/// Opens a lesson for editing. A lesson without steps gets one.
void LessonEditorController::setLesson(core::Lesson lesson, const QString& path)
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

void LessonEditorController::leave()
{
    stopRecording();
    m_panel->showStarts();
    m_draft = core::LessonDraft();
    m_written = 0;
}

// --- recording

void LessonEditorController::record(bool on)
{
    m_window->viewport()->input()->finish();
    on ? openAtEnd(m_isAllRecorded) : m_document->queue().enqueue([this] { stopRecording(); });
}

/// Opens the model at the end of the lesson's steps, bit for bit as the lesson will be played.
void LessonEditorController::openAtEnd(bool discardsChanges, bool isUnsaved)
{
    m_opening = std::make_shared<const core::Lesson>(m_draft.complete({}));
    LessonModel model{m_opening, toPath(m_path), m_draft.steps()};
    if (model.lesson->title.words.empty()) // a new lesson has no title yet
        model.name =
            std::holds_alternative<core::Starter>(m_opening->start) ? tr("New Lesson") : m_document->modelInfo().name;
    const auto make = [model, isUnsaved](const core::JobControl& control) {
        LoadedModel loaded = model.load(control);
        loaded.isUnsaved = isUnsaved;
        return loaded;
    };
    m_document->opener().openMade({tr("Playing the lesson to its end"), make, m_opening, discardsChanges});
}

void LessonEditorController::begin()
{
    const std::shared_ptr<const core::Lesson> opening = std::exchange(m_opening, nullptr);
    m_isAllRecorded = opening && m_document->opener().mark() == opening;
    if (!m_isAllRecorded)
        return stopRecording();
    m_recorder.begin(&m_draft, [this]() -> std::optional<core::LessonView> {
        if (!m_window)
            return std::nullopt;
        constexpr double degree = std::numbers::pi / 180;
        const ui::OrbitCamera::Pose pose = m_window->viewport()->camera().pose();
        return core::LessonView{std::round(std::remainder(pose.yaw / degree, 360)), std::round(pose.pitch / degree)};
    });
    if (m_panel)
        m_panel->setRecording(true);
}

void LessonEditorController::stopRecording()
{
    m_opening = nullptr;
    m_recorder.end();
    if (m_panel && m_panel->isOpen())
        m_panel->setRecording(false);
}

void LessonEditorController::addFacts()
{
    m_document->queue().enqueue([this] {
        m_document->worker().post([this](core::Sculptor& sculptor) {
            auto mesh = std::make_shared<core::TriangleMesh>(core::extractMesh(sculptor.mesh()));
            m_background.run([mesh] { return factsOf(*mesh); },
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

// --- asking about unsaved changes

bool LessonEditorController::hasChanges() const
{
    return m_panel && m_panel->isOpen() && m_draft.revision() != m_written;
}

void LessonEditorController::confirmDiscard(std::function<void()> then)
{
    if (!hasChanges())
        return then();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved lesson"), tr("The lesson has unsaved changes."),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
    box->setObjectName(QStringLiteral("lessonQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Save);
    connect(box, &QDialog::finished, this, [this, then = std::move(then)](int answer) {
        if (answer == QMessageBox::Save)
            m_writer.save(m_path);
        else if (answer == QMessageBox::Discard)
            then();
    });
    box->open();
}
} // namespace app
