#include "tests/support/ask_worker.h"
#include "tests/support/effort.h"
#include "tests/support/program_driver.h"
#include "tests/support/test_main.h"

#include "app/classroom/class_file.h"
#include "app/classroom/class_file_controller.h"
#include "app/classroom/class_pin.h"
#include "app/classroom/classroom_mode.h"
#include "app/classroom/turn_answers.h"
#include "app/classroom/work_archive.h"
#include "app/lesson/lesson_library.h"
#include "app/model/model_loader.h"

#include "core/io/mesh_io.h"
#include "core/io/stroke/stroke_file.h"
#include "core/journal/journal.h"
#include "core/lesson/checkpoint.h"
#include "core/primitives/starter_models.h"
#include "core/sculpt/sculptor.h"
#include "ui/actions/actions.h"
#include "ui/brush/brush_caption.h"
#include "ui/brush/color_panel.h"
#include "ui/classroom/classroom_lock.h"
#include "ui/classroom/pupil_name_panel.h"
#include "ui/classroom/questionnaire_panel.h"
#include "ui/classroom/waiting_works_dialog.h"
#include "ui/classroom/waiting_works_note.h"
#include "ui/help/help_text.h"
#include "ui/util/format_filters.h"
#include "ui/util/thread_mailbox.h"
#include "ui/widgets/side_column.h"

#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollArea>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolBar>
#include <QToolButton>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <iostream>
#include <utility>

using namespace app;

namespace
{
constexpr qint64 minute = 60'000;
const QString pin = QStringLiteral("2468");

QStringList foldersIn(const QString& path)
{
    return QDir(path).entryList(QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

QJsonObject turnIn(const QString& folder)
{
    QFile file(folder + QStringLiteral("/turn.json"));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

std::uint64_t hashOf(const QString& path)
{
    const LoadedModel model = ModelLoader::loadInPlace(path);
    return model.sculptor ? model.sculptor->mesh().meshHash() : 0;
}

/// Returns the mesh hash after replaying a record on a starter.
std::uint64_t replayed(core::Starter starter, const QString& record)
{
    const LoadedModel model = ModelLoader::starter(starter);
    for (const core::FileEntry& entry : core::readStrokes(record.toStdString())) {
        const auto& stroke = std::get<core::Stroke>(entry);
        model.sculptor->beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples)
            model.sculptor->addSample(sample);
        model.sculptor->endStroke();
    }
    return model.sculptor->mesh().meshHash();
}

/// The class folder, and the folders for the class on this computer.
struct Home
{
    explicit Home(const QString& path) : root(path)
    {
        QDir().mkpath(works);
        places = {(root + QStringLiteral("/journals")).toStdString(), root + QStringLiteral("/own/waiting"),
                  root + QStringLiteral("/own/turn.json")};
    }
    ui::Classroom classroomWithQuestions() const
    {
        ui::Classroom made = classroom();
        made.asksQuestions = true;
        return made;
    }
    ui::Classroom classroom() const
    {
        static const QString record = pinRecord(pin);
        return {QStringLiteral("5b"),
                works,
                {core::Starter::Ball, core::Starter::Torus},
                {core::Tool::Clay, core::Tool::Pull, core::Tool::Paint},
                20,
                3,
                false,
                ui::Language::System,
                record};
    }
    QString journals() const { return root + QStringLiteral("/journals"); }

    QString root, works = root + QStringLiteral("/works");
    ClassPaths places;
};

/// The program in class mode, as main() assembles it. The view is not painted, which saves half of the time.
struct Class
{
    explicit Class(const Home& home) : Class(home, home.classroom()) {}
    Class(const Home& home, const ui::Classroom& classroom)
        : store(home.places.journals)
        , mode({&program.window, &program.document, &store}, classroom, home.places, [this] { return now; })
    {
        program.document.journaling().setRecoveryStore(&store);
        connectClassroom(program.window, mode);
        program.window.resize(1100, 760);
        program.window.viewport()->setUpdatesEnabled(false);
        program.window.show();
    }

    template <class Part> Part* part(const char* name) const
    {
        return program.window.findChild<Part*>(QLatin1StringView(name));
    }
    QString text(const char* label) const { return part<QLabel>(label)->text(); }
    bool isIdle()
    {
        return !program.document.job().isBusy() && program.document.queue().isSettled() &&
               program.document.modelInfo().faces > 0;
    }
    bool asks() const { return part<ui::PupilNamePanel>("namePanel")->isVisible(); }
    bool questions() const { return part<ui::QuestionnairePanel>("questionnairePanel")->isVisible(); }
    void nextWithQuestions()
    {
        press("classNext");
        QTRY_VERIFY(questions() && isIdle());
        QVERIFY(!asks());
    }
    void answer(int question, int points)
    {
        QTest::mouseClick(part<QToolButton>(qPrintable(QStringLiteral("question%1.%2").arg(question).arg(points))),
                          Qt::LeftButton);
    }

    void begin()
    {
        QVERIFY(QTest::qWaitForWindowExposed(&program.window));
        mode.begin();
        QTRY_VERIFY(asks() && isIdle());
    }
    void beginTurn(const QString& name, const char* starter = "new.ball")
    {
        QTest::mouseClick(part<QAbstractButton>((QByteArray("turn.") + starter).constData()), Qt::LeftButton);
        part<QLineEdit>("pupilName")->clear();
        QTest::keyClicks(part<QLineEdit>("pupilName"), name);
        QTest::keyClick(part<QLineEdit>("pupilName"), Qt::Key_Return);
        QTRY_VERIFY(!asks() && isIdle() && text("classPupil") == name);
    }
    void sculptAs(const QString& name, const char* starter = "new.ball")
    {
        beginTurn(name, starter);
        sculpt();
    }
    void sculpt(const QPoint& way = {40, 20})
    {
        const int before = program.document.history().stack().index();
        drag(program.window.viewport(), way);
        QTRY_COMPARE(program.document.history().stack().index(), before + 1);
        QTRY_VERIFY(isIdle());
    }
    void trigger(const char* id)
    {
        program.window.action(QLatin1StringView(id))->trigger();
        QTRY_VERIFY(isIdle());
    }
    void press(const char* button) { QTest::mouseClick(part<QPushButton>(button), Qt::LeftButton); }
    void next()
    {
        press("classNext");
        QTRY_VERIFY(asks() && isIdle());
    }
    void typePin(const QString& text)
    {
        QTRY_VERIFY(part<QDialog>("pinDialog") && part<QDialog>("pinDialog")->isVisible());
        QTest::keyClicks(part<QLineEdit>("pin"), text);
        QTest::keyClick(part<QLineEdit>("pin"), Qt::Key_Return);
    }
    std::uint64_t hash() { return meshHash(program.worker); }

    qint64 now = 0;
    RecoveryStore store;
    Program program;
    ClassroomMode mode;
};

/// Returns the question in the PIN dialog, or an empty text if the dialog is closed.
QString pinQuestion(const Class& c)
{
    const auto* dialog = c.part<QDialog>("pinDialog");
    return dialog ? dialog->findChild<QLabel*>()->text() : QString();
}

/// Returns the class with a lesson and the lesson's tools.
ui::Classroom withLesson(ui::Classroom classroom, bool hasStarters)
{
    classroom.lesson = QStringLiteral("first-clay");
    classroom.tools << core::Tool::Push << core::Tool::Smooth << core::Tool::SnakeHook;
    if (!hasStarters)
        classroom.starters.clear();
    return classroom;
}

/// Counts how often a widget is shown.
class ShowCount : public QObject
{
public:
    explicit ShowCount(QWidget* watched) { watched->installEventFilter(this); }
    int count = 0;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        count += event->type() == QEvent::Show ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }
};

/// State that must be equal at the beginning of each turn.
struct Beginning
{
    explicit Beginning(const Class& c)
        : brush(c.program.window.brush()->stroke())
        , smooth(c.program.window.brush()->tools()->of(core::Tool::Smooth))
        , sharesRadius(c.program.window.brush()->tools()->sharesRadius())
        , swatches(c.program.window.findChild<ui::ColorPanel*>()->swatches())
        , switches(ui::switchesOf(c.program.window.commands()))
        , view(c.program.window.viewport()->camera().saved())
    {}
    bool operator==(const Beginning& other) const
    {
        const auto parts = [](const core::StrokeSettings& s) {
            return std::tuple(s.tool, s.brush, s.topology, s.symmetry, s.radial, s.radius, s.strength, s.falloff,
                              s.detail, s.spacing, s.fusion, s.add, s.color, s.alpha, s.model);
        };
        return parts(brush) == parts(other.brush) && smooth == other.smooth && sharesRadius == other.sharesRadius &&
               swatches == other.swatches && switches == other.switches && view.yaw == other.view.yaw &&
               view.pitch == other.view.pitch && view.target == other.view.target &&
               view.distance == other.view.distance;
    }

    core::StrokeSettings brush;
    ui::ToolValues smooth;
    bool sharesRadius;
    QList<core::Rgb> swatches;
    QHash<QString, bool> switches;
    core::SavedView view;
};

/// Changes every setting that a pupil could leave changed.
void leaveTraces(Class& c)
{
    ui::MainWindow& window = c.program.window;
    for (const char* id : {"symmetry.on", "symmetry.radial", "brush.steady", "view.flat", "material.wax",
                           "view.orthographic", "brush.ray", "tool.paint", "view.top"})
        window.action(QLatin1StringView(id))->trigger();
    window.brush()->set(&core::StrokeSettings::color, core::Rgb{1, 2, 3});
    window.brush()->setValue(core::Parameter::Strength, 2);
    window.brush()->scaleRadius(2);
    ui::ToolValues values = window.brush()->tools()->of(core::Tool::Smooth);
    values.strength = 0.1;
    window.brush()->tools()->set(core::Tool::Smooth, values);
    window.brush()->tools()->setSharesRadius(false);
    window.findChild<ui::ColorPanel*>()->swap();
    window.findChild<ui::ColorPanel*>()->reset({{9, 9, 9}});
}

/// Returns whether a panel is only for sculpting. All other panels give access to files, printers or steps of other
/// pupils.
bool isForTheHand(const ui::SidePanel* panel)
{
    const QStringList names{QStringLiteral("brushPanel"),     QStringLiteral("topologyPanel"),
                            QStringLiteral("symmetryPanel"),  QStringLiteral("colorPanel"),
                            QStringLiteral("turntablePanel"), QStringLiteral("modelPanel"),
                            QStringLiteral("presetPanel")};
    return names.contains(panel->objectName());
}

/// Returns the open windows other than the main window.
QList<QWidget*> otherWindows(const Class& c)
{
    QList<QWidget*> others;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->isVisible() && widget != &c.program.window)
            others << widget;
    return others;
}

/// Appends the visible entries of a menu and its submenus.
void addChoices(const QMenu* menu, QList<QAction*>* choices)
{
    for (QAction* action : menu->actions()) {
        if (!action->isVisible() || action->isSeparator())
            continue;
        if (action->menu())
            addChoices(action->menu(), choices);
        else
            choices->append(action);
    }
}
} // namespace

/// Tests a class in the real window: each work is kept, turns leave nothing behind, and only the teacher can leave.
class TestClassroom : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }
    void twentyFiveTurns_areKept();
    void aTurnBegins_asTheClassDid();
    void aMistakenPress_isTakenBack();
    void resuming_withoutAChangeKeepsOneWork();
    void returnBegins_whereverTheFocusIs();
    void theProjectorsClock_saysWhoIsNext();
    void names_areChosenFromTheList();
    void noOtherName_ifTheTeacherSaysSo();
    void aLesson_isGivenInATurn_data();
    void aLesson_isGivenInATurn();
    void aLesson_leadsNowhereElse();
    void stopping_leavesNobodyWithoutClay();
    void theClock_warnsAndTakesNothing();
    void aMissingFolder_isSaidAtOnce();
    void noRoomAnywhere_keepsTheModelOpen();
    void noCommand_leadsOut_data();
    void noCommand_leadsOut();
    void menus_haveOnlyWhatIsAllowed();
    void theGuide_leadsNowhereElse();
    void nothingCanBeDropped();
    void closing_takesThePin();
    void theTeachersDialog_writesTheFile();
    void theTeachersDialog_changesAFile_data();
    void theTeachersDialog_changesAFile();
    void theTeachersDialog_movesWhatWaits();
    void theClass_beginsWhenTheWindowIsClosed();
    void theClass_doesNotBeginForWhoStays();
    void questions_comeOnlyIfTheTeacherWants();
    void answers_areKeptWithTheWork();
    void skipping_keepsNothing();
    void keys_answerAndChooseNoTool();
    void aSmallWindow_hasAllInReach();
    void aSmallWindow_hasAllBars();
    void stopping_keepsTheForm();
    void eachPanel_opensOnce();
    void aFailedAnswer_isWrittenAtDone();
    void aSlowDelivery_holdsNoAnswerBack();
    void resuming_fromTheQuestions();
    void leaving_saysWhatWaits();
    void leaving_saysWhetherAWorkIsOpen();
    void leaving_doesNotWaitForEver();
    void leaving_keepsWhatWasAnswered();
    void aPowerCutInTheQuestions_losesNothing();
    void aPowerCutInALesson_keepsItsResult();
    void aPowerCut_losesNobodysWork_data();
    void aPowerCut_losesNobodysWork();
};

void TestClassroom::twentyFiveTurns_areKept()
{
    const int turns = byEffort(10, 25); // the tenth turn repeats a name
    const QTemporaryDir root;
    const Home home(root.path());
    QList<std::uint64_t> hashes;
    QStringList names;
    {
        Class c(home);
        c.begin();
        for (int i = 0; i < turns; ++i) {
            names << (i % 5 == 4 ? QStringLiteral("Anna") : QStringLiteral("Pupil %1").arg(i));
            c.beginTurn(names.last(), i % 2 == 0 ? "new.ball" : "new.torus");
            if (QTest::currentTestFailed())
                return;
            QCOMPARE(c.program.document.history().stack().count(), 0);
            for (int stroke = 0; stroke <= i % 3; ++stroke)
                c.sculpt({10 + 5 * i, 20 * stroke});
            if (i % 4 == 3) { // records must not contain undone strokes
                c.trigger("edit.undo");
                c.sculpt({-50, -30 - 2 * i});
            }
            hashes << c.hash();
            c.next();
            if (QTest::currentTestFailed())
                return;
        }
        QTRY_COMPARE(foldersIn(home.works).size(), turns);
        QTRY_COMPARE(foldersIn(home.places.outbox), QStringList());
        QTRY_COMPARE(foldersIn(home.journals()).size(),
                     1); // journal of the starter model that is prepared for the next pupil
    }
    QCOMPARE(foldersIn(home.journals()), QStringList());
    QStringList kept;
    for (const QString& name : foldersIn(home.works)) {
        const QString folder = home.works + u'/' + name;
        const QJsonObject turn = turnIn(folder);
        const std::uint64_t hash = turn.value(QStringLiteral("mesh_hash")).toString().toULongLong(nullptr, 16);
        const qsizetype i = hashes.indexOf(hash);
        QVERIFY2(i >= 0, qPrintable(name));
        QCOMPARE(turn.value(QStringLiteral("name")).toString(), names[i]);
        QCOMPARE(hashOf(folder + QStringLiteral("/model.glb")), hash);
        QCOMPARE(
            replayed(i % 2 == 0 ? core::Starter::Ball : core::Starter::Torus, folder + QStringLiteral("/record.json")),
            hash);
        QVERIFY(QFile::exists(folder + QStringLiteral("/picture.png")));
        kept << names[i];
    }
    kept.sort();
    names.sort();
    QCOMPARE(kept, names);
}

void TestClassroom::aTurnBegins_asTheClassDid()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.beginTurn(QStringLiteral("Anna"));
    const Beginning first(c);
    QCOMPARE(first.brush.tool, core::Tool::Clay);
    c.sculpt();
    leaveTraces(c);
    QVERIFY(!(Beginning(c) == first));
    QCOMPARE(c.program.window.brush()->stroke().tool, core::Tool::Paint);
    c.next();
    c.beginTurn(QStringLiteral("Ben"));
    QVERIFY(Beginning(c) == first);
    QVERIFY(!c.program.document.history().canUndo() && !c.program.document.history().canRedo() &&
            !c.program.document.savedState().isModified());
    QVERIFY(c.program.window.windowTitle().contains(QStringLiteral("Ben")));
    c.program.window.action(QStringLiteral("symmetry.on"))->trigger(); // the last used symmetry plane is reset, too
    QCOMPARE(c.program.window.brush()->stroke().symmetry, core::Symmetry::X);
    // a tool that the class does not allow is refused, however it is chosen
    c.program.window.brush()->setTool(core::Tool::Smooth);
    QCOMPARE(c.program.window.brush()->stroke().tool, core::Tool::Clay);
}

void TestClassroom::aMistakenPress_isTakenBack()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.sculptAs(QStringLiteral("Anna"), "new.torus");
    const std::uint64_t hash = c.hash();
    c.now += 5 * minute;
    c.next();
    QTRY_VERIFY(c.part<QPushButton>("classResume")->isVisible());
    QVERIFY(c.part<QPushButton>("classResume")->text().contains(QStringLiteral("Anna")));
    c.now += 2 * minute; // time between turns, which counts for no pupil
    c.press("classResume");
    QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("classPupil") == QStringLiteral("Anna"));
    QCOMPARE(c.hash(), hash);
    QVERIFY(c.program.document.modelInfo().path.isEmpty());
    c.mode.tick();
    QCOMPARE(c.text("classTime"), QStringLiteral("15 minutes left"));
    c.sculpt({-40, 30});
    const std::uint64_t later = c.hash();
    c.now += minute;
    c.next();
    c.beginTurn(QStringLiteral("Ben"));
    QTRY_VERIFY(c.part<QPushButton>("classResume")->isVisible());
    c.sculpt();
    // the bar also hides the button when it is laid out again
    QTRY_VERIFY(!c.part<QPushButton>("classResume")->isVisible());
    QTRY_VERIFY(foldersIn(home.works).size() == 2 &&
                !foldersIn(home.works).constFirst().startsWith(u'.')); // the earlier work stays in the class folder
    const QString folder = home.works + u'/' + foldersIn(home.works).last();
    QCOMPARE(hashOf(folder + QStringLiteral("/model.glb")), later);
    QCOMPARE(WorkArchive::turnOf(folder).seconds(), std::optional(6.0 * 60)); // 5 + 1 minutes, without the pause
    QCOMPARE(core::readStrokes((folder + QStringLiteral("/record.json")).toStdString()).size(), std::size_t(2));
}

/// Resume and then Next Pupil without a change keep one work, which can be resumed again.
void TestClassroom::resuming_withoutAChangeKeepsOneWork()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    const std::uint64_t hash = c.hash();
    c.now += 5 * minute;
    c.next();
    for (int i = 0; i < 2; ++i) {
        QTRY_VERIFY(c.part<QPushButton>("classResume")->isVisible());
        c.press("classResume");
        QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("classPupil") == QStringLiteral("Anna"));
        QCOMPARE(c.hash(), hash);
        c.now += 2 * minute;
        c.next();
    }
    c.press("classResume");
    QTRY_VERIFY(!c.asks() && c.isIdle());
    c.mode.tick();
    QCOMPARE(c.text("classTime"), QStringLiteral("11 minutes left")); // the turn's time has continued
    c.press("classLeave");
    c.typePin(pin);
    QTRY_VERIFY(!c.program.window.isVisible());
    QCOMPARE(foldersIn(home.works).size(), 1);
    QVERIFY(!turnIn(home.works + u'/' + foldersIn(home.works).constFirst())[QStringLiteral("computer")]
                 .toString()
                 .isEmpty());
}

/// Return begins the turn even after a click on a starter.
void TestClassroom::returnBegins_whereverTheFocusIs()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    auto* torus = c.part<QToolButton>("turn.new.torus");
    QTest::keyClicks(c.part<QLineEdit>("pupilName"), QStringLiteral("Anna"));
    QTest::mouseClick(torus, Qt::LeftButton);
    torus->setFocus();
    QTest::keyClick(torus, Qt::Key_Return);
    QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("classPupil") == QStringLiteral("Anna"));
    QCOMPARE(c.program.document.modelInfo().path, QString());
    c.sculpt();
    c.next();
    QTRY_COMPARE(foldersIn(home.works).size(), 1);
}

/// The projector window shows the current pupil, the remaining time and the next pupil.
void TestClassroom::theProjectorsClock_saysWhoIsNext()
{
    const QTemporaryDir root;
    const Home home(root.path());
    ui::Classroom classroom = home.classroom();
    classroom.names = {QStringLiteral("Anna"), QStringLiteral("Ben"), QStringLiteral("Cem")};
    Class c(home, classroom);
    c.program.window.viewport()->setMaximumSize(Program::anyView);
    c.begin();
    QVERIFY(!c.part<QWidget>("classClock")->isVisible());
    c.press("classClockButton");
    auto* clock = c.part<QWidget>("classClock");
    QTRY_VERIFY(clock->isVisible());
    QCOMPARE(clock->windowType(), Qt::Dialog); // with other window types, a click on the main window would hide it
    const QWidget* view = c.program.window.centralWidget();
    QVERIFY(QRect(view->mapToGlobal(QPoint()), view->size()).contains(clock->frameGeometry()));
    for (const char* used : {"beginTurn", "pupilName", "pupils", "turn.new.ball", "turn.new.torus"}) {
        const auto* widget = c.part<QWidget>(used);
        const QRect place(widget->mapToGlobal(QPoint()), widget->size());
        QVERIFY2(!place.intersects(clock->geometry()), used);
    }
    const QPoint place = clock->pos();
    sendMouse(clock, QEvent::MouseButtonPress, {20, 20}, Qt::LeftButton);
    sendMouse(clock, QEvent::MouseMove, {50, 35}, Qt::LeftButton);
    QTRY_COMPARE(clock->pos(), place + QPoint(30, 15));
    for (const char* label : {"clockPupil", "clockTime", "clockNext"}) {
        const auto* words = c.part<QLabel>(label);
        QVERIFY2(words->fontMetrics().horizontalAdvance(words->text()) <= words->width(), label);
    }
    QCOMPARE(c.text("clockNext"), QStringLiteral("Next: Anna"));
    c.program.window.activateWindow();
    c.sculptAs(QStringLiteral("Anna"));
    c.now += 61'000;
    c.mode.tick();
    QCOMPARE(c.text("clockPupil"), QStringLiteral("Anna"));
    QCOMPARE(c.text("clockTime"), QStringLiteral("18:59"));
    QCOMPARE(c.text("clockNext"), QStringLiteral("Next: Ben"));
    c.now = 20 * minute + 65'000;
    c.mode.tick();
    QCOMPARE(c.text("clockTime"), QStringLiteral("+1:05"));
    c.next();
    QTRY_VERIFY(c.part<QListWidget>("pupils")->item(0)->text().contains(u'✓'));
    QCOMPARE(c.text("clockNext"), QStringLiteral("Next: Ben"));
    QVERIFY(c.text("clockPupil").isEmpty() && c.text("clockTime").isEmpty());
    QTest::keyClick(c.part<QWidget>("classClock"), Qt::Key_Escape);
    QVERIFY(!c.part<QWidget>("classClock")->isVisible() && c.program.window.isVisible());
}

/// The teacher's list marks pupils who have had a turn. A guest can type a name.
void TestClassroom::names_areChosenFromTheList()
{
    const QTemporaryDir root;
    const Home home(root.path());
    ui::Classroom classroom = home.classroom();
    classroom.names = {QStringLiteral("Anna"), QStringLiteral("Ben, B."), QStringLiteral("Cem")};
    Class c(home, classroom);
    c.begin();
    auto* list = c.part<QListWidget>("pupils");
    QVERIFY(list->isVisible() && list->count() == 3 && c.part<QLineEdit>("pupilName")->isVisible());
    QVERIFY(!c.part<QPushButton>("beginTurn")->isEnabled());
    list->setCurrentRow(1);
    QCOMPARE(c.part<QLineEdit>("pupilName")->text(), QStringLiteral("Ben, B."));
    QTest::keyClick(list, Qt::Key_Return);
    QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("classPupil") == QStringLiteral("Ben, B."));
    c.sculpt();
    c.next();
    QTRY_VERIFY(list->item(1)->text().contains(u'✓'));
    QCOMPARE(list->item(0)->text(), QStringLiteral("Anna"));
    QVERIFY(list->selectedItems().isEmpty() && c.part<QLineEdit>("pupilName")->text().isEmpty());
    c.sculptAs(QStringLiteral("Guest"));
    c.next();
    list->setCurrentRow(1); // a pupil can have a second turn
    QCOMPARE(c.part<QLineEdit>("pupilName")->text(), QStringLiteral("Ben, B."));
}

void TestClassroom::noOtherName_ifTheTeacherSaysSo()
{
    const QTemporaryDir root;
    const Home home(root.path());
    ui::Classroom classroom = home.classroom();
    classroom.names = {QStringLiteral("Anna"), QStringLiteral("Ben")};
    classroom.allowsOthers = false;
    Class c(home, classroom);
    c.begin();
    QVERIFY(!c.part<QLineEdit>("pupilName")->isVisible());
    c.part<QListWidget>("pupils")->setCurrentRow(0);
    c.press("beginTurn");
    QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("classPupil") == QStringLiteral("Anna"));
}

void TestClassroom::aLesson_isGivenInATurn_data()
{
    QTest::addColumn<bool>("hasStarters");
    QTest::newRow("alone") << false;
    QTest::newRow("beside starters") << true;
}

/// The work keeps the reached step and its goals, and Resume continues from there.
void TestClassroom::aLesson_isGivenInATurn()
{
    QFETCH(const bool, hasStarters);
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, withLesson(home.classroom(), hasStarters));
    c.begin();
    QCOMPARE(c.part<QToolButton>("turn.lesson")->isVisible(), hasStarters);
    const auto* panel = c.part<ui::SidePanel>("lessonPanel");
    const QString step = QStringLiteral("First clay: a pear: step %1 of 4");
    const auto begin = [&](const QString& name) {
        c.part<QLineEdit>("pupilName")->clear();
        QTest::keyClicks(c.part<QLineEdit>("pupilName"), name);
        c.press("beginTurn");
        QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("classPupil") == name);
        QVERIFY(panel->isVisible());
        QCOMPARE(c.text("lessonTitle"), step.arg(1));
        QCOMPARE(c.part<QComboBox>("lessonSpeed")->currentIndex(), 2);
        QCOMPARE(c.program.window.brush()->tool(), core::Tool::Pull);
        QCOMPARE(c.program.window.brush()->stroke().radius, 42.0);
        QVERIFY(!c.program.window.action(QStringLiteral("tool.smooth"))->isEnabled());
    };
    begin(QStringLiteral("Anna"));
    c.part<QComboBox>("lessonSpeed")->setCurrentIndex(4);
    c.press("lessonPlay");
    QTRY_VERIFY(c.program.worker.strokes().isOpen());
    c.press("lessonNext"); // plays the rest of the step at once
    QTRY_COMPARE(c.text("lessonTitle"), step.arg(2));
    QCOMPARE(c.program.window.brush()->tool(), core::Tool::Push);
    const std::uint64_t hash = c.hash();
    c.next();
    QTRY_COMPARE(WorkArchive::worksIn(home.works).size(), 1);
    const QJsonObject kept =
        turnIn(WorkArchive::worksIn(home.works).constFirst()).value(QStringLiteral("lesson")).toObject();
    QCOMPARE(kept.value(QStringLiteral("lesson")).toString(), QStringLiteral("first-clay"));
    QCOMPARE(kept.value(QStringLiteral("step")).toInt(), 2);
    QVERIFY(!kept.value(QStringLiteral("teachers_model")).toBool());
    const QJsonArray goals = kept.value(QStringLiteral("goals")).toArray();
    const core::Lesson lesson = readLesson(QStringLiteral("first-clay"));
    const core::CheckpointVerdict verdict = core::evaluate(
        lesson.steps[1].checkpoint,
        core::readMesh(toPath(WorkArchive::worksIn(home.works).constFirst() + QStringLiteral("/model.glb"))), nullptr);
    QVERIFY(!verdict.isMet());
    QCOMPARE(goals.size(), static_cast<qsizetype>(verdict.facts.size()));
    for (qsizetype i = 0; i < goals.size(); ++i)
        QCOMPARE(goals[i].toObject().value(QStringLiteral("met")).toBool(),
                 verdict.facts[static_cast<std::size_t>(i)].holds);

    c.press("classResume");
    QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("lessonTitle") == step.arg(2));
    QVERIFY(panel->isVisible());
    QCOMPARE(c.hash(), hash);
    c.press("lessonPlay");
    c.press("lessonOne");
    QTRY_VERIFY(c.program.document.history().stack().count() > 0);
    c.next(); // Next Pupil is pressed while the teacher's strokes are playing
    QTRY_COMPARE(WorkArchive::worksIn(home.works).size(), 2);
    QVERIFY(turnIn(WorkArchive::worksIn(home.works).constLast())
                .value(QStringLiteral("lesson"))
                .toObject()
                .value(QStringLiteral("teachers_model"))
                .toBool());
    begin(QStringLiteral("Ben"));
    if (!hasStarters)
        return;
    c.next();
    c.beginTurn(QStringLiteral("Cem"), "new.torus");
    QVERIFY(!panel->isVisible());
    QCOMPARE(c.program.window.brush()->tool(), core::Tool::Clay);
    QVERIFY(c.program.window.action(QStringLiteral("tool.paint"))->isEnabled());
    for (const core::Tool tool : {core::Tool::Stamp, core::Tool::Mask})
        QVERIFY(!c.program.window.brush()->isOffered(tool));
    c.next();
    QTRY_COMPARE(WorkArchive::worksIn(home.works).size(), 4);
    for (const QString& folder : WorkArchive::worksIn(home.works))
        QCOMPARE(turnIn(folder).contains(QStringLiteral("lesson")), !folder.endsWith(QStringLiteral("Cem")));
}

/// The lesson panel, with or without an open lesson, must not give access to files or other lessons.
void TestClassroom::aLesson_leadsNowhereElse()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, withLesson(home.classroom(), true));
    c.begin();
    const QStringList allowed{QStringLiteral("lessonPlay"), QStringLiteral("lessonOne"),
                              QStringLiteral("lessonTry"),  QStringLiteral("lessonNext"),
                              QStringLiteral("lessonBack"), QStringLiteral("lessonTeachers")};
    const auto verifyLocked = [&] {
        for (const QPushButton* button : c.part<ui::SidePanel>("lessonPanel")->findChildren<QPushButton*>())
            QVERIFY2(allowed.contains(button->objectName()) || (!button->isEnabled() && !button->isVisible()),
                     qPrintable(button->text()));
    };
    c.beginTurn(QStringLiteral("Anna"), "lesson");
    verifyLocked();
    c.press("lessonNext");
    verifyLocked();
    c.next();
    c.beginTurn(QStringLiteral("Ben"), "new.ball");
    c.part<ui::SidePanel>("lessonPanel")->toggleViewAction()->trigger();
    QVERIFY(c.part<ui::SidePanel>("lessonPanel")->isVisible());
    QCOMPARE(c.text("lessonsHead"), QStringLiteral("This turn has no lesson."));
    verifyLocked();
    QVERIFY(otherWindows(c).isEmpty());
}

void TestClassroom::stopping_leavesNobodyWithoutClay()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    QTest::keyClicks(c.part<QLineEdit>("pupilName"), QStringLiteral("Anna"));
    QTest::keyClick(c.part<QLineEdit>("pupilName"), Qt::Key_Return);
    const auto stop = [&c] { // a cancelled job may be started again, and the name may be asked for again
        c.program.document.cancelJob();
        QTRY_VERIFY(c.isIdle());
        QTest::qWait(50);
        QTRY_VERIFY(c.isIdle());
    };
    stop();
    if (c.asks()) // otherwise the starter was complete before it could be cancelled
        c.sculptAs(QStringLiteral("Anna"));
    c.press("classNext");
    stop();
    QTRY_VERIFY(c.asks() && c.isIdle());
    c.sculptAs(QStringLiteral("Ben"));
    QTRY_COMPARE(foldersIn(home.works).size(), 1);
}

void TestClassroom::theClock_warnsAndTakesNothing()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.mode.tick();
    QVERIFY(c.text("classTime").isEmpty());
    c.sculptAs(QStringLiteral("Anna"));
    const auto at = [&c](qint64 ms) {
        c.now = ms;
        c.mode.tick();
        return c.text("classTime");
    };
    c.program.window.setHeadset(ui::HeadsetState::In, {});
    const auto& caption = *c.program.window.findChild<ui::BrushCaption*>();
    QCOMPARE(at(0), QStringLiteral("20 minutes left"));
    QVERIFY(caption.isVisible());
    QCOMPARE(caption.text().time, QStringLiteral("20 min"));
    QCOMPARE(caption.text().tool, QStringLiteral("Clay"));
    QCOMPARE(at(17 * minute - 1), QStringLiteral("4 minutes left"));
    QVERIFY(!c.part<QLabel>("classTime")->font().bold() && notice(c.program).isEmpty());
    QCOMPARE(at(17 * minute), QStringLiteral("3 minutes left"));
    QVERIFY(c.part<QLabel>("classTime")->font().bold() &&
            !c.part<QLabel>("classClock")->pixmap(Qt::ReturnByValue).isNull());
    QVERIFY(notice(c.program).contains(QStringLiteral("3 minutes left")));
    QVERIFY(caption.text().time == QStringLiteral("3 min") && caption.text().isNearEnd);
    const auto& countdown = *c.part<QLabel>("turnCountdown");
    QCOMPARE(at(19 * minute - 1), QStringLiteral("2 minutes left"));
    QVERIFY(!countdown.isVisible());
    QCOMPARE(at(19 * minute + 15'000), QStringLiteral("45 seconds left"));
    QVERIFY(countdown.isVisible() && countdown.text() == QStringLiteral("0:45"));
    QVERIFY(countdown.fontMetrics().height() > 2 * c.part<QLabel>("classTime")->fontMetrics().height());
    QCOMPARE(at(20 * minute), QStringLiteral("Time is up"));
    QCOMPARE(countdown.text(), QStringLiteral("Time is up  +0:00"));
    QVERIFY(notice(c.program).contains(QStringLiteral("Time is up")));
    QCOMPARE(caption.text().time, QStringLiteral("Time is up"));
    QCOMPARE(at(25 * minute + 5'000), QStringLiteral("Time is up"));
    QCOMPARE(countdown.text(), QStringLiteral("Time is up  +5:05"));
    QVERIFY(c.program.window.viewport()->rect().contains(countdown.geometry()));
    QVERIFY(countdown.testAttribute(Qt::WA_TransparentForMouseEvents)); // clicks reach the model below
    c.sculpt({30, -20});
    QCOMPARE(c.program.document.history().stack().count(), 2);
    c.next();
    c.beginTurn(QStringLiteral("Ben"));
    QCOMPARE(at(c.now), QStringLiteral("20 minutes left"));
    QVERIFY(!c.part<QLabel>("classTime")->font().bold() && !countdown.isVisible());
    // the beginning of a turn shows bars again, but must not change the headset's state
    QVERIFY(caption.isVisible() && !caption.text().isNearEnd);
    c.program.window.setHeadset(ui::HeadsetState::Out, {});
    QVERIFY(!caption.isVisible());
}

void TestClassroom::aMissingFolder_isSaidAtOnce()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    QVERIFY(QDir().rmdir(home.works));
    c.next();
    QTRY_VERIFY2(notice(c.program).startsWith(QStringLiteral("The class folder cannot be reached.")),
                 qPrintable(notice(c.program)));
    QVERIFY(!notice(c.program).contains(root.path())); // the notice must not show the path, because pupils read it
    QVERIFY(c.part<QLabel>("classWaiting")
                ->toolTip()
                .contains(QStringLiteral("the folder %1 does not exist").arg(home.works)));
    QCOMPARE(c.text("classWaiting"), QStringLiteral("1 models not yet in the class folder"));
    QVERIFY(c.part<QLabel>("classWaiting")->toolTip().contains(home.places.outbox));
    QCOMPARE(foldersIn(home.places.outbox).size(), 1);
    QVERIFY(QDir().mkpath(home.works)); // the folder is available again
    c.sculptAs(QStringLiteral("Ben"));
    c.next();
    QTRY_COMPARE(foldersIn(home.works).size(), 2);
    QTRY_VERIFY(c.text("classWaiting").isEmpty());
    QCOMPARE(foldersIn(home.places.outbox), QStringList());
}

void TestClassroom::noRoomAnywhere_keepsTheModelOpen()
{
    const QTemporaryDir root;
    Home home(root.path());
    home.places.outbox = QStringLiteral("/proc/none/waiting");
    Class c(home);
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    const std::uint64_t hash = c.hash();
    QVERIFY(QDir().rmdir(home.works));
    c.press("classNext");
    QTRY_VERIFY(c.part<QMessageBox>("problem") && c.part<QMessageBox>("problem")->isVisible());
    QVERIFY(c.part<QMessageBox>("problem")->text().contains(QStringLiteral("The work of Anna stays open")));
    c.part<QMessageBox>("problem")->accept();
    QVERIFY(!c.asks() && c.text("classPupil") == QStringLiteral("Anna"));
    QCOMPARE(c.hash(), hash);
    QVERIFY(c.program.document.savedState().isModified() && c.program.document.history().canUndo());
    QVERIFY(QDir().mkpath(home.works));
    c.next();
    QCOMPARE(hashOf(home.works + u'/' + foldersIn(home.works).constFirst() + QStringLiteral("/model.glb")), hash);
}

void TestClassroom::noCommand_leadsOut_data()
{
    QTest::addColumn<bool>("isTurn");
    QTest::newRow("while the name is asked") << false;
    QTest::newRow("in a turn") << true;
}

/// Tries each action that a class forbids, by each of its shortcuts and by code.
void TestClassroom::noCommand_leadsOut()
{
    QFETCH(bool, isTurn);
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    if (isTurn)
        c.beginTurn(QStringLiteral("Anna"));
    ui::MainWindow& window = c.program.window;
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const std::uint64_t hash = c.hash();
    int closed = 0;
    for (const ui::ActionInfo& row : ui::actionTable()) {
        QAction* action = window.action(QLatin1StringView(row.id));
        if (ui::isAllowed(row, home.classroom()))
            continue;
        ++closed;
        action->setEnabled(true); // other code enables actions, for example when a job ends
        QVERIFY2(!action->isEnabled() && !action->isVisible(), row.id);
        for (const QKeySequence& key : action->shortcuts()) {
            QTest::keySequence(&window, key);
            if (key == QKeySequence(Qt::Key_F1)) { // F1 opens the guide in a class
                QTRY_VERIFY(c.part<QDialog>("guide") && c.part<QDialog>("guide")->isVisible());
                c.part<QDialog>("guide")->reject();
            }
        }
        QTest::qWait(1);
        QVERIFY2(otherWindows(c).isEmpty(), row.id);
    }
    QVERIFY(closed > 40);
    for (const Qt::Key key : {Qt::Key_F11, Qt::Key_F10, Qt::Key_Menu, Qt::Key_Escape, Qt::Key_Print})
        QTest::keyClick(&window, key);
    QVERIFY(window.isVisible() && otherWindows(c).isEmpty());
    QVERIFY(c.isIdle() && c.program.document.modelInfo().path.isEmpty() &&
            !c.program.document.savedState().isModified());
    QCOMPARE(c.hash(), hash);
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        QVERIFY2(qobject_cast<const ui::SideColumn*>(dock) ||
                     (!dock->isVisible() && !dock->toggleViewAction()->isEnabled()),
                 qPrintable(dock->objectName()));
    for (const ui::SidePanel* panel : window.findChild<ui::SideColumn*>()->panels())
        QVERIFY2(isForTheHand(panel) || (!panel->isVisible() && !panel->toggleViewAction()->isEnabled()),
                 qPrintable(panel->objectName()));
    for (const char* name : {"presets.new", "presets.rename", "presets.delete", "presets.import", "presets.export"})
        QVERIFY2(window.findChild<QToolButton*>(QString::fromLatin1(name))->isHidden(), name);
    if (!isTurn) { // the model cannot be sculpted between turns
        const QPoint middle = window.viewport()->mapTo(&window, window.viewport()->rect().center() +
                                                                    QPoint(0, window.viewport()->height() / 4));
        QTest::mousePress(window.windowHandle(), Qt::LeftButton, {}, middle);
        QTest::mouseMove(window.windowHandle(), middle + QPoint(20, 0));
        QTest::mouseRelease(window.windowHandle(), Qt::LeftButton, {}, middle + QPoint(20, 0));
        QTRY_VERIFY(c.isIdle());
        QCOMPARE(c.program.document.history().stack().count(), 0);
    }
}

void TestClassroom::menus_haveOnlyWhatIsAllowed()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    ui::MainWindow& window = c.program.window;
    QList<QAction*> choices;
    for (const QAction* title : window.menuBar()->actions())
        if (title->isVisible())
            addChoices(title->menu(), &choices);
    QSet<QAction*> allowed;
    for (const ui::ActionInfo& row : ui::actionTable())
        if (ui::isAllowed(row, home.classroom()))
            allowed << window.action(QLatin1StringView(row.id));
    for (const ui::SidePanel* panel : window.findChild<ui::SideColumn*>()->panels())
        if (isForTheHand(panel))
            allowed << panel->toggleViewAction();
    QVERIFY(choices.size() > 30);
    for (QAction* choice : choices)
        QVERIFY2(allowed.contains(choice), qPrintable(choice->text()));
    QVERIFY(choices.contains(window.action(QStringLiteral("tool.clay"))) &&
            !choices.contains(window.action(QStringLiteral("tool.stamp"))));
    QContextMenuEvent wanted(QContextMenuEvent::Mouse, {5, 5}, window.mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(window.menuBar(), &wanted);
    QVERIFY(!QApplication::activePopupWidget());
}

/// All links and keys of the guide must show only its own pages. The next turn begins without the guide.
void TestClassroom::theGuide_leadsNowhereElse()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.beginTurn(QStringLiteral("Anna"));
    const std::uint64_t hash = c.hash();
    c.program.window.action(QStringLiteral("help.guide"))->trigger();
    auto* guide = c.part<QDialog>("guide");
    QVERIFY(guide && guide->isVisible());
    auto* text = guide->findChild<QTextBrowser*>(QStringLiteral("guideText"));
    auto* contents = guide->findChild<QListWidget*>(QStringLiteral("guideContents"));
    QSet<QString> links, pages;
    for (int row = 0; row < contents->count(); ++row)
        pages << contents->item(row)->data(Qt::UserRole).toString();
    for (int row = 0; row < contents->count(); ++row) {
        contents->setCurrentRow(row);
        for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                if (part.fragment().charFormat().isAnchor())
                    links << part.fragment().charFormat().anchorHref();
    }
    QVERIFY(!links.isEmpty() && pages.contains(links));
    for (const char* title : {"Taking turns in class", "Record a lesson", "Class report"})
        QVERIFY2(contents->findItems(QLatin1StringView(title), Qt::MatchFixedString).isEmpty(), title);
    const int shown = contents->currentRow();
    for (const char* link : {"https://example.org/", "file:///etc/hostname", "/etc/hostname", "edit.preferences",
                             "file.open", "report", "mailto:a@example.org", "../../icons/fettle.svg"}) {
        Q_EMIT text->anchorClicked(QUrl(QLatin1StringView(link)));
        QTest::qWait(1);
        QVERIFY2(otherWindows(c) == QList<QWidget*>{guide} && text->source().isEmpty(), link);
        QVERIFY2(contents->currentRow() == shown && text->toPlainText().size() > 200, link);
    }
    for (const ui::ActionInfo& row : ui::actionTable())
        if (!ui::isAllowed(row, home.classroom()))
            for (const QKeySequence& key : c.program.window.action(QLatin1StringView(row.id))->shortcuts()) {
                QTest::keySequence(guide, key);
                QVERIFY2(otherWindows(c) == QList<QWidget*>{guide}, row.id);
            }
    QVERIFY(c.isIdle() && c.hash() == hash);
    c.next();
    QTRY_VERIFY(!guide->isVisible());
}

void TestClassroom::nothingCanBeDropped()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.beginTurn(QStringLiteral("Anna"));
    const QString file = root.filePath(QStringLiteral("x.stl"));
    QVERIFY(!drop(c.program.window, {QUrl::fromLocalFile(file)}));
    QVERIFY(!drop(*c.program.window.viewport(), {QUrl::fromLocalFile(file)}));
    QTest::qWait(20);
    QVERIFY(c.isIdle() && otherWindows(c).isEmpty());
}

void TestClassroom::closing_takesThePin()
{
    const QTemporaryDir root;
    const Home home(root.path());
    {
        Class c(home);
        c.begin();
        c.sculptAs(QStringLiteral("Anna"));
        ui::MainWindow& window = c.program.window;
        QVERIFY(!window.close()); // as with Alt+F4, the close button, or the end of the desktop session
        c.typePin(QStringLiteral("1111"));
        QCOMPARE(c.text("pinWord"), QStringLiteral("This is not the PIN."));
        QVERIFY(window.isVisible());
        c.part<QDialog>("pinDialog")->reject();
        QTRY_VERIFY(!c.part<QDialog>("pinDialog"));
        QVERIFY(window.isVisible() && c.text("classPupil") == QStringLiteral("Anna"));
        window.action(QStringLiteral("file.quit"))->trigger();
        c.typePin(QStringLiteral("0000"));
        c.typePin(QStringLiteral("000"));
        QVERIFY(!c.part<QLineEdit>("pin")->isEnabled()); // disabled after three wrong PINs
        QVERIFY(c.text("pinWord").contains(QStringLiteral("seconds")));
        QTRY_VERIFY(c.part<QLineEdit>("pin")->isEnabled());
        c.typePin(pin);
        QTRY_VERIFY(!window.isVisible());
    }
    QCOMPARE(foldersIn(home.works).size(), 1);
    QCOMPARE(foldersIn(home.journals()), QStringList());
    QCOMPARE(foldersIn(home.places.outbox), QStringList());
}

void TestClassroom::theTeachersDialog_writesTheFile()
{
    const QTemporaryDir root;
    Program program;
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.window.action(QStringLiteral("edit.classroom"))->trigger();
    QPointer<QDialog> dialog;
    QTRY_VERIFY((dialog = program.window.findChild<QDialog*>(QStringLiteral("classroomDialog"))) &&
                dialog->isVisible());
    const auto type = [&dialog](const char* field, const QString& text) {
        QTest::keyClicks(dialog->findChild<QLineEdit*>(QLatin1StringView(field)), text);
    };
    const auto fault = [&dialog] {
        dialog->accept();
        return dialog->findChild<QLabel*>(QStringLiteral("classroomWord"))->text();
    };
    const auto focus = [&dialog] { return dialog->focusWidget() ? dialog->focusWidget()->objectName() : QString(); };
    // the & of a mnemonic is visible in a label without a buddy
    for (const QLabel* label : dialog->findChildren<QLabel*>())
        QVERIFY2(!label->text().contains(u'&') || label->buddy(), qPrintable(label->text()));
    QCOMPARE(fault(), QStringLiteral("The class has no title yet."));
    QCOMPARE(focus(), QStringLiteral("classTitleField"));
    type("classTitleField", QStringLiteral("5b"));
    const QString works = root.filePath(QStringLiteral("new/works"));
    auto* make = dialog->findChild<QPushButton*>(QStringLiteral("classMakeFolder"));
    QVERIFY(!make->isVisible());
    dialog->findChild<QPlainTextEdit*>(QStringLiteral("classNames"))
        ->setPlainText(QStringLiteral(" Anna \n\nBen; B.\r\nAnna\n"));
    type("classFolderField", works);
    QCOMPARE(fault(), QStringLiteral("This folder does not exist."));
    QCOMPARE(focus(), QStringLiteral("classFolderField"));
    QVERIFY(make->isVisible());
    make->click();
    QVERIFY(QFileInfo(works).isDir() && !make->isVisible());
    auto* names = dialog->findChild<QPlainTextEdit*>(QStringLiteral("classNames"));
    const QString typed = names->toPlainText();
    names->appendPlainText(QString(41, u'x'));
    QVERIFY(fault().endsWith(QStringLiteral("is longer than 40 characters.")));
    QCOMPARE(focus(), QStringLiteral("classNames"));
    names->setPlainText(typed);
    QVERIFY(fault().startsWith(QStringLiteral("The PIN needs at least 4")));
    QCOMPARE(focus(), QStringLiteral("classPin"));
    type("classPin", pin);
    QCOMPARE(fault(), QStringLiteral("The two PINs are not the same."));
    QCOMPARE(focus(), QStringLiteral("classPinAgain"));
    type("classPinAgain", pin);
    for (const char* box : {"class.new.cube", "class.tool.stamp", "class.tool.mask", "classQuestions"})
        dialog->findChild<QAbstractButton*>(QLatin1StringView(box))->click();
    auto* lesson = dialog->findChild<QComboBox*>(QStringLiteral("classLesson"));
    QCOMPARE(lesson->count(), 6); // none, four bundled lessons, from a file
    lesson->setCurrentIndex(2);
    Q_EMIT lesson->activated(2);
    QVERIFY(fault().isEmpty());
    QPointer<QFileDialog> files;
    QTRY_VERIFY((files = dialog->findChild<QFileDialog*>(QStringLiteral("classDialog"))) && files->isVisible());
    QVERIFY(files->selectedFiles().constFirst().endsWith(QStringLiteral("/5b.fettleclass")));
    files->reject();
    QTRY_VERIFY(!files); // closing the file dialog must keep the typed values
    QVERIFY(dialog->isVisible() && fault().isEmpty());
    const QString path = root.filePath(QStringLiteral("5b.fettleclass"));
    chooseFile(program, "classDialog", path);
    QTRY_VERIFY(notice(program).contains(QStringLiteral("5b.fettleclass")));
    QTRY_VERIFY(!dialog);
    const ui::Classroom read = ClassFile::read(path);
    QCOMPARE(read.title, QStringLiteral("5b"));
    QCOMPARE(read.folder, works);
    QCOMPARE(read.names, QStringList({"Anna", "Ben B."}));
    QVERIFY(read.starters.size() == 6 && !read.starters.contains(core::Starter::Cube));
    QVERIFY(read.tools.size() == 14 && !read.tools.contains(core::Tool::Stamp));
    QVERIFY(isPin(pin, read.pin) && !isPin(QStringLiteral("1234"), read.pin));
    QVERIFY(read.asksQuestions);
    QCOMPARE(read.lesson, QStringLiteral("mug"));
}

/// After the PIN, the dialog states the number of works that are not in the class folder, and offers to copy them.
void TestClassroom::leaving_saysWhatWaits()
{
    const QTemporaryDir root;
    const Home home(root.path());
    const QString stick = root.filePath(QStringLiteral("stick"));
    QVERIFY(QDir().mkpath(stick));
    Class c(home);
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    QVERIFY(QDir().rmdir(home.works));
    c.next();
    QTRY_VERIFY(!c.text("classWaiting").isEmpty());
    c.sculptAs(QStringLiteral("Ben"));
    c.press("classLeave");
    QVERIFY(!c.part<ui::WaitingWorksDialog>("waitingWorks"));
    QVERIFY2(pinQuestion(c).contains(QStringLiteral("1 model")), qPrintable(pinQuestion(c)));
    c.typePin(pin);
    QPointer<ui::WaitingWorksDialog> dialog;
    QTRY_VERIFY((dialog = c.part<ui::WaitingWorksDialog>("waitingWorks")) && dialog->isVisible());
    QVERIFY(c.program.window.isVisible());
    QString said;
    for (const QLabel* label : dialog->findChildren<QLabel*>())
        said += label->text();
    QVERIFY2(said.contains(QStringLiteral("2 models are not yet")) && said.contains(home.places.outbox) &&
                 said.contains(home.works),
             qPrintable(said));
    Q_EMIT dialog->copyRequested(stick);
    QTRY_VERIFY(c.text("waitingWord").contains(stick));
    QCOMPARE(foldersIn(stick).size(), 2);
    QCOMPARE(foldersIn(home.places.outbox).size(), 2);
    c.press("endClass");
    QTRY_VERIFY(!c.program.window.isVisible());
}

/// The question before the PIN states whether a work is open.
void TestClassroom::leaving_saysWhetherAWorkIsOpen()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    const auto question = [&c] {
        c.press("classLeave");
        const QString asked = pinQuestion(c);
        c.part<QDialog>("pinDialog")->reject();
        return asked;
    };
    QCOMPARE(question(), QStringLiteral("End the class? It is nobody's turn, and all work is saved."));
    QTRY_VERIFY(!c.part<QDialog>("pinDialog"));
    c.sculptAs(QStringLiteral("Anna"));
    QCOMPARE(question(), QStringLiteral("End the class? The current pupil's work will be saved."));
}

/// The class folder does not respond, like that of a server that is down. Leaving must not wait for it.
void TestClassroom::leaving_doesNotWaitForEver()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    QVERIFY(QDir().rmdir(home.works));
    c.next();
    QTRY_VERIFY(!c.text("classWaiting").isEmpty());
    const QString there = home.works + u'/' + foldersIn(home.places.outbox).constFirst();
    QVERIFY(QDir().mkpath(there));
    const QByteArray pipe = QFile::encodeName(there + QStringLiteral("/turn.json"));
    QCOMPARE(::mkfifo(pipe.constData(), 0600), 0);
    const auto release = [&pipe] { // a write-only open fails until a reader has the pipe open
        const int writer = ::open(pipe.constData(), O_WRONLY | O_NONBLOCK);
        return writer >= 0 && ::close(writer) == 0;
    };
    const auto releaseAtLast = qScopeGuard(release); // lets the reader finish even if the test fails
    c.press("classLeave");
    c.typePin(pin);
    QTRY_VERIFY(!c.program.window.isEnabled());
    QPointer<ui::WaitingWorksDialog> dialog;
    QTRY_VERIFY((dialog = c.part<ui::WaitingWorksDialog>("waitingWorks")) && dialog->isVisible());
    QVERIFY(c.program.window.isEnabled());
    QVERIFY(release()); // the folder responds again
    c.press("endClass");
    QTRY_VERIFY(!c.program.window.isVisible());
}

void TestClassroom::theTeachersDialog_changesAFile_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("as the dialog names it") << QStringLiteral("5b.fettleclass");
    QTest::newRow("as an older one was named") << QStringLiteral("5b.ini");
}

/// An existing class can be edited in the same dialog, saved in the same or another file, with the same or another PIN.
void TestClassroom::theTeachersDialog_changesAFile()
{
    QFETCH(const QString, name);
    const QTemporaryDir root;
    const Home home(root.path());
    const QString path = root.filePath(name), other = root.filePath(QStringLiteral("works/other.fettleclass"));
    QCOMPARE(ClassFile::write(path, home.classroom()), QString());
    Program program;
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    const auto change = [&](QPointer<QDialog>* dialog) {
        if (ui::isClassFile(path))
            Q_EMIT program.window.files()->openRequested(path);
        else
            program.window.findChild<ClassFileController*>()->offer(path);
        QPointer<QMessageBox> question;
        QTRY_VERIFY((question = program.window.findChild<QMessageBox*>(QStringLiteral("beginClass"))) &&
                    question->isVisible() && question->text().contains(QStringLiteral("5b")));
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::ActionRole)
                button->click();
        QTRY_VERIFY(!question);
        QTRY_VERIFY((*dialog = program.window.findChild<QDialog*>(QStringLiteral("classroomDialog"))) &&
                    (*dialog)->isVisible());
    };
    const auto isKept = [&](const QPointer<QDialog>& dialog) {
        QTRY_VERIFY(!dialog);
        auto* question = program.window.findChild<QMessageBox*>(QStringLiteral("beginClass"));
        QVERIFY(question);
        // the desktop knows the file type
        const bool isKnown = question->informativeText().contains(QStringLiteral("double click"));
        delete question;
        QCOMPARE(isKnown, name.endsWith(QStringLiteral("class")) || QFile::exists(other));
    };
    const auto save = [&](const QPointer<QDialog>& dialog) {
        QVERIFY(dialog->findChild<QPushButton*>(QStringLiteral("classSaveAs"))->isVisible());
        dialog->accept();
        // saving needs no file dialog, because the path is known
        QVERIFY(!dialog->findChild<QFileDialog*>(QStringLiteral("classDialog")));
        isKept(dialog);
    };
    QPointer<QDialog> dialog;
    change(&dialog);
    if (QTest::currentTestFailed())
        return;
    dialog->findChild<QAbstractButton*>(QStringLiteral("class.tool.stamp"))->click();
    save(dialog);
    ui::Classroom expected = home.classroom();
    expected.tools << core::Tool::Stamp;
    const ui::Classroom kept = ClassFile::read(path);
    QVERIFY(kept.pin == expected.pin && kept.tools.contains(core::Tool::Stamp) && kept.starters == expected.starters);
    QCOMPARE(kept.turnMinutes, expected.turnMinutes);
    change(&dialog);
    for (const char* field : {"classPin", "classPinAgain"})
        QTest::keyClicks(dialog->findChild<QLineEdit*>(QLatin1StringView(field)), QStringLiteral("13579"));
    save(dialog);
    const ui::Classroom changed = ClassFile::read(path);
    QVERIFY(isPin(QStringLiteral("13579"), changed.pin));
    change(&dialog);
    dialog->findChild<QAbstractButton*>(QStringLiteral("class.tool.stamp"))->click();
    dialog->findChild<QPushButton*>(QStringLiteral("classSaveAs"))->click();
    chooseFile(program, "classDialog", other);
    isKept(dialog);
    QCOMPARE(ClassFile::read(path), changed);
    QVERIFY(!ClassFile::read(other).tools.contains(core::Tool::Stamp));
}

/// The dialog reports works whose class folder no longer exists, and moves them to a folder that the teacher chooses.
void TestClassroom::theTeachersDialog_movesWhatWaits()
{
    const QTemporaryDir root;
    const QByteArray before = qgetenv("XDG_DATA_HOME");
    const auto setBack = qScopeGuard([&before] { qputenv("XDG_DATA_HOME", before); });
    qputenv("XDG_DATA_HOME", QFile::encodeName(root.filePath(QStringLiteral("data"))));
    const QString gone = root.filePath(QStringLiteral("gone")), stick = root.filePath(QStringLiteral("stick"));
    QVERIFY(QDir().mkpath(stick));
    TurnWork work{QStringLiteral("1"), QStringLiteral("Anna"), QDateTime::currentDateTime(),
                  QDateTime::currentDateTime()};
    work.mesh = std::make_shared<const core::TriangleMesh>(core::starterModel(core::Starter::Cube));
    const QString classFile = root.filePath(QStringLiteral("5b.fettleclass"));
    QCOMPARE(WorkArchive(gone, ClassPaths::prepare(classFile, gone).outbox).add(work).problem, QString());
    Program program;
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    QPointer<QDialog> dialog;
    const auto open = [&] {
        program.window.action(QStringLiteral("edit.classroom"))->trigger();
        dialog = program.window.findChild<QDialog*>(QStringLiteral("classroomDialog"));
        return dialog && dialog->isVisible();
    };
    QVERIFY(open());
    const auto text = [&dialog](const char* label) {
        const auto* found = dialog->findChild<QLabel*>(QLatin1StringView(label));
        return found->isVisible() ? found->text() : QString();
    };
    const auto* move = dialog->findChild<QPushButton*>(QStringLiteral("moveWaiting"));
    QVERIFY2(text("waitingModels").contains(QStringLiteral("1 models are still on this computer and not in ") + gone),
             qPrintable(text("waitingModels")));
    QVERIFY(move->isVisible());
    auto* note = dialog->findChild<ui::WaitingWorksNote*>();
    Q_EMIT note->moveRequested(root.filePath(QStringLiteral("none")));
    QTRY_VERIFY(text("movedModels").contains(QStringLiteral("does not exist")));
    QVERIFY(move->isVisible() && text("waitingModels").contains(gone)); // the works are still there
    Q_EMIT note->moveRequested(stick);
    QTRY_VERIFY(text("movedModels").contains(stick));
    QVERIFY(WorkArchive::worksIn(stick).size() == 1 && ClassPaths::waiting().isEmpty());
    QVERIFY(!move->isVisible() && text("waitingModels").isEmpty());
    dialog->reject();
    QTRY_VERIFY(!dialog);
    QVERIFY(open() && text("movedModels").isEmpty());
}

/// A class begins only after the window has closed. If the window stays open, closing it later must not begin the
/// class.
void TestClassroom::theClass_beginsWhenTheWindowIsClosed()
{
    const QTemporaryDir root;
    const QString path = root.filePath(QStringLiteral("5b.fettleclass"));
    QCOMPARE(ClassFile::write(path, Home(root.path()).classroom()), QString());
    Program program;
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    auto* files = program.window.findChild<ClassFileController*>();
    files->offer(root.filePath(QStringLiteral("none.fettleclass")));
    auto* problem = program.window.findChild<QMessageBox*>(QStringLiteral("problem"));
    QVERIFY(problem && problem->text().contains(QStringLiteral("none.fettleclass")));
    delete problem;
    files->offer(path);
    auto* question = program.window.findChild<QMessageBox*>(QStringLiteral("beginClass"));
    QVERIFY(question && files->next().isEmpty());
    question->defaultButton()->click();
    QTRY_VERIFY(!program.window.isVisible());
    QCOMPARE(files->next(), path);
    Q_EMIT program.document.stepped(core::Stroke());
    QVERIFY(files->next().isEmpty());
}

/// Cancelling the question about unsaved changes cancels the class. A later close must not begin it.
void TestClassroom::theClass_doesNotBeginForWhoStays()
{
    const QTemporaryDir root;
    const QString path = root.filePath(QStringLiteral("5b.fettleclass"));
    QCOMPARE(ClassFile::write(path, Home(root.path()).classroom()), QString());
    Program program;
    sculptBall(program);
    const auto* files = program.window.findChild<ClassFileController*>();
    answerQuestion(program, QMessageBox::Cancel);
    program.window.findChild<ClassFileController*>()->offer(path);
    program.window.findChild<QMessageBox*>(QStringLiteral("beginClass"))->defaultButton()->click();
    QCOMPARE(files->next(), path);
    QTRY_VERIFY(files->next().isEmpty());
    QVERIFY(program.window.isVisible());
}

void TestClassroom::questions_comeOnlyIfTheTeacherWants()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.beginTurn(QStringLiteral("Anna"));
    QVERIFY(!c.questions());
    c.sculpt();
    c.next();
    QVERIFY(!c.questions());
    c.beginTurn(QStringLiteral("Ben"));
    QVERIFY(!c.questions());
}

/// The form is empty for the second pupil, and each work has its own answers.
void TestClassroom::answers_areKeptWithTheWork()
{
    const QTemporaryDir root;
    const Home home(root.path());
    {
        Class c(home, home.classroomWithQuestions());
        c.begin();
        c.sculptAs(QStringLiteral("Anna"));
        c.nextWithQuestions();
        QVERIFY(!c.part<QPushButton>("classNext")->isEnabled());
        QCOMPARE(foldersIn(home.places.outbox).size(), 1); // the work is saved before any question is answered
        QCOMPARE(foldersIn(home.works), QStringList());
        c.answer(1, 7);
        c.answer(3, 2);
        c.press("questionsDone");
        QTRY_VERIFY(c.asks() && !c.questions());
        QCOMPARE(QApplication::focusWidget(), c.part<QLineEdit>("pupilName"));
        QTRY_COMPARE(foldersIn(home.works).size(), 1);
        c.sculptAs(QStringLiteral("Ben"));
        c.nextWithQuestions();
        for (const QToolButton* point : c.part<QWidget>("questionnairePanel")->findChildren<QToolButton*>())
            QVERIFY(!point->isChecked());
        c.answer(6, 4);
        c.press("questionsDone");
        QTRY_VERIFY(c.asks());
    }
    QCOMPARE(foldersIn(home.works).size(), 2);
    for (const QString& name : foldersIn(home.works)) {
        const TurnAnswers answers = TurnAnswers::read(home.works + u'/' + name);
        ui::Questionnaire expected;
        if (name.contains(QStringLiteral("Anna"))) {
            expected.answers[0] = 7;
            expected.answers[2] = 2;
        } else {
            expected.answers[5] = 4;
        }
        QCOMPARE(answers.questionnaire, expected);
        QCOMPARE(answers.turnId, turnIn(home.works + u'/' + name).value(QStringLiteral("id")).toString());
        QCOMPARE(answers.problem, QString());
    }
}

void TestClassroom::skipping_keepsNothing()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    const std::uint64_t hash = c.hash();
    c.nextWithQuestions();
    c.answer(2, 5);
    c.press("skipQuestions");
    QTRY_VERIFY(c.asks() && !c.questions());
    // works in delivery are hidden until they are complete
    QTRY_COMPARE(foldersIn(home.places.outbox), QStringList());
    QCOMPARE(foldersIn(home.works).size(), 1);
    const QString folder = home.works + u'/' + foldersIn(home.works).constFirst();
    QVERIFY(!QFile::exists(folder + u'/' + TurnAnswers::fileName));
    QCOMPARE(hashOf(folder + QStringLiteral("/model.glb")), hash);
    c.beginTurn(QStringLiteral("Ben"));
    QVERIFY(!c.questions());
}

/// While the form or the name panel is open, shortcut keys must go to the panel and not trigger commands.
void TestClassroom::keys_answerAndChooseNoTool()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    c.begin();
    ui::MainWindow& window = c.program.window;
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const Beginning before(c);
    const auto pressAll = [&](const char* at) {
        int pressed = 0;
        for (const ui::ActionInfo& row : ui::actionTable()) {
            for (const QKeySequence& keys : window.action(QLatin1StringView(row.id))->shortcuts()) {
                const QKeyCombination key = keys[0];
                const bool isFunctionKey = key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35;
                if (isFunctionKey || key.keyboardModifiers().testFlag(Qt::AltModifier) || keys == QKeySequence::Quit)
                    continue;
                c.part<QWidget>(at)->setFocus();
                QTest::keyClick(c.part<QWidget>(at), key.key(), key.keyboardModifiers());
                ++pressed;
            }
        }
        QVERIFY(pressed > 40);
        QVERIFY2(c.isIdle() && Beginning(c) == before, at);
    };
    pressAll("turn.new.torus");
    pressAll("pupilName");
    QVERIFY(c.asks());
    c.sculptAs(QStringLiteral("Anna"));
    c.nextWithQuestions();
    for (const Qt::Key digit : {Qt::Key_1, Qt::Key_2, Qt::Key_7}) {
        QTest::keyClick(QApplication::focusWidget(), digit);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    const ui::Questionnaire given = c.part<ui::QuestionnairePanel>("questionnairePanel")->questionnaire();
    QCOMPARE(given.answers, (std::array<std::optional<int>, 6>{1, 2, 7, {}, {}, {}}));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_End);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Home);
    QCOMPARE(QApplication::focusWidget(), c.part<QToolButton>("question4.1"));
    QVERIFY(Beginning(c) == before);
    pressAll("question5.1");
    QVERIFY(c.questions() && !c.asks());
}

/// Checks that every part of the form and the name panel is visible or can be scrolled to in 640 x 360 pixels, a screen
/// of 1280 x 720 at 200 %.
void TestClassroom::aSmallWindow_hasAllInReach()
{
    constexpr QSize smallest{640, 360};
    const QTemporaryDir root;
    const Home home(root.path());
    ui::Classroom classroom = home.classroomWithQuestions();
    classroom.starters = {std::begin(core::starters), std::end(core::starters)};
    Class c(home, classroom);
    c.begin();
    ui::MainWindow& window = c.program.window;
    window.resize(smallest);
    QTRY_COMPARE(window.size(), smallest);
    const auto isWhole = [&](const QWidget* widget) {
        return widget->visibleRegion().boundingRect() == widget->rect() &&
               window.rect().contains(QRect(widget->mapTo(&window, QPoint()), widget->size()));
    };
    const auto isReached = [&](const QString& panel, QWidget* widget) {
        c.part<QWidget>(qPrintable(panel))->findChild<QScrollArea*>()->ensureWidgetVisible(widget);
        return isWhole(widget);
    };
    QTRY_VERIFY(isWhole(c.part<QWidget>("beginTurn")) && isWhole(c.part<QWidget>("pupilName")));
    for (QToolButton* tile : c.part<QWidget>("namePanel")->findChildren<QToolButton*>())
        QVERIFY2(isReached(QStringLiteral("namePanel"), tile), qPrintable(tile->objectName()));
    c.beginTurn(QStringLiteral("Anna"), "new.cube");
    c.nextWithQuestions();
    QCOMPARE(window.size(), smallest);
    QTRY_VERIFY(isWhole(c.part<QWidget>("questionsDone")) && isWhole(c.part<QWidget>("skipQuestions")));
    const auto points = c.part<QWidget>("questionnairePanel")->findChildren<QToolButton*>();
    QCOMPARE(points.size(), 42);
    for (QToolButton* point : points)
        QVERIFY2(isReached(QStringLiteral("questionnairePanel"), point), qPrintable(point->objectName()));
}

/// Checks that no tool bar hides a button in 960 x 540 pixels, a screen of 1920 x 1080 at 200 %.
void TestClassroom::aSmallWindow_hasAllBars()
{
    constexpr QSize small{960, 540};
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home);
    c.begin();
    c.program.window.resize(small);
    QTRY_COMPARE(c.program.window.size(), small);
    const auto verifyBars = [&c] {
        for (const QToolBar* bar : c.program.window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly))
            QTRY_VERIFY2(!bar->findChild<QWidget*>(QStringLiteral("qt_toolbar_ext_button"))->isVisible(),
                         qPrintable(bar->objectName()));
    };
    verifyBars();
    c.beginTurn(QStringLiteral("Anna"));
    verifyBars();
    c.sculpt();
    c.next();
    verifyBars();
}

/// Esc cancels opening the next starter behind the form. The starter is then opened again, and the form is not shown a
/// second time.
void TestClassroom::stopping_keepsTheForm()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    c.begin();
    c.sculptAs(QStringLiteral("Anna"), "new.torus");
    const std::uint64_t hash = c.hash();
    int stops = 0;
    connect(&c.program.document.job(), &BackgroundJob::busy, this, [&] {
        if (c.questions() && stops < 5)
            QMetaObject::invokeMethod(
                this,
                [&] {
                    stops += c.program.document.job().isBusy() ? 1 : 0;
                    c.program.document.cancelJob();
                },
                Qt::QueuedConnection);
    });
    c.press("classNext");
    QTRY_VERIFY(c.questions());
    QTRY_VERIFY(stops == 5 && c.isIdle() && c.hash() != hash);
    QVERIFY(c.questions() && !c.asks());
    c.answer(1, 3);
    c.press("questionsDone");
    QTRY_VERIFY(c.asks());
    c.beginTurn(QStringLiteral("Ben"));
    QTRY_COMPARE(foldersIn(home.places.outbox).size(), 0);
    const QString work = home.works + u'/' + foldersIn(home.works).constFirst();
    QCOMPARE(TurnAnswers::read(work).questionnaire.answers[0], 3);
}

/// Checks that each panel is shown once, without flickering.
void TestClassroom::eachPanel_opensOnce()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    ShowCount names(c.part<QWidget>("namePanel")), forms(c.part<QWidget>("questionnairePanel"));
    const auto counts = [&] { return std::pair(std::exchange(names.count, 0), std::exchange(forms.count, 0)); };
    c.begin();
    QCOMPARE(counts(), std::pair(1, 0));
    c.sculptAs(QStringLiteral("Anna"));
    c.nextWithQuestions();
    QCOMPARE(counts(), std::pair(0, 1));
    c.press("classResume");
    QTRY_VERIFY(!c.questions() && c.isIdle() && c.text("classPupil") == QStringLiteral("Anna"));
    QCOMPARE(counts(), std::pair(0, 0));
    c.nextWithQuestions();
    c.press("questionsDone");
    QTRY_VERIFY(c.asks());
    QCOMPARE(counts(), std::pair(1, 1));
    c.beginTurn(QStringLiteral("Ben"));
    c.nextWithQuestions();
    c.press("classLeave");
    c.typePin(pin);
    QTRY_VERIFY(!c.program.window.isVisible());
    QCOMPARE(counts(), std::pair(0, 1));
}

/// A folder in the way prevents saving the answers, which is reported. Done saves them after the folder has been
/// removed.
void TestClassroom::aFailedAnswer_isWrittenAtDone()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    c.nextWithQuestions();
    const QString answers =
        home.places.outbox + u'/' + foldersIn(home.places.outbox).constFirst() + u'/' + TurnAnswers::fileName;
    QVERIFY(QDir().mkdir(answers));
    c.answer(5, 6);
    QTRY_VERIFY(notice(c.program).contains(TurnAnswers::fileName));
    QVERIFY(QDir().rmdir(answers));
    c.press("questionsDone");
    QTRY_COMPARE(foldersIn(home.places.outbox).size(), 0);
    const QString work = home.works + u'/' + foldersIn(home.works).constFirst();
    QCOMPARE(TurnAnswers::read(work).questionnaire.answers[4], 6);
}

/// Anna's work is being delivered to a folder that does not respond, simulated by a pipe. Ben's answers must still be
/// saved on this computer at once.
void TestClassroom::aSlowDelivery_holdsNoAnswerBack()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    c.nextWithQuestions();
    const QString anna = foldersIn(home.places.outbox).constFirst();
    const QString pipe = home.works + u'/' + anna + QStringLiteral("/turn.json");
    QVERIFY(QDir().mkpath(home.works + u'/' + anna));
    QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    const auto release = [&pipe] { // a write-only open fails until a reader has the pipe open
        const int writer = ::open(QFile::encodeName(pipe).constData(), O_WRONLY | O_NONBLOCK);
        return writer >= 0 && ::close(writer) == 0;
    };
    bool isReleased = false;
    const auto releaseAtLast = qScopeGuard([&] { // lets the reader finish even if the test fails
        if (!isReleased)
            release();
    });
    c.press("questionsDone");
    QTRY_VERIFY(c.asks());
    c.sculptAs(QStringLiteral("Ben"));
    c.nextWithQuestions();
    QCOMPARE(foldersIn(home.places.outbox).size(), 2); // no work has been delivered
    const QString ben = foldersIn(home.places.outbox).filter(QStringLiteral("Ben")).constFirst();
    c.answer(6, 5);
    QTRY_COMPARE(TurnAnswers::read(home.places.outbox + u'/' + ben).questionnaire.answers[5], 5);
    QCOMPARE(foldersIn(home.works), QStringList{anna});
    QTRY_VERIFY(isReleased || (isReleased = release()));
    // Ben's work waits while his form is open
    QTRY_COMPARE(foldersIn(home.places.outbox), QStringList{ben});
    c.press("questionsDone");
    QTRY_COMPARE(foldersIn(home.places.outbox).size(), 0);
    QCOMPARE(TurnAnswers::read(home.works + u'/' + ben).questionnaire.answers[5], 5);
}

/// Resume after a mistaken Next Pupil closes the form. It opens again at the real end of the turn.
void TestClassroom::resuming_fromTheQuestions()
{
    const QTemporaryDir root;
    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    const std::uint64_t hash = c.hash();
    c.nextWithQuestions();
    QTRY_VERIFY(c.part<QPushButton>("classResume")->isVisible());
    c.press("classResume");
    QTRY_VERIFY(!c.questions() && !c.asks() && c.isIdle() && c.text("classPupil") == QStringLiteral("Anna"));
    QCOMPARE(c.hash(), hash);
    c.sculpt({-40, 30});
    c.nextWithQuestions();
    c.press("questionsDone");
    QTRY_VERIFY(c.asks());
    QTRY_COMPARE(foldersIn(home.works).size(), 2);
}

void TestClassroom::leaving_keepsWhatWasAnswered()
{
    const QTemporaryDir root;
    const Home home(root.path());
    {
        Class c(home, home.classroomWithQuestions());
        c.begin();
        c.sculptAs(QStringLiteral("Anna"));
        c.nextWithQuestions();
        c.answer(4, 1);
        c.press("classLeave");
        c.typePin(pin);
        QTRY_VERIFY(!c.program.window.isVisible());
    }
    QCOMPARE(foldersIn(home.works).size(), 1);
    QCOMPARE(foldersIn(home.places.outbox), QStringList());
    ui::Questionnaire expected;
    expected.answers[3] = 1;
    QCOMPARE(TurnAnswers::read(home.works + u'/' + foldersIn(home.works).constFirst()).questionnaire, expected);
}

/// The work was saved before the form opened, and each answer as soon as it was given.
void TestClassroom::aPowerCutInTheQuestions_losesNothing()
{
    const QTemporaryDir root;
    QProcess victim;
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(test::programPath(),
                 {test::runningClass(), QStringLiteral("--victim"), root.path(), QStringLiteral("questions")});
    QVERIFY(victim.waitForFinished(longestWait));
    const std::uint64_t hash = victim.readAllStandardOutput().trimmed().toULongLong();
    QVERIFY(hash != 0 && victim.exitStatus() == QProcess::CrashExit);

    const Home home(root.path());
    Class c(home, home.classroomWithQuestions());
    c.begin();
    QVERIFY(!c.questions()); // no form, because its pupil has left
    QTRY_VERIFY(!foldersIn(home.works).isEmpty() && foldersIn(home.places.outbox).isEmpty());
    int answered = 0;
    for (const QString& name : foldersIn(home.works)) {
        QCOMPARE(hashOf(home.works + u'/' + name + QStringLiteral("/model.glb")), hash);
        const TurnAnswers answers = TurnAnswers::read(home.works + u'/' + name);
        if (answers.questionnaire.isEmpty())
            continue;
        ++answered;
        ui::Questionnaire expected;
        expected.answers[1] = 6;
        QCOMPARE(answers.questionnaire, expected);
    }
    QCOMPARE(answered, 1);
}

/// After a power cut, step, goals and time are those at the interruption, and Resume continues from there.
void TestClassroom::aPowerCutInALesson_keepsItsResult()
{
    const QTemporaryDir root;
    QProcess victim;
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(test::programPath(),
                 {test::runningClass(), QStringLiteral("--victim"), root.path(), QStringLiteral("lesson")});
    QVERIFY(victim.waitForFinished(longestWait));
    const std::uint64_t hash = victim.readAllStandardOutput().trimmed().toULongLong();
    QVERIFY(hash != 0 && victim.exitStatus() == QProcess::CrashExit);

    const Home home(root.path());
    Class c(home, withLesson(home.classroom(), true));
    c.begin();
    QTRY_VERIFY(!foldersIn(home.works).isEmpty() && foldersIn(home.places.outbox).isEmpty());
    const QString work = home.works + u'/' + foldersIn(home.works).constFirst();
    const core::CheckpointVerdict verdict = core::evaluate(readLesson(QStringLiteral("first-clay")).steps[1].checkpoint,
                                                           core::readMesh(toPath(WorkArchive::modelOf(work))), nullptr);
    const TurnFacts turn = WorkArchive::turnOf(work);
    QVERIFY(turn.lesson);
    QCOMPARE(turn.lesson->lesson, QStringLiteral("first-clay"));
    QCOMPARE(turn.lesson->step, 2);
    QVERIFY(!turn.lesson->isTeachers);
    QCOMPARE(turn.lesson->verdict.facts.size(), verdict.facts.size());
    QVERIFY2(turn.seconds().value_or(0) >= 5 * 60 && turn.seconds().value_or(0) < 10 * 60,
             qPrintable(QString::number(turn.seconds().value_or(0))));
    QTRY_VERIFY(c.part<QPushButton>("classResume")->isVisible());
    c.press("classResume");
    QTRY_VERIFY(!c.asks() && c.isIdle() && c.text("classPupil") == QStringLiteral("Anna"));
    QCOMPARE(c.hash(), hash);
    QVERIFY(c.text("lessonTitle").contains(QStringLiteral("step 2 of")));
    c.mode.tick();
    QVERIFY(c.text("classTime") != QStringLiteral("20 minutes left"));
}

void TestClassroom::aPowerCut_losesNobodysWork_data()
{
    QTest::addColumn<int>("afterNextMs");
    QTest::newRow("in a turn") << -1;
    for (const int ms : byEffort<std::vector<int>>({0, 60}, {0, 20, 60, 150, 400}))
        QTest::addRow("%d ms after Next Pupil", ms) << ms;
}

/// Whenever the program is killed, the work has been saved before, and the next start delivers it to the class folder.
void TestClassroom::aPowerCut_losesNobodysWork()
{
    QFETCH(int, afterNextMs);
    const QTemporaryDir root;
    QProcess victim;
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(test::programPath(),
                 {test::runningClass(), QStringLiteral("--victim"), root.path(), QString::number(afterNextMs)});
    QVERIFY(victim.waitForFinished(longestWait));
    const std::uint64_t hash = victim.readAllStandardOutput().trimmed().toULongLong();
    QVERIFY(hash != 0 && victim.exitStatus() == QProcess::CrashExit);

    const Home home(root.path());
    Class c(home);
    c.begin();
    QTRY_VERIFY(!foldersIn(home.works).isEmpty() && foldersIn(home.places.outbox).isEmpty());
    // two, if the work was saved but its journal did not record that
    for (const QString& name : foldersIn(home.works)) {
        QVERIFY2(!name.startsWith(u'.') && name.contains(QStringLiteral("Anna")), qPrintable(name));
        QCOMPARE(hashOf(home.works + u'/' + name + QStringLiteral("/model.glb")), hash);
        QVERIFY(turnIn(home.works + u'/' + name).contains(QStringLiteral("begun")));
        QCOMPARE(replayed(core::Starter::Ball, home.works + u'/' + name + QStringLiteral("/record.json")), hash);
    }
    QVERIFY(foldersIn(home.works).size() <= 2);
    QTRY_COMPARE(foldersIn(home.journals()).size(), 1);
}

namespace
{
/// Prints the hash of a work and aborts while the form is open, once the first answer is on the disk.
int runVictimInQuestions(const QString& root)
{
    const Home home(root);
    Class c(home, home.classroomWithQuestions());
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    const std::uint64_t hash = c.hash();
    c.nextWithQuestions();
    c.answer(2, 6);
    const QString folder = home.places.outbox + u'/' + foldersIn(home.places.outbox).constFirst() + u'/';
    while (!QFile::exists(folder + TurnAnswers::fileName))
        QTest::qWait(1);
    std::cout << hash << std::endl;
    std::abort();
}

/// Waits until the journal contains everything, then prints the hash of the model.
void printKept(Class& c)
{
    const std::uint64_t hash = c.hash();
    bool isRecorded = false;
    ui::ThreadMailbox mail;
    c.program.document.journaling().journal()->after([&] { mail.post([&isRecorded] { isRecorded = true; }); });
    while (!isRecorded)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    std::cout << hash << std::endl;
}

/// Prints the hash of a model in the second step of a lesson, after five minutes of the turn, and aborts.
int runVictimInLesson(const QString& root)
{
    const Home home(root);
    Class c(home, withLesson(home.classroom(), true));
    c.begin();
    c.beginTurn(QStringLiteral("Anna"), "lesson");
    c.now += 5 * minute;
    c.press("lessonNext");
    while (!c.text("lessonTitle").contains(QStringLiteral("step 2 of")))
        QTest::qWait(1);
    c.sculpt();
    printKept(c);
    std::abort();
}

/// Prints the hash of a work once the journal contains it, and aborts.
int runVictim(const QString& root, const QString& moment)
{
    if (moment == QStringLiteral("questions"))
        return runVictimInQuestions(root);
    if (moment == QStringLiteral("lesson"))
        return runVictimInLesson(root);
    const int afterNextMs = moment.toInt();
    const Home home(root);
    Class c(home);
    c.begin();
    c.sculptAs(QStringLiteral("Anna"));
    c.sculpt({-60, 40});
    printKept(c);
    if (afterNextMs >= 0) {
        c.press("classNext");
        if (afterNextMs > 0)
            QTest::qWait(afterNextMs);
    }
    std::abort();
}
} // namespace

static int classroomMain(int argc, char* argv[])
{
    if (argc == 4 && qstrcmp(argv[1], "--victim") == 0) {
        ui::prepareGraphics();
        const QApplication application(argc, argv);
        QCoreApplication::setOrganizationName(QStringLiteral("Fettle"));
        QCoreApplication::setApplicationName(QStringLiteral("tst_classroom"));
        return runVictim(QString::fromLocal8Bit(argv[2]), QString::fromLocal8Bit(argv[3]));
    }
    return test::run<TestClassroom, app::OnScreen>(argc, argv);
}

FETTLE_TEST_MAIN(TestClassroom, classroomMain)
#include "tst_classroom.moc"
