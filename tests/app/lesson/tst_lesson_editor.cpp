// Tests the lesson editor in the real window: a lesson is recorded by strokes, written, read and played, and an
// existing one is changed.
#include "tests/app/lesson/lesson_window.h"
#include "tests/support/ask_worker.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "app/lesson/lesson_library.h"
#include "app/lesson/lesson_model.h"
#include "app/lesson/lesson_saving.h"
#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "core/lesson/lesson_playback.h"
#include "core/mesh/mesh_builder.h"
#include "ui/lesson/lesson_editor.h"
#include "ui/widgets/side_panel.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace app;

namespace
{
bool isRecording(Program& program)
{
    return part<QLabel>(program, "lessonState")->text().startsWith(QStringLiteral("●"));
}

bool rests(Program& program)
{
    return program.document.queue().isSettled() && !program.document.job().isBusy();
}

/// Opens the window with the lesson editor, without a recording.
void show(Program& program)
{
    program.window.resize(1400, 1000);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY(rests(program) && program.window.viewport()->stats().patches > 0);
    program.window.action(QStringLiteral("lesson.record"))->trigger();
    QTRY_VERIFY(part<ui::SidePanel>(program, "lessonEditor")->isVisible());
}

/// Starts a recording. `starter`: start model; -1: the current model.
void record(Program& program, int starter)
{
    auto* start = part<QComboBox>(program, "lessonStart");
    start->setCurrentIndex(start->findData(starter));
    press(program, "lessonBegin");
    QTRY_VERIFY(isRecording(program) && rests(program));
}

void stroke(Program& program, const QPoint& by)
{
    const int before = program.document.history().stack().index();
    drag(program.window.viewport(), by);
    QTRY_COMPARE(program.document.history().stack().index(), before + 1);
    QTRY_VERIFY(rests(program));
}

void write(Program& program, const char* title, const char* text)
{
    auto* name = part<QLineEdit>(program, "lessonName");
    if (name->text().isEmpty())
        QTest::keyClicks(name, QStringLiteral("Mine"));
    auto* field = part<QLineEdit>(program, "lessonStepTitle");
    field->clear();
    QTest::keyClicks(field, QLatin1StringView(title));
    part<QPlainTextEdit>(program, "lessonStepText")->setPlainText(QLatin1StringView(text));
}

int strokesOf(Program& program)
{
    return part<QListWidget>(program, "lessonStrokes")->count();
}

void save(Program& program, const QString& path)
{
    press(program, "lessonSave");
    QTRY_VERIFY(part<QFileDialog>(program, "lessonTargetDialog"));
    auto* dialog = part<QFileDialog>(program, "lessonTargetDialog");
    QCOMPARE(dialog->defaultSuffix(), QStringLiteral("zip"));
    QVERIFY(!dialog->selectedFiles().isEmpty());
    if (path.endsWith(QStringLiteral(".zip"))) {
        chooseFile(program, "lessonTargetDialog", path);
    } else { // the dialog must not choose an existing file before the name is entered
        Q_EMIT dialog->filterSelected(dialog->nameFilters().constLast());
        QCOMPARE(dialog->defaultSuffix(), QString());
        Q_EMIT dialog->fileSelected(path);
        dialog->close();
    }
    QTRY_VERIFY(!part<QFileDialog>(program, "lessonTargetDialog"));
}

void saveAndWait(Program& program, const QString& path)
{
    save(program, path);
    QTRY_VERIFY(QFileInfo::exists(path) && rests(program));
}

/// Waits for a message box and returns it.
QMessageBox* question(Program& program, const char* name)
{
    QMessageBox* box = nullptr;
    const auto find = [&] {
        for (auto* each : program.window.findChildren<QMessageBox*>())
            if (each->isVisible() && (!*name || each->objectName() == QLatin1StringView(name)))
                box = each;
        return box != nullptr;
    };
    [&] { QTRY_VERIFY(find()); }();
    return box;
}

std::uint64_t playedHash(const QString& path)
{
    core::LessonPlayback playback(std::make_shared<const core::Lesson>(core::readLesson(toPath(path))), toPath(path));
    playback.goTo(playback.lesson().steps.size() - 1);
    playback.finish();
    if (!core::checkMesh(core::extractMesh(playback.mesh())).printReady())
        return 0;
    return playback.mesh().meshHash();
}

void edit(Program& program, const char* lesson)
{
    auto* lessons = part<QComboBox>(program, "lessonLibrary");
    lessons->setCurrentIndex(lessons->findData(QLatin1StringView(lesson)));
    press(program, "lessonEdit");
    QTRY_VERIFY(program.window.findChild<ui::LessonEditor*>()->isOpen());
}
} // namespace

class TestLessonEditor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    /// Two recorded steps, saved as one file and as a folder, must give the teacher's model bit for bit, with texts,
    /// tools, goals and pictures.
    void recorded_isReadBackToTheBit()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Torus));
        stroke(program, {30, 12});
        stroke(program, {-25, 30});
        const ui::OrbitCamera::Pose seenFrom = program.window.viewport()->camera().pose();
        write(program, "Out", "Pull it out.");
        press(program, "lesson.tool.pull");
        press(program, "lesson.tool.smooth");
        press(program, "lessonNewStep");
        program.window.action(QStringLiteral("tool.inflate"))->trigger();
        stroke(program, {10, -40});
        write(program, "Blow", "Make it thicker.");
        press(program, "lessonFacts");
        auto* holes = part<QDoubleSpinBox>(program, "lessonMost.genus");
        QTRY_COMPARE(holes->value(), 1.0);
        part<QDoubleSpinBox>(program, "lessonTolerance")->setValue(2.5);
        part<QDoubleSpinBox>(program, "lessonLeast.feet")->setValue(1);
        part<QDoubleSpinBox>(program, "lessonMost.widest_mm")->setValue(500);

        const QTemporaryDir folder;
        const QString zip = folder.filePath(QStringLiteral("mine.zip")),
                      plain = folder.filePath(QStringLiteral("plain"));
        saveAndWait(program, zip);
        saveAndWait(program, plain);
        QVERIFY(QFileInfo(plain).isDir());
        for (const QString& path : {zip, plain}) {
            QCOMPARE(playedHash(path), meshHash(program.worker));
            const core::Lesson lesson = core::readLesson(toPath(path));
            QCOMPARE(lesson.steps.size(), std::size_t(2));
            QCOMPARE(lesson.steps[0].strokes.size(), std::size_t(2));
            QCOMPARE(lesson.steps[0].tools, (std::vector{core::Tool::Pull, core::Tool::Smooth}));
            QCOMPARE(lesson.steps[1].strokes.size(), std::size_t(1));
            QCOMPARE(lesson.steps[1].title.words.begin()->second, std::string("Blow"));
            QCOMPARE(lesson.steps[1].checkpoint.facts.front(), (core::FactBounds{core::Fact::Genus, 1, 1}));
            QCOMPARE(lesson.steps[1].checkpoint.target->tolerance, 2.5);
            QVERIFY(std::ranges::count(lesson.steps[1].checkpoint.facts, core::FactBounds{core::Fact::Feet, 1}) == 1);
            QVERIFY(std::ranges::count(lesson.steps[1].checkpoint.facts,
                                       core::FactBounds{core::Fact::Widest, 0, 500}) == 1);
            QVERIFY(std::abs(lesson.steps[0].view.value().pitch - seenFrom.pitch * 180 / std::numbers::pi) <= 0.5);
            for (const core::LessonStep& step : lesson.steps)
                QVERIFY(QImage::fromData(QByteArray::fromStdString(lesson.files.at(step.picture))).width() > 100);
        }
        QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden).size(), 2);
    }

    /// The current model becomes the lesson's start. From then on it is the model that the file will contain.
    void asItIs_beginsWithTheModelInTheWindow()
    {
        Program program;
        show(program);
        stroke(program, {40, 20});
        const auto before = program.document.modelInfo().size;
        record(program, -1);
        QVERIFY(program.document.savedState().isModified()); // no file contains the lesson yet
        QVERIFY(!program.document.modelInfo().name.isEmpty());
        QCOMPARE(program.document.history().stack().count(), 0);
        QVERIFY((program.document.modelInfo().size - before).norm() < 1e-3);
        stroke(program, {-30, 25});
        write(program, "On", "Go on.");
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("on.zip"));
        saveAndWait(program, path);
        QVERIFY(std::holds_alternative<std::string>(core::readLesson(toPath(path)).start));
        QCOMPARE(playedHash(path), meshHash(program.worker));
    }

    /// The suggested file name is the lesson's title without characters that file names cannot contain.
    void title_isTheFileThatIsOffered()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        QCOMPARE(program.document.modelInfo().name, QStringLiteral("New Lesson"));
        stroke(program, {30, 12});
        QTest::keyClicks(part<QLineEdit>(program, "lessonName"), QStringLiteral("My lesson: a/b"));
        write(program, "One", "One stroke.");
        press(program, "lessonSave");
        QTRY_VERIFY(part<QFileDialog>(program, "lessonTargetDialog"));
        const QStringList offered = part<QFileDialog>(program, "lessonTargetDialog")->selectedFiles();
        QCOMPARE(QFileInfo(offered.value(0)).completeBaseName(), QStringLiteral("My lesson – a b"));
        part<QFileDialog>(program, "lessonTargetDialog")->reject();
    }

    /// All fields of a goal are visible at once: the column scrolls, not the page inside it.
    void goal_isSeenWhole()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        auto* pages = program.window.findChild<ui::LessonStepEditor*>();
        QWidget* const goal = part<QPushButton>(program, "lessonFacts")->parentWidget();
        pages->setCurrentWidget(goal);
        QTRY_VERIFY(goal->isVisible() && goal->height() >= goal->minimumSizeHint().height());
        QVERIFY(!pages->findChild<QScrollArea*>());
    }

    void undone_isOutOfTheLesson()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        stroke(program, {30, 12});
        stroke(program, {-30, 12});
        QCOMPARE(strokesOf(program), 2);
        program.document.history().undo();
        QTRY_COMPARE(strokesOf(program), 1);
        program.document.history().redo();
        QTRY_COMPARE(strokesOf(program), 2);
        program.document.history().goTo(0);
        QTRY_COMPARE(strokesOf(program), 0);
        stroke(program, {20, -20});
        QCOMPARE(strokesOf(program), 1);
        QTRY_VERIFY(rests(program));
        write(program, "One", "One stroke.");
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("one.zip"));
        saveAndWait(program, path);
        QCOMPARE(playedHash(path), meshHash(program.worker));
    }

    /// Strokes of the headset and commands for the whole model are recorded, too.
    void strokesOfTheHeadset_areRecorded()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        core::StrokeSettings settings;
        settings.radius = 15;
        settings.strength = 5;
        program.worker.strokes().beginStroke(Source::Headset, settings);
        core::StrokeSample sample;
        sample.position = {0, 0, 50};
        program.worker.strokes().addSample(Source::Headset, sample);
        program.worker.strokes().endStroke(Source::Headset);
        QTRY_COMPARE(strokesOf(program), 1);
        program.document.changer().apply(core::Scale{1.25});
        QTRY_COMPARE(strokesOf(program), 2);
        write(program, "Wand", "By hand.");
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("wand.zip"));
        saveAndWait(program, path);
        QCOMPARE(playedHash(path), meshHash(program.worker));
    }

    /// An entry that needs a file outside the lesson is undone at once.
    void insertedModel_isTakenBack()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        const std::uint64_t start = meshHash(program.worker);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("cube.stl"));
        core::writeMesh(toPath(path), core::starterModel(core::Starter::Cube));
        ui::InsertRequest insertion;
        insertion.path = path;
        program.document.changer().insert(insertion);
        QTRY_COMPARE(notice(program).isEmpty(), false);
        QTRY_VERIFY(rests(program) && program.document.history().stack().index() == 0);
        QCOMPARE(strokesOf(program), 0);
        QCOMPARE(meshHash(program.worker), start);
        QVERIFY(isRecording(program));
    }

    /// Cutting strokes of a bundled lesson ends the recording. Unmet goals are reported, and the lesson can be saved
    /// anyway.
    void cutStroke_isSaidAndMaySavedAllTheSame()
    {
        Program program;
        show(program);
        edit(program, "creature");
        auto* steps = part<QListWidget>(program, "lessonSteps");
        QCOMPARE(steps->count(), 4);
        const int strokes = strokesOf(program);
        for (int i = 0; i < strokes; ++i) {
            part<QListWidget>(program, "lessonStrokes")->setCurrentRow(0);
            press(program, "lessonCut");
        }
        QCOMPARE(strokesOf(program), 0);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("legless.zip"));
        save(program, path);
        QMessageBox* box = question(program, "lessonRemarks");
        QVERIFY(
            box->informativeText().contains(QStringLiteral("Step 1 is not met: at least 108 mm tall (now 100 mm).")));
        box->button(QMessageBox::Cancel)->click();
        QVERIFY(!QFileInfo::exists(path));
        save(program, path);
        box = question(program, "lessonRemarks");
        for (QAbstractButton* button : box->buttons())
            if (box->buttonRole(button) == QMessageBox::AcceptRole)
                button->click();
        QTRY_VERIFY(QFileInfo::exists(path));
        QVERIFY(core::readLesson(toPath(path)).steps[0].strokes.empty());
        QVERIFY(playedHash(path) != 0);
    }

    /// A lesson found after a kill is restored, still unsaved, and is removed from disk once it is discarded.
    void killed_isKept()
    {
        const QTemporaryDir home;
        const std::filesystem::path root = toPath(home.filePath(QStringLiteral("lessons"))),
                                    left = toPath(home.filePath(QStringLiteral("left")));
        const auto isKept = [](const std::filesystem::path& where) {
            return std::filesystem::exists(where) && !std::filesystem::is_empty(where);
        };
        {
            Program program;
            connectLessonAutosave(program.document, root);
            show(program);
            record(program, static_cast<int>(core::Starter::Torus));
            QTest::keyClicks(part<QLineEdit>(program, "lessonName"), QStringLiteral("Mine"));
            stroke(program, {30, 12});
            const auto strokesKept = [&] {
                for (const auto& folder :
                     isKept(root) ? std::filesystem::directory_iterator(root) : std::filesystem::directory_iterator())
                    if (const ReadLesson read =
                            tryToReadLesson(QString::fromStdString((folder.path() / "lesson.zip").string()));
                        read.lesson)
                        return read.lesson->steps.at(0).strokes.size();
                return std::size_t(0);
            };
            QTRY_COMPARE(strokesKept(), std::size_t(1));
            std::filesystem::copy(root, left, std::filesystem::copy_options::recursive);
        }
        QVERIFY(!isKept(root)); // the first program ended normally
        Program program;
        connectLessonAutosave(program.document, left);
        show(program);
        QVERIFY(notice(program).contains(QStringLiteral("unsaved lesson was kept")));
        auto* lessons = part<QComboBox>(program, "lessonLibrary");
        QCOMPARE(lessons->itemText(0), QStringLiteral("Not saved: Mine"));
        QCOMPARE(lessons->count(), 5);
        lessons->setCurrentIndex(0);
        press(program, "lessonEdit");
        QTRY_VERIFY(program.window.findChild<ui::LessonEditor*>()->isOpen());
        QCOMPARE(part<QLineEdit>(program, "lessonName")->text(), QStringLiteral("Mine"));
        QCOMPARE(part<QPlainTextEdit>(program, "lessonStepText")->toPlainText(),
                 QString()); // the text must not be filled in by the program
        QCOMPARE(strokesOf(program), 1);
        QCOMPARE(lessons->count(), 4);
        press(program, "lessonSave");
        QVERIFY(question(program, "problem")->text().contains(QStringLiteral("has no text yet")));
        question(program, "problem")->close();
        QVERIFY(isKept(left));
        press(program, "lessonClose");
        question(program, "lessonQuestion")->button(QMessageBox::Discard)->click();
        QTRY_VERIFY(!isKept(left));
    }

    /// Steps can be reordered, a text can be changed in one language, and recording continues at the end of the opened
    /// lesson.
    void opened_isChangedAndRecordedOn()
    {
        Program program;
        show(program);
        const QTemporaryDir folder;
        const QString ours = folder.filePath(QStringLiteral("ours.zip")),
                      path = folder.filePath(QStringLiteral("more"));
        core::writeLesson(toPath(ours), readLesson(QStringLiteral("first-clay")));
        Q_EMIT program.window.findChild<ui::LessonEditor*>()->lessonChosen(ours);
        auto* steps = part<QListWidget>(program, "lessonSteps");
        QTRY_COMPARE(steps->count(), 4);
        steps->setCurrentRow(3);
        press(program, "lessonRemove");
        QCOMPARE(steps->count(), 3);
        steps->setCurrentRow(2);
        press(program, "lessonUp");
        press(program, "lessonDown");
        QCOMPARE(steps->currentRow(), 2);
        auto* language = part<QComboBox>(program, "lessonLanguage");
        language->setCurrentIndex(language->findData(QStringLiteral("de")));
        Q_EMIT language->activated(language->currentIndex());
        part<QPlainTextEdit>(program, "lessonStepText")->setPlainText(QStringLiteral("Anders."));
        press(program, "lessonRecord");
        QTRY_VERIFY(isRecording(program) && rests(program));
        press(program, "lessonNewStep");
        stroke(program, {25, 25});
        write(program, "Neu", "Noch etwas.");
        saveAndWait(program, path);
        const core::Lesson lesson = core::readLesson(toPath(path));
        QCOMPARE(lesson.steps.size(), std::size_t(4));
        QCOMPARE(lesson.steps[2].text.in("de"), std::string("Anders."));
        QVERIFY(lesson.steps[2].text.in("en") != "Anders.");
        // the only text, so it is used for every language
        QCOMPARE(lesson.steps[3].text.in("en"), std::string("Noch etwas."));
        QCOMPARE(playedHash(path), meshHash(program.worker));
    }

    void withoutText_orOverAFolder_isToldAndNothingIsWritten()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        press(program, "lessonSave");
        QVERIFY(question(program, "")->text().contains(QStringLiteral("title")));
        question(program, "")->close();
        write(program, "One", "Text.");
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("there"));
        QVERIFY(QDir().mkpath(path));
        save(program, path);
        QVERIFY(question(program, "")->text().contains(QStringLiteral("already exists")));
        QVERIFY(QDir(path).isEmpty());
        QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden).size(), 1);
    }

    /// A command that fails on the changed model is reported with its step and stroke.
    void brokenCommand_isSaidByStepAndStroke()
    {
        core::LessonDraft draft(readLesson(QStringLiteral("first-clay")));
        draft.addStroke(1, core::FileCommand{core::FlattenBase{500}, {}});
        const CheckedLesson tried = LessonSaving::check(draft, "broken.zip", {}, {});
        QVERIFY(!tried.lesson);
        QVERIFY2(tried.problem.contains(QStringLiteral("step 2")), qPrintable(tried.problem));
        QVERIFY2(tried.problem.contains(QStringLiteral("stroke %1").arg(draft.step(1).strokes.size())),
                 qPrintable(tried.problem));
    }

    /// One sentence is reported, and nothing is written.
    void unwritable_isTold()
    {
        const core::Lesson lesson = readLesson(QStringLiteral("first-clay"));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("none/lesson.zip"));
        QVERIFY(LessonSaving::write(lesson, toPath(path)).contains(QStringLiteral("none")));
        QVERIFY(!LessonSaving::write(lesson, toPath(folder.filePath(QStringLiteral("none/lesson")))).isEmpty());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void stopped_writesNothing()
    {
        Program program;
        show(program);
        edit(program, "mug");
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("mug.zip"));
        save(program, path);
        QTRY_VERIFY(program.document.job().isBusy());
        program.window.action(QStringLiteral("edit.stop"))->trigger();
        QTRY_VERIFY(!program.document.job().isBusy());
        QVERIFY(notice(program).contains(QStringLiteral("was not written")));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    /// Opening another model ends the recording and keeps what was recorded. Closing the window asks about an unsaved
    /// lesson.
    void unsaved_isAskedFor()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        stroke(program, {30, 12});
        answerQuestion(program, QMessageBox::Discard);
        program.document.opener().openStarter(core::Starter::Cube);
        QTRY_VERIFY(!isRecording(program) && rests(program));
        QCOMPARE(strokesOf(program), 1);
        program.window.close();
        QVERIFY(program.window.isVisible());
        question(program, "lessonQuestion")->button(QMessageBox::Cancel)->click();
        QVERIFY(program.window.isVisible());
        press(program, "lessonClose");
        question(program, "lessonQuestion")->button(QMessageBox::Discard)->click();
        QTRY_VERIFY(!program.window.findChild<ui::LessonEditor*>()->isOpen());
        program.window.close();
        QTRY_VERIFY(!program.window.isVisible());
    }
};

FETTLE_TEST(TestLessonEditor, app::OnScreen)
#include "tst_lesson_editor.moc"
