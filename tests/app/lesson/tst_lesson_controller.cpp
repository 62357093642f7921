// Tests lessons in the real window: playing, trying, checking and leaving them.
#include "app/lesson/lesson_handout.h"
#include "app/lesson/lesson_messages.h"
#include "tests/app/lesson/lesson_window.h"
#include "tests/support/ask_worker.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "core/io/mesh_io.h"
#include "core/lesson/lesson_playback.h"
#include "tests/support/effort.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/settings/settings.h"
#include "ui/widgets/side_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace app;

namespace
{
const std::filesystem::path lessonsFolder = FETTLE_SOURCE_DIR "/resources/lessons";

QString marks(Program& program)
{
    return part<QLabel>(program, "lessonMarks")->text();
}

/// Opens a bundled lesson at its first step, at four times the teacher's speed. From then on the view is not painted,
/// which saves more than half of the time.
void begin(Program& program, const QString& title)
{
    program.window.resize(900, 560);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.window.action(QStringLiteral("help.lessons"))->trigger();
    QTRY_VERIFY(part<ui::SidePanel>(program, "lessonPanel")->isVisible());
    for (QPushButton* card : program.window.findChild<ui::LessonPanel*>()->findChildren<QPushButton*>())
        if (card->text() == title)
            card->click();
    QTRY_VERIFY(part<QLabel>(program, "lessonTitle")->text().startsWith(title));
    QTRY_VERIFY(!program.document.job().isBusy() && program.window.viewport()->stats().patches > 0);
    auto* speed = program.window.findChild<ui::LessonPanel*>()->findChild<QComboBox*>();
    speed->setCurrentIndex(speed->count() - 1);
    program.window.viewport()->setUpdatesEnabled(false);
}

bool isAtStep(Program& program, int step)
{
    return part<QLabel>(program, "lessonTitle")->text().contains(QStringLiteral("step %1 of").arg(step));
}

bool isPlaying(Program& program)
{
    return part<QPushButton>(program, "lessonPlay")->text() != ui::LessonPanel::tr("Show Me");
}

void showStep(Program& program)
{
    press(program, "lessonPlay");
    QTRY_VERIFY(isPlaying(program));
    QTRY_VERIFY(!isPlaying(program) && program.document.queue().isSettled() && !program.document.job().isBusy());
}

bool isSettled(Program& program)
{
    return program.document.queue().isSettled() && !program.document.job().isBusy();
}

/// Goes to the third step of the mug and requests the teacher's model for it. Returns while the teacher is still
/// playing the first two steps.
void beginOnTheWay(Program& program)
{
    begin(program, QStringLiteral("A mug with a handle"));
    for (int step = 2; step <= 3; ++step) {
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, step));
    }
    QSignalSpy steps(&program.document, &Document::stepped);
    press(program, "lessonTeachers");
    QVERIFY(steps.wait(longestWait));
}

/// Returns the number of text pieces on each page of a PDF. Each line is one piece.
std::vector<qsizetype> linesOfPages(const QByteArray& pdf)
{
    std::vector<qsizetype> lines;
    for (qsizetype at = 0; (at = pdf.indexOf("\nstream\n", at)) >= 0;) {
        at += 8;
        if (pdf[at] != 'x') // not a compressed stream
            continue;
        const QByteArray length(4, '\x7f'); // upper bound of the uncompressed length, which qUncompress() needs
        const QByteArray content = qUncompress(length + pdf.mid(at, pdf.indexOf("\nendstream", at) - at));
        if (content.contains("\nBT\n"))
            lines.push_back(content.count("\nBT\n"));
    }
    return lines;
}

std::uint64_t teachersHash(const char* name, std::size_t steps)
{
    core::LessonPlayback playback(std::make_shared<const core::Lesson>(core::readLesson(lessonsFolder / name)),
                                  lessonsFolder);
    for (std::size_t i = 0; i < steps; ++i) {
        playback.goTo(i);
        playback.finish();
    }
    return playback.mesh().meshHash();
}
} // namespace

class TestLessonController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    /// Played strokes and commands use the window's stroke path and must give the same bits as core alone. The panel
    /// must report that the pupil has not done anything.
    void shown_isTheTeachersModelToTheBit()
    {
        Program program;
        begin(program, QStringLiteral("A creature to print"));
        for (std::size_t step = 1; step <= 4; ++step) {
            showStep(program);
            QCOMPARE(meshHash(program.worker), teachersHash("creature", step));
            QTRY_VERIFY(marks(program).contains(QStringLiteral("○ This is the teacher's model")));
            QVERIFY(!marks(program).contains(QStringLiteral("✓")));
            QCOMPARE(part<QPushButton>(program, "lessonNext")->text(),
                     step < 4 ? QStringLiteral("Next") : QStringLiteral("Finish"));
            if (step < 4)
                press(program, "lessonNext");
        }
    }

    /// The pupil's own strokes are kept until they are undone, and are checked against the goals.
    void tried_isThePupils()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        const std::uint64_t start = meshHash(program.worker);
        showStep(program);
        QVERIFY(program.document.history().stack().index() > 0);
        press(program, "lessonTry");
        QTRY_COMPARE(program.document.history().stack().index(), 0);
        QCOMPARE(meshHash(program.worker), start);
        QTRY_VERIFY(marks(program).contains(QStringLiteral("○ at least 125 mm tall (now 100 mm)")));
        QVERIFY(marks(program).contains(QStringLiteral("○ something sculpted in this step")));
        drag(program.window.viewport(), {30, 0});
        QTRY_COMPARE(program.document.history().stack().count(), 1);
        QVERIFY(meshHash(program.worker) != start);
        QTRY_VERIFY(marks(program).contains(QStringLiteral("✓ something sculpted in this step")));
        showStep(program);
        QCOMPARE(meshHash(program.worker), teachersHash("first-clay", 1));
    }

    /// Goals keep their lines in pale colour while they are measured, so that no button moves, even in the panels
    /// below.
    void marks_moveNoButton()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        auto* goals = part<QLabel>(program, "lessonMarks");
        const auto places = [&program] {
            QList<QPoint> all;
            for (const char* panel : {"lessonPanel", "brushPanel"})
                for (const QAbstractButton* button : part<QWidget>(program, panel)->findChildren<QAbstractButton*>())
                    if (button->isVisible())
                        all << button->mapTo(&program.window, QPoint());
            return all;
        };
        QTRY_VERIFY(goals->isEnabled() && !goals->text().isEmpty());
        const QList<QPoint> before = places();
        connect(program.window.findChild<ui::LessonPanel*>(), &ui::LessonPanel::changed, this, [&] {
            QVERIFY(!goals->text().isEmpty());
            QCOMPARE(goals->text().count(QLatin1Char('\n')) > 0, !goals->text().contains(QStringLiteral("teacher's")));
        });
        const auto isMeasuredInPlace = [&] {
            QTRY_VERIFY(!goals->isEnabled());
            QTest::qWait(1); // waits for the layout
            QCOMPARE(places(), before);
            QTRY_VERIFY(goals->isEnabled() && isSettled(program));
            QTest::qWait(1);
            QCOMPARE(places(), before);
        };
        drag(program.window.viewport(), {30, 0});
        isMeasuredInPlace();
        press(program, "lessonPlay");
        isMeasuredInPlace();
        QVERIFY(goals->text().contains(QStringLiteral("This is the teacher's model")));
        press(program, "lessonTry");
        isMeasuredInPlace();
        const QList<QPoint> navigation{part<QWidget>(program, "lessonBack")->pos(),
                                       part<QWidget>(program, "lessonNext")->pos()};
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 2));
        QTest::qWait(1);
        QCOMPARE(part<QWidget>(program, "lessonBack")->pos(), navigation.front());
        QCOMPARE(part<QWidget>(program, "lessonNext")->pos(), navigation.back());
    }

    /// The pupil's stroke ends the teacher's stroke and is complete itself.
    void hand_endsTheTeachersStroke()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        part<QPushButton>(program, "lessonPlay")->click();
        QTRY_VERIFY(program.worker.strokes().isOpen());
        drag(program.window.viewport(), {30, 10});
        QVERIFY(!isPlaying(program));
        QTRY_VERIFY(program.document.queue().isSettled() && !program.worker.strokes().isOpen());
        QCOMPARE(program.document.history().stack().count(), 2);
    }

    /// Only the tools of the current step are enabled, and the key for Smooth must not select it otherwise.
    void tools_areTheStepsOwn()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        const auto isThere = [&program](const char* id) {
            return program.window.action(QLatin1StringView(id))->isEnabled();
        };
        QVERIFY(isThere("tool.pull") && !isThere("tool.stamp") && !isThere("tool.smooth"));
        QTest::keyClick(&program.window, Qt::Key_4); // key for Smooth
        QCOMPARE(program.window.brush()->tool(), core::Tool::Pull);
        program.document.opener().openStarter(core::Starter::Ball);
        QTRY_VERIFY(isThere("tool.stamp"));
    }

    /// A teacher's stroke remains the teacher's after undo and redo. The pupil's own stroke counts as the pupil's.
    void redone_isStillTheTeachers()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        const QString teachers = QStringLiteral("○ This is the teacher's model"),
                      untouched = QStringLiteral("○ something sculpted"), own = QStringLiteral("✓ something sculpted");
        showStep(program);
        QTRY_VERIFY(marks(program).contains(teachers));
        program.document.history().undo();
        QTRY_VERIFY(marks(program).contains(untouched));
        program.document.history().redo();
        QTRY_VERIFY(marks(program).contains(teachers));
        press(program, "lessonTry");
        QTRY_VERIFY(marks(program).contains(untouched));
        program.document.history().redo();
        QTRY_VERIFY(marks(program).contains(teachers));
        press(program, "lessonTry");
        QTRY_VERIFY(marks(program).contains(untouched));
        drag(program.window.viewport(), {30, 0});
        QTRY_VERIFY(marks(program).contains(own));
    }

    /// Next completes a step that the teacher has begun, whether it is playing, paused, or played stroke by stroke.
    void next_whileTheTeacherWorks_doesTheWholeStep()
    {
        Program program;
        begin(program, QStringLiteral("A creature to print"));
        press(program, "lessonPlay");
        QTRY_VERIFY(program.worker.strokes().isOpen());
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 2));
        QCOMPARE(meshHash(program.worker), teachersHash("creature", 1));
        QVERIFY(!isPlaying(program));
        press(program, "lessonOne");
        QTRY_COMPARE(program.document.history().stack().count(), 3);
        QTRY_VERIFY(!isPlaying(program));
        press(program, "lessonNext");
        press(program, "lessonNext"); // a second press while the first is in progress
        QTRY_VERIFY(isAtStep(program, 3));
        QTest::qWait(100);
        QVERIFY(isAtStep(program, 3));
        QCOMPARE(meshHash(program.worker), teachersHash("creature", 2));
    }

    /// Pause and One Stroke cancel Next while the teacher completes the step. The step remains half done, and Next can
    /// be pressed again.
    void next_canBeTakenBack()
    {
        Program program;
        begin(program, QStringLiteral("A mug with a handle"));
        for (const char* button : {"lessonPlay", "lessonOne"}) {
            press(program, "lessonTry");
            QTRY_VERIFY(isSettled(program) && program.document.history().stack().index() == 0);
            press(program, "lessonPlay");
            QTRY_VERIFY(program.worker.strokes().isOpen());
            press(program, "lessonNext");
            press(program, button);
            QCOMPARE(isPlaying(program), button == QByteArray("lessonOne"));
            QTRY_VERIFY(!isPlaying(program));
            QTest::qWait(100);
            QVERIFY(isAtStep(program, 1));
        }
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 2));
        QCOMPARE(meshHash(program.worker), teachersHash("mug", 1));
    }

    /// Next continues after an unmet goal and reports it. The teacher's model can be loaded as undoable steps, so that
    /// the pupil's model is not lost.
    void unmet_canGoOnFromTheTeachersModel()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        QVERIFY(!part<QPushButton>(program, "lessonTeachers")->isEnabled());
        drag(program.window.viewport(), {30, 10});
        QTRY_COMPARE(program.document.history().stack().count(), 1);
        const std::uint64_t pupils = meshHash(program.worker);
        QTRY_VERIFY(marks(program).contains(QStringLiteral("✓ something sculpted")));
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 2));
        QVERIFY2(notice(program).contains(QStringLiteral("Step 1 is not done yet")), qPrintable(notice(program)));
        QCOMPARE(meshHash(program.worker), pupils);
        press(program, "lessonTeachers");
        QTRY_VERIFY(meshHash(program.worker) == teachersHash("first-clay", 1) && program.document.queue().isSettled() &&
                    !program.document.job().isBusy());
        QTRY_VERIFY(marks(program).contains(QStringLiteral("○ something sculpted in this step")));
        showStep(program);
        QCOMPARE(meshHash(program.worker), teachersHash("first-clay", 2));
        press(program, "lessonTry");
        QTRY_COMPARE(meshHash(program.worker), teachersHash("first-clay", 1));
        program.document.history().goTo(1);
        QTRY_COMPARE(meshHash(program.worker), pupils);
    }

    /// The page after the last step counts the goals that the pupil met, not the teacher, suggests what to do next, and
    /// enables all tools. Later strokes do not change it.
    void end_saysWhatWasAchieved()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        auto* goals = part<QLabel>(program, "lessonMarks");
        qsizetype met = 0, asked = 0;
        for (int step = 1; step <= 4; ++step) {
            if (step == 2)
                showStep(program);
            else
                drag(program.window.viewport(), {30, 0});
            QTRY_VERIFY(!goals->isEnabled());
            QTRY_VERIFY(goals->isEnabled());
            const qsizetype holding = goals->text().count(QChar(0x2713));
            met += holding;
            asked += step == 2 ? 5 : holding + goals->text().count(QChar(0x25CB));
            QVERIFY(step == 2 ? holding == 0 : holding > 0);
            press(program, "lessonNext");
            if (step < 4)
                QTRY_VERIFY(isAtStep(program, step + 1));
        }
        const auto* text = part<QLabel>(program, "lessonText");
        const QString achieved = QStringLiteral("You met %1 of %2 goals.").arg(met).arg(asked);
        QTRY_VERIFY(text->text().startsWith(achieved));
        QVERIFY(text->text().contains(QStringLiteral("export")));
        QCOMPARE(part<QLabel>(program, "lessonTitle")->text(), QStringLiteral("First clay: a pear"));
        QCOMPARE(goals->text().count(QLatin1Char('\n')), 3);
        QVERIFY(goals->text().contains(QStringLiteral("○ Push a hollow: 0 of 5")));
        for (const char* button : {"lessonPlay", "lessonOne", "lessonTry", "lessonTeachers", "lessonNext"})
            QVERIFY2(!part<QPushButton>(program, button)->isEnabled(), button);
        QVERIFY(program.window.action(QStringLiteral("tool.clay"))->isEnabled());
        QSignalSpy steps(&program.document, &Document::stepped);
        drag(program.window.viewport(), {0, 30});
        QVERIFY(!steps.isEmpty() || steps.wait(longestWait));
        QTest::qWait(1500); // long enough for a new measurement
        QVERIFY(text->text().startsWith(achieved));

        press(program, "lessonBack");
        QTRY_VERIFY(isAtStep(program, 4));
        QVERIFY(!program.window.action(QStringLiteral("tool.clay"))->isEnabled());
        program.window.action(QStringLiteral("file.exportAs"))->setVisible(false); // a class hides this command, too
        QTRY_VERIFY(goals->isEnabled());
        press(program, "lessonNext");
        QTRY_VERIFY(text->text().endsWith(QStringLiteral("goals. Keep sculpting, if you like.")));
    }

    /// A stroke while the teacher plays towards the step ends the playing. The panel stays at the same step.
    void stroke_onTheWay_staysInTheStep()
    {
        Program program;
        const QSignalSpy notices(&program.document, &Document::noticed);
        beginOnTheWay(program);
        drag(program.window.viewport(), {30, 0});
        QTRY_VERIFY(isSettled(program));
        const int count = program.document.history().stack().count();
        QVERIFY(count >= 2 && count < 7); // the teacher has six strokes in these steps
        QTRY_VERIFY(marks(program).contains(QStringLiteral("○ This is the teacher's model")));
        QVERIFY(!marks(program).contains(QStringLiteral("✓")));
        for (const QVariantList& notice : notices)
            QVERIFY2(!notice.front().toString().contains(QStringLiteral("like that already")), "nothing to reset");
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 4));
        QCOMPARE(program.document.history().stack().count(), count);
    }

    void back_onTheWay_goesBack()
    {
        Program program;
        beginOnTheWay(program);
        Q_EMIT program.window.findChild<ui::LessonPanel*>()->stepRequested(1);
        QTRY_VERIFY(isAtStep(program, 2));
        QTRY_VERIFY(isSettled(program) && program.document.history().stack().index() == 0);
    }

    /// Try and Show during the teacher's playing undo the unfinished part and start the step on its original model.
    void tryOrShow_onTheWay_beginTheStep()
    {
        Program program;
        begin(program, QStringLiteral("A mug with a handle"));
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 2));
        const std::uint64_t start = meshHash(program.worker);
        showStep(program);
        const std::uint64_t shown = meshHash(program.worker);
        press(program, "lessonTry");
        for (const bool shows : {false, true}) {
            QTRY_VERIFY(isSettled(program) && program.document.history().stack().index() == 0);
            QSignalSpy steps(&program.document, &Document::stepped);
            press(program, "lessonTeachers");
            QVERIFY(steps.wait(longestWait));
            if (!shows)
                press(program, "lessonTry");
        }
        showStep(program);
        QCOMPARE(meshHash(program.worker), shown);
        press(program, "lessonTry");
        QTRY_COMPARE(meshHash(program.worker), start);
        QVERIFY(isAtStep(program, 2));
    }

    void leave_onTheWay_stops()
    {
        Program program;
        beginOnTheWay(program);
        Q_EMIT program.window.findChild<ui::LessonPanel*>()->closed();
        QTRY_VERIFY(isSettled(program));
        QVERIFY(program.document.history().stack().count() < 6);
        QVERIFY(!part<QLabel>(program, "lessonText")->isVisible());
    }

    void leaving_givesTheBrushBack_data()
    {
        QTest::addColumn<bool>("shares");
        QTest::addColumn<bool>("quits");
        for (const bool shares : {true, false})
            for (const bool quits : {true, false})
                QTest::addRow("%s, %s", shares ? "one radius" : "radii", quits ? "quits" : "leaves") << shares << quits;
    }

    /// After the lesson, and at the next start, radius, strength and tool are the pupil's own again.
    void leaving_givesTheBrushBack()
    {
        QFETCH(bool, shares);
        QFETCH(bool, quits);
        constexpr double share = 0.15, strength = 0.9;
        {
            Program program;
            ui::BrushSettings& brush = *program.window.brush();
            brush.tools()->setSharesRadius(shares);
            for (const core::Tool tool : {core::Tool::Push, core::Tool::Grab}) {
                brush.setTool(tool);
                brush.setRadiusShare(share);
                brush.setValue(core::Parameter::Strength, strength);
            }
            ui::Settings().set(&ui::Setting::radiusShare, share);
            program.document.opener().openStarter(core::Starter::Ball);
            QTRY_VERIFY(isSettled(program) && program.document.modelInfo().size.maxCoeff() > 0);
            brush.setRadiusShare(share);
            begin(program, QStringLiteral("A mug with a handle"));
            QCOMPARE(brush.tool(), core::Tool::Push);
            QVERIFY(std::abs(brush.radiusShare() - share) > 0.01);
            if (quits) {
                QVERIFY(program.window.close());
            } else {
                Q_EMIT program.window.findChild<ui::LessonPanel*>()->closed();
                QVERIFY(program.window.isVisible());
            }
            QCOMPARE(brush.tool(), core::Tool::Grab);
            QVERIFY(std::abs(brush.radiusShare() - share) < 1e-6);
            QCOMPARE(brush.tools()->of(core::Tool::Push).strength, strength);
            if (!shares)
                QVERIFY(std::abs(brush.tools()->of(core::Tool::Push).radiusShare.value_or(0) - share) < 1e-6);
            if (!quits)
                return;
        }
        Program next;
        const ui::ToolMemory& tools = *next.window.brush()->tools();
        QCOMPARE(tools.of(core::Tool::Push).strength, strength);
        if (!shares)
            QVERIFY(std::abs(tools.of(core::Tool::Push).radiusShare.value_or(0) - share) < 1e-6);
        QVERIFY(std::abs(ui::Settings().get(&ui::Setting::radiusShare) - share) < 1e-6);
    }

    void base_hasOneUnit()
    {
        const QString goal = LessonMessages::goal(core::FactVerdict{{core::Fact::BaseArea, 1000}, 0.0, false});
        QCOMPARE(goal, QStringLiteral("flat base: at least 10.0 cm² (now 0.0 cm²)"));
    }

    /// The longest extent seen from above is not the width in the status bar, so its text must differ.
    void longestFromAbove_isNotCalledTheWidth()
    {
        const auto goalOf = [](core::Fact fact) {
            return LessonMessages::goal(core::FactVerdict{{fact, 120}, 100.0, false});
        };
        QCOMPARE(goalOf(core::Fact::Width), QStringLiteral("at least 120 mm wide (now 100 mm)"));
        QCOMPARE(goalOf(core::Fact::Widest), QStringLiteral("at least 120 mm long, seen from above (now 100 mm)"));
    }

    /// A text longer than a page continues on the next page and begins below the title.
    void handout_hasAllLines()
    {
        core::Lesson lesson = core::readLesson(lessonsFolder / "first-clay");
        lesson.steps.resize(1);
        std::string text;
        // number of lines, and the maximum of 13-point lines on a page of 261 mm
        constexpr qsizetype lines = 119, fit = 56;
        for (qsizetype line = 1; line <= lines; ++line)
            text += "line " + std::to_string(line) + "\n";
        lesson.steps.front().text = core::LessonText{{{"en", text}}};
        const std::vector<qsizetype> pages = linesOfPages(lessonHandout(lesson, QStringLiteral("en")));
        QVERIFY(pages.size() >= 3);
        qsizetype all = 0;
        for (const qsizetype page : pages) {
            QVERIFY2(page <= fit, qPrintable(QString::number(page)));
            all += page;
        }
        QVERIFY2(all >= lines + 3, qPrintable(QString::number(all))); // plus title, summary and the step's title
        QVERIFY(pages.front() > 10);
    }

    /// Each selected tool gets the teacher's radius and strength until the pupil changes them or leaves the lesson.
    void brush_isTheSteps()
    {
        Program program;
        const double before = program.window.brush()->tools()->of(core::Tool::Push).strength;
        begin(program, QStringLiteral("A mug with a handle"));
        const core::StrokeSettings& brush = program.window.brush()->stroke();
        QCOMPARE(brush.tool, core::Tool::Push);
        QCOMPARE(brush.radius, 40.0);
        QCOMPARE(brush.strength, 0.7);
        QCOMPARE(part<QLabel>(program, "lessonBrush")->text(), QStringLiteral("Brush: Push 40 mm (strength 0.7)"));
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 2));
        QCOMPARE(brush.tool, core::Tool::Flatten);
        QCOMPARE(brush.radius, 38.0);
        program.window.brush()->setTool(core::Tool::Push);
        QCOMPARE(brush.radius, 28.0);
        QCOMPARE(brush.strength, 1.4);
        program.window.brush()->setValue(core::Parameter::Radius, 20);
        QCOMPARE(brush.radius, 20.0);
        program.window.brush()->setTool(core::Tool::Smooth);
        QCOMPARE(brush.radius, 14.0);
        Q_EMIT program.window.findChild<ui::LessonPanel*>()->closed();
        QCOMPARE(program.window.brush()->tools()->of(core::Tool::Push).strength, before);
    }

    /// Each step is viewed from its own side, and all of its strokes are in view.
    void view_isTheSteps()
    {
        Program program;
        program.window.viewport()->setReducesMotion(true);
        const core::Lesson lesson = core::readLesson(lessonsFolder / "creature");
        begin(program, QStringLiteral("A creature to print"));
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            if (i > 0)
                press(program, "lessonNext");
            QTRY_VERIFY(isAtStep(program, static_cast<int>(i) + 1));
            const ui::OrbitCamera& camera = program.window.viewport()->camera();
            constexpr double degree = std::numbers::pi / 180;
            QVERIFY(std::abs(camera.pose().yaw - lesson.steps[i].view.value().yaw * degree) < 1e-6);
            QVERIFY(std::abs(camera.pose().pitch - lesson.steps[i].view->pitch * degree) < 1e-6);
            for (const core::FileEntry& entry : lesson.steps[i].strokes)
                if (const auto* const stroke = std::get_if<core::Stroke>(&entry))
                    for (const core::StrokeSample& sample : stroke->samples) {
                        const QPointF at(camera.project(sample.position).x(), camera.project(sample.position).y());
                        QVERIFY(QRectF(program.window.viewport()->rect()).contains(at));
                    }
        }
    }

    /// Strokes go all around the pear. The camera must follow, so that the model seldom hides the teacher's brush.
    void shown_isSeen()
    {
        Program program;
        program.window.viewport()->setReducesMotion(true);
        begin(program, QStringLiteral("First clay: a pear"));
        showStep(program);
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 2));
        press(program, "lessonTeachers");
        QTRY_VERIFY(isSettled(program) && meshHash(program.worker) == teachersHash("first-clay", 1));
        showStep(program);
        press(program, "lessonNext");
        QTRY_VERIFY(isAtStep(program, 3));
        ui::Viewport* const viewport = program.window.viewport();
        viewport->setUpdatesEnabled(true); // the camera moves from picture to picture
        int shown = 0, hidden = 0;
        connect(viewport, &ui::Viewport::teacherShown, this, [&](const std::optional<core::Sphere>& brush) {
            if (!brush)
                return;
            const core::Vec3 outward = brush->center - viewport->navigation()->box().center();
            ++shown;
            hidden += outward.normalized().dot(viewport->camera().viewDirection()) > 0.5 ? 1 : 0;
        });
        auto* speed = program.window.findChild<ui::LessonPanel*>()->findChild<QComboBox*>();
        speed->setCurrentIndex(2); // plays at the teacher's own speed
        showStep(program);
        QVERIFY(shown > 50);
        QVERIFY2(hidden < shown / 5, qPrintable(QStringLiteral("%1 of %2").arg(hidden).arg(shown)));
    }

    void oneStroke_isShownAlone()
    {
        Program program;
        begin(program, QStringLiteral("A creature to print"));
        for (int strokes = 1; strokes <= 2; ++strokes) {
            press(program, "lessonOne");
            QTRY_COMPARE(program.document.history().stack().count(), strokes);
            QTRY_VERIFY(!isPlaying(program) && program.document.queue().isSettled());
        }
        showStep(program); // plays the remaining strokes
        QCOMPARE(meshHash(program.worker), teachersHash("creature", 1));
    }

    /// The handout contains the texts and pictures of the open lesson. A missing folder is reported.
    void handout_isWritten()
    {
        const QTemporaryDir folder;
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        const auto write = [&program](const QString& path) {
            press(program, "lessonHandout");
            auto* dialog = part<QFileDialog>(program, "handoutDialog");
            QVERIFY(dialog);
            QCOMPARE(dialog->selectedFiles().value(0).section(u'/', -1), QStringLiteral("First clay – a pear.pdf"));
            Q_EMIT dialog->fileSelected(path);
            dialog->reject();
            QTRY_VERIFY(!part<QFileDialog>(program, "handoutDialog"));
        };
        const QString path = folder.filePath(QStringLiteral("pear.pdf"));
        write(path);
        QTRY_VERIFY(notice(program).contains(QStringLiteral("Saved pear.pdf.")));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().startsWith("%PDF-"));
        write(folder.filePath(QStringLiteral("no/pear.pdf")));
        QTRY_VERIFY(part<QMessageBox>(program, "problem"));
        QVERIFY(part<QMessageBox>(program, "problem")->text().contains(QStringLiteral("no/pear.pdf")));
        part<QMessageBox>(program, "problem")->accept();
        QVERIFY(!QFileInfo::exists(folder.filePath(QStringLiteral("no"))));
    }

    /// A lesson's own start model must equal core's bit for bit.
    void startFromAFile_isGiven()
    {
        core::Lesson lesson = core::readLesson(lessonsFolder / "first-clay");
        core::TriangleMesh start = core::starterModel(core::Starter::Ball);
        for (core::Vec3f& point : start.points)
            point *= 0.7F;
        const QTemporaryDir folder;
        const QString model = folder.filePath(QStringLiteral("start.stl")),
                      path = folder.filePath(QStringLiteral("lesson.zip"));
        core::writeMesh(model.toStdString(), start);
        std::ostringstream bytes;
        bytes << std::ifstream(model.toStdString(), std::ios::binary).rdbuf();
        lesson.files["start.stl"] = bytes.str();
        lesson.start = "start.stl";
        core::writeLesson(path.toStdString(), lesson);
        core::LessonPlayback playback(std::make_shared<const core::Lesson>(core::readLesson(path.toStdString())),
                                      path.toStdString());

        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        showStep(program);
        Q_EMIT program.window.findChild<ui::LessonPanel*>()->lessonChosen(path);
        answerQuestion(program, QMessageBox::Discard);
        QTRY_COMPARE(program.document.history().stack().count(), 0);
        QTRY_VERIFY(!program.document.job().isBusy());
        QCOMPARE(meshHash(program.worker), playback.mesh().meshHash());
        playback.finish();
        showStep(program);
        QCOMPARE(meshHash(program.worker), playback.mesh().meshHash());
    }

    void startPage_opensALesson()
    {
        Program program;
        program.window.resize(900, 560);
        program.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&program.window));
        program.window.action(QStringLiteral("help.start"))->trigger();
        part<QToolButton>(program, "start.lesson.mug")->click();
        QTRY_VERIFY(part<QLabel>(program, "lessonText")->isVisible());
        QVERIFY(part<QLabel>(program, "lessonTitle")->text().contains(QStringLiteral("mug"), Qt::CaseInsensitive));
    }

    void anotherModel_endsTheLesson()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        QVERIFY(part<QLabel>(program, "lessonText")->isVisible());
        program.document.opener().openStarter(core::Starter::Cube);
        QTRY_VERIFY(!part<QLabel>(program, "lessonText")->isVisible());
        QVERIFY(!isPlaying(program));
    }

    /// A lesson that cannot be read is reported in one sentence, and the open lesson stays unchanged.
    void badLesson_isToldAndNothingChanges()
    {
        Program program;
        begin(program, QStringLiteral("First clay: a pear"));
        showStep(program);
        const std::uint64_t before = meshHash(program.worker);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("bad.zip"));
        std::ofstream(path.toStdString(), std::ios::binary) << "PK and no more";
        Q_EMIT program.window.findChild<ui::LessonPanel*>()->lessonChosen(path);
        QMessageBox* box = nullptr;
        QTRY_VERIFY((box = program.window.findChild<QMessageBox*>()) && box->isVisible());
        QVERIFY(box->text().contains(QStringLiteral("bad.zip")));
        box->close();
        QCOMPARE(meshHash(program.worker), before);
        QVERIFY(part<QLabel>(program, "lessonText")->isVisible());
    }
};

FETTLE_TEST(TestLessonController, app::OnScreen)
#include "tst_lesson_controller.moc"
