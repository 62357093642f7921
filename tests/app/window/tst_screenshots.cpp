#include "app/classroom/classroom_mode.h"
#include "app/model/repair_doubts.h"
#include "tests/app/window/loaded_language.h"
#include "tests/support/effort.h"
#include "tests/support/program.h"
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "ui/brush/stroke_edit_bar.h"
#include "ui/classroom/pupil_name_panel.h"
#include "ui/classroom/questionnaire_panel.h"
#include "ui/drawing/drawing_canvas.h"
#include "ui/files/file_browser.h"
#include "ui/help/guide_window.h"
#include "ui/help/start_page.h"
#include "ui/history/recovery_bar.h"
#include "ui/lesson/lesson_editor.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/model/repair_dialogs.h"
#include "ui/model/unit_bar.h"
#include "ui/scene/scene.h"
#include "ui/settings/settings.h"
#include "ui/util/error_messages.h"
#include "ui/util/repair_messages.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/theme.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>

using namespace app;

namespace
{
constexpr QSize smallScreen{1280, 720}, largeScreen{1920, 1080};
constexpr int flightMs = 600; ///< ms that the camera takes to fly to a place
constexpr int fastPng = 80;   ///< quality of a PNG file (0 to 100); larger ones are written faster
constexpr int settleMs = 250; ///< ms that layouts and results of other threads take

int widthOf(const QWidget* widget, const QString& text)
{
    return widget->fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

/// Returns a text of the widget that has too little space, or an empty text.
QString clippedText(const QWidget* widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        static const QRegularExpression key(QStringLiteral("&\\w"));
        if (!label->buddy() && label->text().contains(key)) // the & would be visible, and its key would have no effect
            return label->text();
        const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        const bool isWide = label->wordWrap() || label->width() >= label->sizeHint().width();
        return isWide && label->height() >= needed ? QString() : label->text();
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
        return button->width() >= button->minimumSizeHint().width() ? QString() : button->text();
    if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
        QStyleOptionComboBox option;
        option.initFrom(box);
        const QRect room =
            box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
        return room.width() >= widthOf(box, box->currentText()) ? QString() : box->currentText();
    }
    // typed text may be longer than the field, but texts of the program may not
    if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
        const QString words = line->text().isEmpty() ? line->placeholderText()
                              : line->isReadOnly()   ? line->text()
                                                     : QString();
        return line->width() >= widthOf(line, words) ? QString() : words;
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabRect(i).width() < widthOf(tabs, tabs->tabText(i)) || !tabs->rect().contains(tabs->tabRect(i)))
                return tabs->tabText(i);
    }
    return {};
}

/// Returns all clipped texts in the window, each with the type of its widget.
QStringList clippedTexts(const QWidget& window)
{
    QStringList clipped;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (widget->visibleRegion().isEmpty()) // excludes panels behind others, which have no layout
            continue;
        const QString text = clippedText(widget);
        if (!text.isEmpty())
            clipped << QStringLiteral("%1 \"%2\"").arg(QLatin1StringView(widget->metaObject()->className()), text);
    }
    return clipped;
}

/// Extent of a row: the states of the window that it pictures.
enum class Extent { Window, Panels, All };

/// Returns whether the picture of the last preset has been drawn.
bool isDrawn(const QListWidget& presets)
{
    const QListWidgetItem* last = presets.item(presets.count() - 1);
    return last && last->icon().pixmap(presets.iconSize()).toImage().pixelColor(32, 32).alpha() > 0;
}
} // namespace

/// Takes pictures of the window's main states for visual checks: build/<preset>/screenshots. Checks that no text is
/// clipped and that the window fits a small screen.
class TestScreenshots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void states_data();
    void states();
    void largerTexts_data();
    void largerTexts();

private:
    void take(QWidget& window, const QString& state, const QSize& screen = smallScreen);
    void takeAll(Program& program);
    void takeKeyHand(Program& program);
    void takeRecovery(Program& program);
    void takeStrokeBar(Program& program);
    void takeUnits(Program& program);
    void takePrint(Program& program);
    void takeRepair(Program& program);
    void takeExport(Program& program);
    void takePanels(Program& program);
    void showModels(ui::FileBrowser* panel);
    void takeMenus(Program& program);
    void takeDialogs(Program& program);
    void takeHelp(Program& program);
    void takeClass();
    void takeSmallForm(QWidget& window);
    void takeLesson(Program& program);
    void takeLessonEditor(Program& program);
    void takeDialog(const QString& state);

    QDir m_folder;
    QTemporaryDir m_models;
};

void TestScreenshots::states_data()
{
    QTest::addColumn<ui::ThemeChoice>("theme");
    QTest::addColumn<QString>("locale");
    QTest::addColumn<Extent>("extent");
    const auto add = [](ui::ThemeChoice theme, const char* locale, Extent extent) {
        QTest::addRow("%s %s", theme == ui::ThemeChoice::Light ? "light" : "dark", locale)
            << theme << QString::fromLatin1(locale) << extent;
    };
    using enum ui::ThemeChoice;
    using enum Extent;
    const bool isLong = effort() != Effort::Small;
    if (qApp->devicePixelRatio() > 1) { // scale factor set in tests/app/window/CMakeLists.txt
        add(Light, "de", isLong ? All : Panels);
        add(Dark, "zh_CN", isLong ? All : Window);
        return;
    }
    for (const ui::ThemeChoice theme : {Light, Dark}) {
        for (const char* locale : {"en", "de", "zh_CN"}) {
            const bool isGerman = qstrcmp(locale, "de") == 0; // German texts are the longest
            if (isLong || isGerman == (theme == Dark))
                add(theme, locale, isLong || isGerman ? All : Window);
        }
    }
}

void TestScreenshots::states()
{
    if (!ui::graphicsProblem().isEmpty())
        QSKIP("There is no OpenGL here.");
    QFETCH(ui::ThemeChoice, theme);
    QFETCH(QString, locale);
    QFETCH(Extent, extent);
    m_folder.setPath(QStringLiteral(FETTLE_SCREENSHOT_DIR "/%1x %2")
                         .arg(qApp->devicePixelRatio())
                         .arg(QString::fromLatin1(QTest::currentDataTag())));
    QVERIFY(m_folder.mkpath(QStringLiteral(".")));

    const LoadedLanguage words(locale);
    ui::Preferences preferences;
    preferences.theme = theme;
    ui::Settings().set(preferences);
    Program program(Program::anyView);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.window.resize(smallScreen);
    program.document.opener().openStarter(core::Starter::Vase);
    QTRY_VERIFY(!program.document.job().isBusy());
    QTRY_VERIFY(program.window.viewport()->stats().patches > 0);
    QTest::mouseClick(program.window.viewport(), Qt::LeftButton, {}, program.window.viewport()->rect().center());
    QTRY_VERIFY(program.document.queue().isSettled());
    QTRY_COMPARE(program.window.size(), smallScreen);
    take(program.window, QStringLiteral("window"));
    if (extent == Extent::Panels)
        takePanels(program);
    else if (extent == Extent::All)
        takeAll(program);
}

void TestScreenshots::takeAll(Program& program)
{
    takeKeyHand(program);
    takeRecovery(program);
    takeStrokeBar(program);
    takeUnits(program);
    takePrint(program);
    takeRepair(program);
    takeExport(program);
    takePanels(program);
    takeMenus(program);
    takeDialogs(program);
    takeHelp(program);
    takeClass();
    takeLesson(program);
    takeLessonEditor(program);
}

void TestScreenshots::take(QWidget& window, const QString& state, const QSize& screen)
{
    QTest::qWait(settleMs);
    QVERIFY(window.grab().save(m_folder.filePath(state + QStringLiteral(".png")), nullptr, fastPng));
    const QStringList clipped = clippedTexts(window);
    QVERIFY2(clipped.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(state, clipped.join(QStringLiteral("; ")))));
    QVERIFY2(window.width() <= screen.width() && window.height() <= screen.height(), qPrintable(state));
}

void TestScreenshots::takeKeyHand(Program& program)
{
    ui::Viewport* view = program.window.viewport();
    program.window.action(QStringLiteral("brush.keys"))->trigger();
    QTest::keyClick(view, Qt::Key_Return);
    take(program.window, QStringLiteral("key-hand"));
    QTest::keyClick(view, Qt::Key_Return);
    program.window.action(QStringLiteral("brush.keys"))->trigger();
    QTRY_VERIFY(program.document.queue().isSettled());
}

/// Large texts are tested on a larger screen. Users of large texts have one, or hide panels.
void TestScreenshots::largerTexts_data()
{
    QTest::addColumn<ui::TextSize>("size");
    for (const ui::Named<ui::TextSize>& row : ui::textSizes)
        if (row.value != ui::TextSize::Normal)
            QTest::addRow("%s percent", row.key) << row.value;
}

void TestScreenshots::largerTexts()
{
    if (!ui::graphicsProblem().isEmpty())
        QSKIP("There is no OpenGL here.");
    QFETCH(ui::TextSize, size);
    m_folder.setPath(
        QStringLiteral(FETTLE_SCREENSHOT_DIR "/text %1").arg(QString::fromLatin1(QTest::currentDataTag())));
    QVERIFY(m_folder.mkpath(QStringLiteral(".")));
    const QFont usual = QApplication::font();
    QApplication::setFont(ui::scaled(usual, ui::factorOf(size)));
    {
        const LoadedLanguage words(QStringLiteral("de")); // German, because its texts are the longest
        Program program(Program::anyView);
        program.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&program.window));
        program.window.resize(largeScreen);
        program.document.opener().openStarter(core::Starter::Vase);
        QTRY_VERIFY(!program.document.job().isBusy());
        take(program.window, QStringLiteral("window"), largeScreen);
        program.window.action(QStringLiteral("edit.preferences"))->trigger();
        auto* dialog = program.window.findChild<QDialog*>(QStringLiteral("preferences"));
        take(*dialog, QStringLiteral("preferences"), largeScreen);
        dialog->close();
    }
    QApplication::setFont(usual);
}

void TestScreenshots::takeRecovery(Program& program)
{
    auto* bar = new ui::RecoveryBar(
        {QStringLiteral("a-vase-with-a-rather-long-name.glb"), QDateTime({2026, 11, 22}, {14, 3}), 128},
        &program.window);
    take(program.window, QStringLiteral("recovery"));
    bar->findChild<QPushButton*>(QStringLiteral("discardRecovery"))->click();
    take(*QApplication::activeModalWidget(), QStringLiteral("recovery-question"));
    QApplication::activeModalWidget()->close();
    bar->dismiss();
}

void TestScreenshots::takeStrokeBar(Program& program)
{
    ui::ModelInfo facts;
    facts.size = {100, 100, 100};
    QList<ui::ToolOption> tools;
    for (const core::Tool tool : {core::Tool::Pull, core::Tool::Flatten, core::Tool::Smooth})
        tools.append(
            {tool, program.window.action(QStringLiteral("tool.") + QLatin1StringView(core::name(tool).data()))});
    auto* bar = new ui::StrokeEditBar({core::Tool::Flatten, 12.5, 0.8}, facts, tools, &program.window);
    bar->setHint(QCoreApplication::translate("app::StrokeEdit", "With this brush it does nothing."));
    take(program.window, QStringLiteral("stroke-bar"));
    bar->dismiss();
}

void TestScreenshots::takeUnits(Program& program)
{
    for (const auto guess : {core::UnitDoubt::Inches, core::UnitDoubt::Metres}) {
        auto* bar =
            new ui::UnitBar({QStringLiteral("a-model-with-a-rather-long-name.stl"), 1.234, guess}, &program.window);
        take(program.window, QStringLiteral("units-%1").arg(static_cast<int>(guess)));
        bar->dismiss();
    }
}

/// Takes pictures of the vase's thinnest wall with thickness colours, then of its overhangs.
void TestScreenshots::takePrint(Program& program)
{
    program.window.action(QStringLiteral("model.printCheck"))->trigger();
    auto* findings = program.window.findChild<QListWidget*>(QStringLiteral("print.findings"));
    auto* picture = program.window.findChild<QComboBox*>(QStringLiteral("print.picture"));
    for (int shown = 1; shown < picture->count(); ++shown) {
        picture->setCurrentIndex(shown);
        QTRY_VERIFY(findings->isEnabled() && findings->count() > 0);
        take(program.window, QStringLiteral("print-%1").arg(shown));
    }
    for (int row = 0; row < findings->count(); ++row)
        if (findings->item(row)->text().startsWith(u' ')) { // indented rows are places
            findings->setCurrentRow(row);
            QTest::keyClick(findings, Qt::Key_Return);
            QTest::qWait(flightMs);
            take(program.window, QStringLiteral("print-place"));
            break;
        }
    program.window.findChild<QAbstractButton*>(QStringLiteral("print.printers"))->click();
    takeDialog(QStringLiteral("printers"));
    program.window.findChild<ui::SidePanel*>(QStringLiteral("printPanel"))->setState(ui::SidePanel::State::Hidden);
    program.window.action(QStringLiteral("view.frame"))->trigger();
}

void TestScreenshots::takeRepair(Program& program)
{
    core::MeshReport report;
    report.openEdges.count = 1234;
    report.nonManifoldEdges.count = 12;
    report.misorientedEdges.count = 345;
    report.intersections.count = 6789;
    const QString problem =
        ui::ErrorMessages::refusal(QStringLiteral("/home/someone/Models/scans/a-scan-with-a-long-name.obj"), report);
    ui::askToRepair(&program.window, ui::RepairUse::Opening, problem, [](const auto&) {});
    takeDialog(QStringLiteral("repair"));
    ui::askToRepair(&program.window, ui::RepairUse::Insertion, problem, [](const auto&) {});
    takeDialog(QStringLiteral("repair-and-insert"));
    core::RepairResult anew;
    anew.mesh = core::icosphere(3, 20);
    anew.report.size = 40;
    anew.report.remeshedAt = 0.62;
    anew.report.before = {5026.5, 33000, 1280};
    anew.report.after = {4900, 32100, 1};
    anew.report.fromOld = {1.2, 0.3};
    anew.report.fromNew = {0.9, 0.2};
    const auto doubt = repairDoubt(ui::RepairUse::Opening, QStringLiteral("a-scan-with-a-long-name.obj"), anew,
                                   core::icosphere(2, 20));
    ui::askToAccept(&program.window, *doubt, [] {});
    takeDialog(QStringLiteral("repaired-but-changed"));
    core::RepairReport steps;
    steps.welded = 1234;
    steps.degenerateFaces = steps.duplicateFaces = 56;
    steps.turnedFaces = 345;
    steps.holes = 7;
    steps.largeHoles = steps.innerParts = 1;
    steps.intersections = 6789;
    steps.touchingEdges = 12;
    steps.fromOld.largest = 0.123;
    steps.joined = 1234;
    steps.joinedWithin = 0.0123;
    ui::showRepaired(&program.window, ui::RepairUse::Opening, QStringLiteral("a-scan-with-a-long-name.obj"),
                     ui::RepairMessages::steps(steps) + ui::RepairMessages::losses(steps));
    takeDialog(QStringLiteral("repaired"));
}

void TestScreenshots::takeExport(Program& program)
{
    program.window.action(QStringLiteral("file.exportFor"))->trigger();
    QTRY_VERIFY(QApplication::activeModalWidget());
    QApplication::activeModalWidget()->findChild<QAbstractButton*>(QStringLiteral("glb"))->click();
    takeDialog(QStringLiteral("export"));
    program.document.saver().exportTo(m_models.filePath(QStringLiteral("vase.stl")), {.maxTriangles = 2000});
    const auto* banner = program.window.findChild<QLabel*>(QStringLiteral("banner"));
    QTRY_VERIFY(banner->isVisible() && banner->text().contains(QStringLiteral("vase.stl")));
    const auto* scaleBar = program.window.findChild<QWidget*>(QStringLiteral("scaleBar"));
    QVERIFY(scaleBar->isVisible() && !scaleBar->geometry().intersects(banner->geometry()));
    take(program.window, QStringLiteral("export-verdict"));
}

/// Takes a picture of the open dialog and closes it.
void TestScreenshots::takeDialog(const QString& state)
{
    QDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) && dialog->isVisible());
    take(*dialog, state);
    dialog->reject();
    QTRY_VERIFY(!QApplication::activeModalWidget());
}

void TestScreenshots::takePanels(Program& program)
{
    for (ui::SidePanel* panel : program.window.findChild<ui::SideColumn*>()->panels()) {
        const ui::SidePanel::State before = panel->state();
        panel->bringForward();
        if (const auto* presets = panel->findChild<QListWidget*>(QStringLiteral("presets")))
            QTRY_VERIFY(isDrawn(*presets));
        QTRY_COMPARE(program.window.size(), smallScreen);
        take(program.window, QStringLiteral("panel-") + panel->objectName());
        panel->setState(before);
    }
    for (QDockWidget* panel : program.window.findChildren<QDockWidget*>()) {
        if (qobject_cast<ui::SideColumn*>(panel))
            continue;
        panel->show();
        if (auto* files = panel->findChild<ui::FileBrowser*>())
            showModels(files);
        if (auto* drawing = panel->findChild<ui::DrawingCanvas*>())
            QTRY_VERIFY(inked(drawing->picture()) > 0 &&
                        !panel->findChild<QLabel*>(QStringLiteral("preview.note"))->isVisible());
        QTRY_COMPARE(program.window.size(), smallScreen);
        take(program.window, QStringLiteral("panel-") + panel->objectName());
        panel->hide();
    }
}

void TestScreenshots::showModels(ui::FileBrowser* panel)
{
    constexpr std::pair<const char*, core::Starter> models[] = {{"vase.stl", core::Starter::Vase},
                                                                {"head.ply", core::Starter::Head},
                                                                {"ring.obj", core::Starter::Torus},
                                                                {"cube.stl", core::Starter::Cube}};
    for (const auto& [name, starter] : models)
        core::writeMesh(m_models.filePath(QLatin1StringView(name)).toStdU16String(), core::starterModel(starter));
    QVERIFY(QDir(m_models.path()).mkpath(QStringLiteral("older")));
    QVERIFY(QFile(m_models.filePath(QStringLiteral("empty.stl"))).open(QIODevice::WriteOnly));
    panel->goTo(m_models.path());
    QTRY_COMPARE(panel->findChild<QListView*>()->model()->rowCount(), 6);
    QTRY_VERIFY(!panel->findChild<QWidget*>(QStringLiteral("files.stop"))->isVisible());
}

void TestScreenshots::takeMenus(Program& program)
{
    int number = 0;
    for (const QAction* title : program.window.menuBar()->actions()) {
        title->menu()->popup(program.window.mapToGlobal(QPoint(20, 20)));
        take(*title->menu(), QStringLiteral("menu-%1").arg(++number));
        title->menu()->close();
    }
}

void TestScreenshots::takeDialogs(Program& program)
{
    for (const char* id : {"edit.preferences", "edit.classroom", "file.timeLapse", "help.keys", "help.about",
                           "model.scale", "model.mirror", "model.symmetrize", "model.remesh", "model.flattenBase"}) {
        program.window.action(QLatin1StringView(id))->trigger();
        QDialog* dialog = nullptr;
        QTRY_VERIFY((dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())));
        auto* pages = dialog->findChild<QTabWidget*>();
        for (int page = 0; page < (pages ? pages->count() : 1); ++page) {
            if (pages)
                pages->setCurrentIndex(page);
            take(*dialog, QStringLiteral("%1-%2").arg(QLatin1StringView(id)).arg(page));
        }
        dialog->reject();
        QTRY_VERIFY(!QApplication::activeModalWidget());
    }
}

void TestScreenshots::takeHelp(Program& program)
{
    program.window.action(QStringLiteral("help.start"))->trigger();
    auto* start = program.window.findChild<ui::StartPage*>();
    QTRY_VERIFY(start->isVisible());
    take(program.window, QStringLiteral("start"));
    start->close();
    program.window.action(QStringLiteral("help.guide"))->trigger();
    auto* guide = program.window.findChild<ui::GuideWindow*>();
    QTRY_VERIFY(guide && guide->isVisible());
    auto* pages = guide->findChild<QListWidget*>();
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentRow(page);
        QVERIFY(!guide->findChild<QTextBrowser*>()->toPlainText().contains(
            QLatin1StringView("**"))); // would show that Markdown was not interpreted
        take(*guide, QStringLiteral("guide-%1").arg(page + 1));
    }
    guide->close();
}

/// Takes pictures of a class from the first question to the time warning, with an undelivered work.
void TestScreenshots::takeClass()
{
    const QTemporaryDir own;
    const QList<core::Starter> starters(std::begin(core::starters), std::end(core::starters));
    ui::Classroom classroom{QStringLiteral("5b, Tuesday"),
                            own.filePath(QStringLiteral("none")),
                            starters,
                            {core::Tool::Pull, core::Tool::Smooth}};
    classroom.fullScreen = false;
    classroom.asksQuestions = true;
    RecoveryStore store(own.filePath(QStringLiteral("journals")).toStdString());
    Program program(Program::anyView);
    program.document.journaling().setRecoveryStore(&store);
    qint64 now = 0;
    const ClassPaths places{{}, own.filePath(QStringLiteral("waiting")), own.filePath(QStringLiteral("turn.json"))};
    ClassroomMode mode({&program.window, &program.document, &store}, classroom, places, [&now] { return now; });
    connectClassroom(program.window, mode);
    program.window.resize(smallScreen);
    program.window.show();
    mode.begin();
    const auto* panel = program.window.findChild<ui::PupilNamePanel*>();
    auto* name = program.window.findChild<QLineEdit*>(QStringLiteral("pupilName"));
    auto* next = program.window.findChild<QPushButton*>(QStringLiteral("classNext"));
    QTRY_VERIFY(panel->isVisible() && !program.document.job().isBusy());
    QTRY_COMPARE(program.window.size(), smallScreen);
    const auto isReadable = [&program] {
        return program.window.viewport()->stats().patches > 0 && clippedTexts(program.window).isEmpty();
    };
    // The name panel covers the view. The view receives the clay when it is shown.
    QTRY_COMPARE(panel->geometry(), program.window.viewport()->rect());
    QTRY_VERIFY(program.document.modelInfo().vertices > 0 && clippedTexts(program.window).isEmpty());
    take(program.window, QStringLiteral("class-name"));
    const auto begin = [&](const QString& pupil) {
        QTest::keyClicks(name, pupil);
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_VERIFY(next->isEnabled() && !program.document.job().isBusy() && isReadable());
    };
    begin(QStringLiteral("Anna-Lena the Great"));
    take(program.window, QStringLiteral("class-turn"));
    next->click();
    const auto* questions = program.window.findChild<ui::QuestionnairePanel*>();
    QTRY_VERIFY(questions->isVisible() && !program.document.job().isBusy());
    for (const char* point : {"question1.6", "question2.4", "question4.7"})
        program.window.findChild<QAbstractButton*>(QLatin1StringView(point))->click();
    take(program.window, QStringLiteral("class-questions"));
    takeSmallForm(program.window);
    program.window.findChild<QPushButton*>(QStringLiteral("questionsDone"))->click();
    QTRY_VERIFY(panel->isVisible() && !program.document.job().isBusy());
    begin(QStringLiteral("Ben"));
    now = 18 * 60'000;
    mode.tick();
    take(program.window, QStringLiteral("class-warning"));
    program.window.setHeadset(ui::HeadsetState::In, {});
    take(program.window, QStringLiteral("class-vr"));
    program.window.setHeadset(ui::HeadsetState::Out, {});
    program.window.close();
    takeDialog(QStringLiteral("class-pin"));
}

/// The form must be usable at 640 x 360, a screen of 1280 x 720 at 200 %: each answer is visible or can be scrolled to,
/// and no text is clipped.
void TestScreenshots::takeSmallForm(QWidget& window)
{
    constexpr QSize size(smallScreen.width() / 2, smallScreen.height() / 2);
    window.resize(size);
    QTRY_COMPARE(window.size(), size);
    QTest::qWait(settleMs);
    QVERIFY(window.grab().save(m_folder.filePath(QStringLiteral("class-questions-small.png")), nullptr, fastPng));
    const auto* panel = window.findChild<ui::QuestionnairePanel*>();
    const auto isWhole = [](const QWidget* widget) { return widget->visibleRegion().boundingRect() == widget->rect(); };
    for (const char* name : {"questionsDone", "skipQuestions"})
        QVERIFY2(isWhole(panel->findChild<QWidget*>(QLatin1StringView(name))), name);
    auto* scroll = panel->findChild<QScrollArea*>();
    QCOMPARE(scroll->horizontalScrollBar()->maximum(), 0);
    for (QWidget* point : panel->findChildren<QToolButton*>()) {
        scroll->ensureWidgetVisible(point);
        QVERIFY2(isWhole(point), qPrintable(point->objectName()));
        const QStringList clipped = clippedTexts(*panel);
        QVERIFY2(clipped.isEmpty(), qPrintable(clipped.join(QStringLiteral("; "))));
    }
    window.resize(smallScreen);
    QTRY_VERIFY(window.size() == smallScreen && clippedTexts(window).isEmpty());
}

/// Takes pictures of the lesson panel before the step, while the teacher plays, and afterwards.
void TestScreenshots::takeLesson(Program& program)
{
    program.document.opener().setDiscardPrompt([](const std::function<void()>&) { return true; });
    program.window.action(QStringLiteral("help.lessons"))->trigger();
    auto* dock = program.window.findChild<ui::SidePanel*>(QStringLiteral("lessonPanel"));
    QTRY_VERIFY(dock->isVisible());
    take(program.window, QStringLiteral("lessons"));
    Q_EMIT dock->findChild<ui::LessonPanel*>()->lessonChosen(QStringLiteral("first-clay"));
    auto* marks = dock->findChild<QLabel*>(QStringLiteral("lessonMarks"));
    QTRY_VERIFY(marks->isVisible() && marks->isEnabled());
    take(program.window, QStringLiteral("lesson"));
    dock->findChild<QPushButton*>(QStringLiteral("lessonPlay"))->click();
    QTRY_VERIFY(program.worker.strokes().isOpen());
    take(program.window, QStringLiteral("lesson-shown"));
    // one unmet mark: the model is the teacher's
    QTRY_COMPARE(marks->text().count(QChar(0x25CB)), 1);
    take(program.window, QStringLiteral("lesson-done"));
}

/// Takes pictures of the lesson editor: the choice of the start model, and each page of a step.
void TestScreenshots::takeLessonEditor(Program& program)
{
    program.window.action(QStringLiteral("lesson.record"))->trigger();
    auto* editor = program.window.findChild<ui::LessonEditor*>();
    QTRY_VERIFY(editor->isVisible());
    take(program.window, QStringLiteral("lesson-editor-start"));
    Q_EMIT editor->lessonChosen(QStringLiteral("mug"));
    QTRY_VERIFY(editor->isOpen());
    auto* pages = editor->findChild<ui::LessonStepEditor*>();
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        take(program.window, QStringLiteral("lesson-editor-%1").arg(page + 1));
    }
    editor->findChild<QPushButton*>(QStringLiteral("lessonRecord"))->click();
    QTRY_VERIFY(editor->findChild<QLabel*>(QStringLiteral("lessonState"))->text().startsWith(QChar(0x25CF)));
    take(program.window, QStringLiteral("lesson-editor-recording"));
}

static int screenshotsMain(int argc, char* argv[])
{
    ui::prepareGraphics();
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_screenshots"));
    TestScreenshots test;
    return QTest::qExec(&test, argc, argv);
}

FETTLE_TEST_MAIN(TestScreenshots, screenshotsMain)
#include "tst_screenshots.moc"
