// A teacher's lesson in the real window: recorded by strokes, written, read back and played; opened and changed.
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
#include "tests/support/effort.h"
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

/// The window with its lesson editor, and nothing recorded.
void show(Program& program)
{
    program.window.resize(1400, 1000);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().openBall();
    QTRY_VERIFY_WITH_TIMEOUT(rests(program) && program.window.viewport()->stats().patches > 0, longestWait);
    program.window.action(QStringLiteral("lesson.record"))->trigger();
    QTRY_VERIFY(part<ui::SidePanel>(program, "lessonEditor")->isVisible());
}

/// A lesson begins; -1: with the model as it is.
void record(Program& program, int starter)
{
    auto* start = part<QComboBox>(program, "lessonStart");
    start->setCurrentIndex(start->findData(starter));
    press(program, "lessonBegin");
    QTRY_VERIFY_WITH_TIMEOUT(isRecording(program) && rests(program), longestWait);
}

void stroke(Program& program, const QPoint& by)
{
    const int before = program.document.history().stack().index();
    drag(program.window.viewport(), by);
    QTRY_COMPARE_WITH_TIMEOUT(program.document.history().stack().index(), before + 1, longestWait);
    QTRY_VERIFY_WITH_TIMEOUT(rests(program), longestWait);
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
    QTRY_VERIFY_WITH_TIMEOUT(part<QFileDialog>(program, "lessonTargetDialog"), longestWait);
    auto* dialog = part<QFileDialog>(program, "lessonTargetDialog");
    QCOMPARE(dialog->defaultSuffix(), QStringLiteral("zip"));
    QVERIFY(!dialog->selectedFiles().isEmpty());
    if (path.endsWith(QStringLiteral(".zip"))) {
        chooseFile(program, "lessonTargetDialog", path);
    } else { // where other files are it may choose one of them before a name is typed
        Q_EMIT dialog->filterSelected(dialog->nameFilters().constLast());
        QCOMPARE(dialog->defaultSuffix(), QString());
        Q_EMIT dialog->fileSelected(path);
        dialog->close();
    }
    QTRY_VERIFY_WITH_TIMEOUT(!part<QFileDialog>(program, "lessonTargetDialog"), longestWait);
}

void saveAndWait(Program& program, const QString& path)
{
    save(program, path);
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(path) && rests(program), longestWait);
}

/// Waits for what the window asks or says, and reads it.
QMessageBox* question(Program& program, const char* name)
{
    QMessageBox* box = nullptr;
    const auto find = [&] {
        for (auto* each : program.window.findChildren<QMessageBox*>())
            if (each->isVisible() && (!*name || each->objectName() == QLatin1StringView(name)))
                box = each;
        return box != nullptr;
    };
    [&] { QTRY_VERIFY_WITH_TIMEOUT(find(), longestWait); }();
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
    auto* lessons = part<QComboBox>(program, "lessonShelf");
    lessons->setCurrentIndex(lessons->findData(QLatin1StringView(lesson)));
    press(program, "lessonEdit");
    QTRY_VERIFY_WITH_TIMEOUT(program.window.findChild<ui::LessonEditor*>()->isOpen(), longestWait);
}
} // namespace

class TestLessonEditor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    /// Two steps by hand, as one file and as a folder: both are the teacher's model to the bit, with words, tools,
    /// goals and pictures.
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
        QTRY_COMPARE_WITH_TIMEOUT(holes->value(), 1.0, longestWait);
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

    /// The model that is there becomes the lesson's start, and is from then on what the file says.
    void asItIs_beginsWithTheModelInTheWindow()
    {
        Program program;
        show(program);
        stroke(program, {40, 20});
        const auto before = program.document.modelInfo().size;
        record(program, -1);
        QVERIFY(program.document.savedState().isModified()); // it is in no file of its own
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

    /// Called as the lesson is, as far as files may be.
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
        QTRY_VERIFY_WITH_TIMEOUT(part<QFileDialog>(program, "lessonTargetDialog"), longestWait);
        const QStringList offered = part<QFileDialog>(program, "lessonTargetDialog")->selectedFiles();
        QCOMPARE(QFileInfo(offered.value(0)).completeBaseName(), QStringLiteral("My lesson – a b"));
        part<QFileDialog>(program, "lessonTargetDialog")->reject();
    }

    /// Asks that all rows of a goal are there at once: the column scrolls, not the page in it.
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

    /// A wand's strokes are steps of the same document, and so are commands for the whole model.
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
        QTRY_COMPARE_WITH_TIMEOUT(strokesOf(program), 1, longestWait);
        program.document.changer().apply(core::Scale{1.25});
        QTRY_COMPARE_WITH_TIMEOUT(strokesOf(program), 2, longestWait);
        write(program, "Wand", "By hand.");
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("wand.zip"));
        saveAndWait(program, path);
        QCOMPARE(playedHash(path), meshHash(program.worker));
    }

    /// What needs a file that the lesson has not is taken back at once.
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
        QTRY_COMPARE_WITH_TIMEOUT(notice(program).isEmpty(), false, longestWait);
        QTRY_VERIFY_WITH_TIMEOUT(rests(program) && program.document.history().stack().index() == 0, longestWait);
        QCOMPARE(strokesOf(program), 0);
        QCOMPARE(meshHash(program.worker), start);
        QVERIFY(isRecording(program));
    }

    /// A lesson of the program is opened, a stroke cut, which ends the recording; what that breaks is said, and it may
    /// be saved all the same.
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
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(path), longestWait);
        QVERIFY(core::readLesson(toPath(path)).steps[0].strokes.empty());
        QVERIFY(playedHash(path) != 0);
    }

    /// What a kill would leave on disk comes back as it was, still not saved, and goes when it is given up.
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
            QTRY_COMPARE_WITH_TIMEOUT(strokesKept(), std::size_t(1), longestWait);
            std::filesystem::copy(root, left, std::filesystem::copy_options::recursive);
        }
        QVERIFY(!isKept(root)); // this one ended in order
        Program program;
        connectLessonAutosave(program.document, left);
        show(program);
        QVERIFY(notice(program).contains(QStringLiteral("unsaved lesson was kept")));
        auto* lessons = part<QComboBox>(program, "lessonShelf");
        QCOMPARE(lessons->itemText(0), QStringLiteral("Not saved: Mine"));
        QCOMPARE(lessons->count(), 4);
        lessons->setCurrentIndex(0);
        press(program, "lessonEdit");
        QTRY_VERIFY_WITH_TIMEOUT(program.window.findChild<ui::LessonEditor*>()->isOpen(), longestWait);
        QCOMPARE(part<QLineEdit>(program, "lessonName")->text(), QStringLiteral("Mine"));
        QCOMPARE(part<QPlainTextEdit>(program, "lessonStepText")->toPlainText(),
                 QString()); // no word that nobody wrote
        QCOMPARE(strokesOf(program), 1);
        QCOMPARE(lessons->count(), 3);
        press(program, "lessonSave");
        QVERIFY(question(program, "problem")->text().contains(QStringLiteral("has no text yet")));
        question(program, "problem")->close();
        QVERIFY(isKept(left));
        press(program, "lessonClose");
        question(program, "lessonQuestion")->button(QMessageBox::Discard)->click();
        QTRY_VERIFY_WITH_TIMEOUT(!isKept(left), longestWait);
    }

    /// Steps change places, a text in one language is another one, and recording goes on from the end of what was
    /// opened.
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
        QTRY_COMPARE_WITH_TIMEOUT(steps->count(), 4, longestWait);
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
        QTRY_VERIFY_WITH_TIMEOUT(isRecording(program) && rests(program), longestWait);
        press(program, "lessonNewStep");
        stroke(program, {25, 25});
        write(program, "Neu", "Noch etwas.");
        saveAndWait(program, path);
        const core::Lesson lesson = core::readLesson(toPath(path));
        QCOMPARE(lesson.steps.size(), std::size_t(4));
        QCOMPARE(lesson.steps[2].text.in("de"), std::string("Anders."));
        QVERIFY(lesson.steps[2].text.in("en") != "Anders.");
        QCOMPARE(lesson.steps[3].text.in("en"), std::string("Noch etwas.")); // no other is there
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

    /// What cannot be done on what is left of the model is said by its step and stroke.
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

    /// One sentence, and nothing on disk.
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
        QTRY_VERIFY_WITH_TIMEOUT(program.document.job().isBusy(), longestWait);
        program.window.action(QStringLiteral("edit.stop"))->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!program.document.job().isBusy(), longestWait);
        QVERIFY(notice(program).contains(QStringLiteral("was not written")));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    /// Another model ends the recording, and what was recorded stays; a window with an unsaved lesson asks before it
    /// closes.
    void unsaved_isAskedFor()
    {
        Program program;
        show(program);
        record(program, static_cast<int>(core::Starter::Ball));
        stroke(program, {30, 12});
        answerQuestion(program, QMessageBox::Discard);
        program.document.opener().openStarter(core::Starter::Cube);
        QTRY_VERIFY_WITH_TIMEOUT(!isRecording(program) && rests(program), longestWait);
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
