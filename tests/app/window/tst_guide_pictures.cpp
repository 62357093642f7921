#include "app/headset/simulator_controller.h"
#include "core/io/mesh_io.h"
#include "core/primitives/starter_models.h"
#include "tests/app/window/loaded_language.h"
#include "tests/support/effort.h"
#include "tests/support/program.h"
#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"
#include "ui/brush/brush_palette.h"
#include "ui/gizmo/gizmo.h"
#include "ui/headset/simulator_view.h"
#include "ui/headset/simulator_window.h"
#include "ui/help/start_page.h"
#include "ui/history/recovery_bar.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/model/repair_dialogs.h"
#include "ui/model/unit_bar.h"
#include "ui/settings/settings.h"
#include "ui/util/error_messages.h"
#include "ui/viewport/navigation_cube.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/side_panel.h"
#include "ui/widgets/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QPainter>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>

#include <span>

using namespace app;

namespace
{
constexpr QSize windowSize{1000, 640}, narrowSize{820, 640};
constexpr int maxWidth = 700; ///< maximum width of a picture in pixels, equal to that of the guide's text
constexpr qint64 maxBytes = 3'200'000;
constexpr int flightMs = 600; ///< ms that the camera takes to fly to another side
constexpr int settleMs = 300; ///< ms that layouts and results of other threads take
const QString languageKey = QStringLiteral("Language"), textsKey = QStringLiteral("Texts");

QString textOf(const QWidget& widget)
{
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->text();
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget))
        return box->title();
    if (const auto* choice = qobject_cast<const QComboBox*>(&widget))
        return choice->currentText();
    return {};
}

/// Returns the texts in a part of a window, sorted and without numbers, which depend on the machine. Texts that a panel
/// cuts off are left out, because where it does so depends on the font.
QString visibleTexts(const QWidget& window, const QRect& part)
{
    QStringList texts;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const QRect whole = widget->rect();
        if (whole.isEmpty() || widget->visibleRegion().boundingRect() != whole ||
            !part.contains(whole.translated(widget->mapTo(&window, QPoint()))))
            continue;
        static const QRegularExpression number(QStringLiteral(R"([\d.,]*\d)"));
        const QString text = textOf(*widget).remove(number).simplified();
        if (!text.isEmpty())
            texts << text;
    }
    texts.sort();
    texts.removeDuplicates();
    return texts.join(u'\n');
}

/// Paints a white number in a dark circle. The guide refers to parts of the window by such numbers.
void paintNumber(QPainter& painter, const QPoint& middle, int number)
{
    QRect circle(0, 0, 26, 26);
    circle.moveCenter(middle);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(QColor(178, 34, 34));
    painter.setPen(QPen(Qt::white, 2));
    painter.drawEllipse(circle);
    QFont font = painter.font();
    font.setPixelSize(16);
    font.setBold(true);
    painter.setFont(font);
    painter.drawText(circle, Qt::AlignCenter, QString::number(number));
}

/// Returns whether the picture of the last preset has been drawn.
bool isDrawn(const QListView* presets)
{
    const QAbstractItemModel* model = presets->model();
    const QSize size = presets->iconSize();
    const auto icon = model->index(model->rowCount() - 1, 0).data(Qt::DecorationRole).value<QIcon>();
    return !icon.isNull() && icon.pixmap(size).toImage().pixelColor(size.width() / 2, size.height() / 2).alpha() > 0;
}

/// Returns the picture without the two lowest bits of each colour component. The difference is invisible and halves the
/// file.
QImage withoutNoise(const QImage& picture)
{
    QImage calm = picture.convertToFormat(QImage::Format_RGB888);
    for (int y = 0; y < calm.height(); ++y)
        for (uchar& value : std::span(calm.scanLine(y), 3 * calm.width()))
            value = static_cast<uchar>((value & 0xFC) | (value >> 6));
    return calm;
}

/// Returns whether the test writes the pictures instead of checking them.
bool isWritten()
{
    return qEnvironmentVariableIsSet("FETTLE_WRITE_PICTURES");
}

void waitForRest(Program& program)
{
    QTRY_VERIFY(!program.document.job().isBusy() && program.document.queue().isSettled() &&
                program.window.viewport()->stats().patches > 0);
}

/// Draws a mouse stroke. Coordinates are shares of the view's width and height, 0 to 1.
void stroke(Program& program, const QList<QPointF>& way)
{
    ui::Viewport* view = program.window.viewport();
    const auto at = [view](const QPointF& share) {
        return QPointF(share.x() * view->width(), share.y() * view->height()).toPoint();
    };
    sendMouse(view, QEvent::MouseMove, at(way.first()));
    QTest::qWait(settleMs);
    sendMouse(view, QEvent::MouseButtonPress, at(way.first()), Qt::LeftButton);
    const auto send = [&](QEvent::Type type, const QPoint& place, Qt::MouseButton button, Qt::MouseButtons held) {
        QMouseEvent event(type, place, view->mapToGlobal(place), button, held, Qt::NoModifier);
        QCoreApplication::sendEvent(view, &event);
    };
    for (const QPointF& share : way) {
        send(QEvent::MouseMove, at(share), Qt::NoButton, Qt::LeftButton);
        QTest::qWait(30);
    }
    send(QEvent::MouseButtonRelease, at(way.last()), Qt::LeftButton, Qt::NoButton);
    waitForRest(program);
}
} // namespace

/// Draws the pictures of the guide from the running program in each language: resources/help/<language>/pictures.
/// FETTLE_WRITE_PICTURES=1 writes them again (see tests/README.md). Otherwise the existing pictures must have the
/// program's current texts and about the same size.
/// Each picture file contains its texts as metadata, because pixels differ between graphics drivers.
class TestGuidePictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pictures_data();
    void pictures();
    void simulator_data() { pictures_data(); }
    void simulator();
    void allTogether_areSmall();

private:
    void begin(Program& program);
    void takeStart(Program& program);
    void takeWindow(Program& program);
    void takePalette(Program& program);
    void takeHandles(Program& program);
    void takeTube(Program& program);
    void takeCut(Program& program);
    void takeHistory(Program& program);
    void takePresets(Program& program);
    void takePrint(Program& program);
    void takeBars(Program& program);
    void takeRepair(Program& program);
    void takeLesson(Program& program);
    void takeDialog(Program& program, const QString& action, const QString& name);
    void take(const QWidget& widget, const QString& name, QRect part = {});
    void check(QImage picture, const QString& texts, const QString& name);

    QDir m_folder;
    QString m_language;
};

void TestGuidePictures::pictures_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("en") << QStringLiteral("en");
    if (effort() == Effort::Small && !isWritten())
        return;
    for (const char* language : {"de", "zh_CN"})
        QTest::newRow(language) << QString::fromLatin1(language);
}

void TestGuidePictures::begin(Program& program)
{
    ui::Preferences preferences;
    preferences.theme = ui::ThemeChoice::Light;
    ui::Settings().set(preferences);
    program.window.resize(windowSize);
    program.window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&program.window));
    program.document.opener().setDiscardPrompt({});
    program.document.opener().openStarter(core::Starter::Head);
    waitForRest(program);
}

void TestGuidePictures::pictures()
{
    if (!ui::graphicsProblem().isEmpty())
        QSKIP("There is no OpenGL here.");
    QFETCH(QString, language);
    m_language = language;
    m_folder.setPath(QStringLiteral(FETTLE_GUIDE_DIR "/%1/pictures").arg(language));
    QVERIFY(m_folder.mkpath(QStringLiteral(".")));
    QSettings().clear();
    const LoadedLanguage words(language);
    Program program(Program::anyView);
    begin(program);
    takeStart(program);
    takeWindow(program);
    takePalette(program);
    program.window.resize(narrowSize);
    QTRY_COMPARE(program.window.size(), narrowSize);
    takeHandles(program);
    takeTube(program);
    takeCut(program);
    takeHistory(program);
    takePresets(program);
    takePrint(program);
    takeBars(program);
    takeRepair(program);
    takeDialog(program, QStringLiteral("file.exportFor"), QStringLiteral("export"));
    takeDialog(program, QStringLiteral("file.timeLapse"), QStringLiteral("time-lapse"));
    takeDialog(program, QStringLiteral("edit.classroom"), QStringLiteral("class"));
    takeLesson(program);
}

/// Takes a picture of `part` of the widget, or of the whole widget if `part` is invalid.
void TestGuidePictures::take(const QWidget& widget, const QString& name, QRect part)
{
    QTest::qWait(settleMs);
    part = part.isValid() ? part : widget.rect();
    const QString texts = QImage(m_folder.filePath(name + QStringLiteral(".png"))).text(textsKey);
    if (!isWritten()) // a layout may take longer than settleMs
        (void)QTest::qWaitFor([&] { return visibleTexts(widget, part) == texts; }, longestWait);
    check(const_cast<QWidget&>(widget).grab(part).toImage(), visibleTexts(widget, part), name);
}

void TestGuidePictures::check(QImage picture, const QString& texts, const QString& name)
{
    if (picture.width() > maxWidth)
        picture = picture.scaledToWidth(maxWidth, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(1);
    const QString path = m_folder.filePath(name + QStringLiteral(".png"));
    QVERIFY2(!texts.isEmpty(), qPrintable(path));
    if (isWritten()) {
        picture = withoutNoise(picture);
        picture.setText(languageKey, m_language);
        picture.setText(textsKey, texts);
        QVERIFY(picture.save(path, "PNG", 0));
        return;
    }
    const QImage old(path);
    QVERIFY2(!old.isNull(), qPrintable(path + QStringLiteral(": there is no such picture")));
    QCOMPARE(old.text(languageKey), m_language);
    const QStringList recorded = old.text(textsKey).split(u'\n'), shown = texts.split(u'\n');
    for (const QString& text : recorded)
        QVERIFY2(shown.contains(text), qPrintable(path + QStringLiteral(": the program lacks: ") + text));
    for (const QString& text : shown)
        QVERIFY2(recorded.contains(text), qPrintable(path + QStringLiteral(": the picture lacks: ") + text));
    const auto isAbout = [](int a, int b) { return std::abs(a - b) <= std::max(a, b) / 8; };
    QVERIFY2(isAbout(old.width(), picture.width()) && isAbout(old.height(), picture.height()), qPrintable(path));
}

void TestGuidePictures::takeStart(Program& program)
{
    program.window.action(QStringLiteral("help.start"))->trigger();
    auto* start = program.window.findChild<ui::StartPage*>();
    QTRY_VERIFY(start->isVisible());
    take(program.window, QStringLiteral("start"));
    start->close();
}

/// Takes a picture of a partly sculpted head, with a number on each part of the window.
void TestGuidePictures::takeWindow(Program& program)
{
    program.window.action(QStringLiteral("view.front"))->trigger();
    QTest::qWait(flightMs);
    program.window.action(QStringLiteral("symmetry.on"))->trigger();
    program.window.action(QStringLiteral("tool.push"))->trigger();
    stroke(program, {{0.44, 0.37}, {0.45, 0.37}, {0.46, 0.375}});
    program.window.action(QStringLiteral("tool.pull"))->trigger();
    stroke(program, {{0.5, 0.38}, {0.5, 0.41}, {0.5, 0.44}, {0.5, 0.46}});
    stroke(program, {{0.5, 0.44}, {0.5, 0.46}});
    QTest::qWait(settleMs);
    const ui::MainWindow& window = program.window;
    QImage picture = program.window.grab().toImage();
    {
        QPainter painter(&picture);
        const auto placeOf = [&window](const QWidget* part, const QPoint& at) { return part->mapTo(&window, at); };
        const auto* palette = window.findChild<QWidget*>(QStringLiteral("toolPalette"));
        const auto* bar = window.findChild<QWidget*>(QStringLiteral("toolBar"));
        const auto* cube = window.findChild<ui::NavigationCube*>();
        const auto* column = window.findChild<ui::SideColumn*>();
        const auto* view = program.window.viewport();
        QVERIFY(palette && bar && cube && column);
        int number = 0;
        for (const QPoint& place :
             {placeOf(palette, {palette->width() / 2, palette->height() - 40}),
              placeOf(bar, {bar->width() - 40, bar->height() / 2}), placeOf(view, {60, view->height() / 2}),
              placeOf(cube, {0, cube->height() / 2}), placeOf(column, {column->width() / 2, column->height() / 2}),
              QPoint(window.width() / 3, window.height() - 14)})
            paintNumber(painter, place, ++number);
    }
    check(picture, visibleTexts(window, window.rect()), QStringLiteral("window"));
}

void TestGuidePictures::takePalette(Program& program)
{
    program.window.action(QStringLiteral("brush.palette"))->trigger();
    ui::BrushPalette* palette = nullptr;
    QTRY_VERIFY((palette = program.window.findChild<ui::BrushPalette*>()) && palette->isVisible());
    QTRY_VERIFY(isDrawn(palette->findChild<QListView*>()));
    QImage picture = program.window.grab().toImage();
    const QRect place(program.window.mapFromGlobal(palette->mapToGlobal(QPoint())), palette->size());
    {
        QPainter painter(&picture);
        painter.drawPixmap(place.topLeft(), palette->grab());
    }
    check(picture.copy(place.adjusted(-90, -50, 90, 50)), visibleTexts(*palette, palette->rect()),
          QStringLiteral("palette"));
    palette->close();
}

/// Takes a picture of the head with the handles on it.
void TestGuidePictures::takeHandles(Program& program)
{
    QAction* action = program.window.action(QStringLiteral("model.transform"));
    action->trigger();
    const auto* gizmo = program.window.findChild<ui::Gizmo*>(QStringLiteral("transformGizmo"));
    QTRY_VERIFY(gizmo->isVisible());
    const ui::Viewport* view = program.window.viewport();
    take(program.window, QStringLiteral("handles"), QRect(view->mapTo(&program.window, QPoint()), view->size()));
    action->trigger();
}

/// Returns the part of the view between two shares of its height.
static QRect partOfView(const Program& program, double from, double to)
{
    const ui::Viewport* view = program.window.viewport();
    const QRect part(0, int(from * view->height()), view->width(), int((to - from) * view->height()));
    return part.translated(view->mapTo(&program.window, QPoint()));
}

/// Takes a picture of two horns of the head, one drawn and one mirrored.
void TestGuidePictures::takeTube(Program& program)
{
    QAction* action = program.window.action(QStringLiteral("model.tube"));
    action->trigger();
    stroke(program, {{0.55, 0.3}, {0.6, 0.24}, {0.65, 0.2}, {0.69, 0.14}, {0.7, 0.08}});
    const auto* card = program.window.findChild<QWidget*>(QStringLiteral("tubeCard"));
    QTRY_VERIFY(card->isVisible());
    card->findChild<QCheckBox*>(QStringLiteral("tubeAllRadii"))->setChecked(true);
    card->findChild<QDoubleSpinBox*>(QStringLiteral("tubeRadius"))->setValue(5);
    take(program.window, QStringLiteral("tube"), partOfView(program, 0, 0.6));
    action->trigger();
}

/// Takes a picture of the plane that would cut the head.
void TestGuidePictures::takeCut(Program& program)
{
    QAction* action = program.window.action(QStringLiteral("area.plane"));
    action->trigger();
    const auto* gizmo = program.window.findChild<ui::Gizmo*>(QStringLiteral("planeCutGizmo"));
    QTRY_VERIFY(gizmo->isVisible());
    take(program.window, QStringLiteral("cut"), partOfView(program, 0.1, 1));
    action->trigger();
}

/// Opens the panel and folds all others.
static void openAlone(Program& program, ui::SidePanel* panel)
{
    for (ui::SidePanel* other : program.window.findChild<ui::SideColumn*>()->panels())
        if (other != panel && other->state() == ui::SidePanel::State::Open)
            other->setState(ui::SidePanel::State::Folded);
    panel->bringForward();
    QTest::qWait(settleMs); // waits for scrolling to the panel
}

/// Returns the area of the panel and the view beside it.
static QRect panelAndView(Program& program, ui::SidePanel* panel)
{
    QTest::qWait(settleMs); // waits for the layout of the column
    const QPoint corner = panel->mapTo(&program.window, QPoint());
    const int right = corner.x() + panel->width();
    const ui::Viewport* view = program.window.viewport();
    const int bottom =
        std::min(corner.y() + panel->height(), view->mapTo(&program.window, QPoint()).y() + view->height());
    return {std::max(right - maxWidth, 0), corner.y(), std::min(maxWidth, right), bottom - corner.y()};
}

void TestGuidePictures::takeHistory(Program& program)
{
    auto* panel = program.window.findChild<ui::SidePanel*>(QStringLiteral("historyPanel"));
    QVERIFY(panel);
    openAlone(program, panel);
    take(program.window, QStringLiteral("history"), panelAndView(program, panel));
}

void TestGuidePictures::takePresets(Program& program)
{
    auto* panel = program.window.findChild<ui::SidePanel*>(QStringLiteral("presetPanel"));
    QVERIFY(panel);
    openAlone(program, panel);
    const auto* presets = panel->findChild<QListWidget*>(QStringLiteral("presets"));
    QTRY_VERIFY(isDrawn(presets));
    take(program.window, QStringLiteral("presets"), panelAndView(program, panel));
}

void TestGuidePictures::takePrint(Program& program)
{
    program.window.action(QStringLiteral("model.printCheck"))->trigger();
    auto* panel = program.window.findChild<ui::SidePanel*>(QStringLiteral("printPanel"));
    QVERIFY(panel);
    openAlone(program, panel);
    const auto* findings = panel->findChild<QListWidget*>(QStringLiteral("print.findings"));
    panel->findChild<QComboBox*>(QStringLiteral("print.picture"))->setCurrentIndex(2); // shows the colours of overhangs
    QTRY_VERIFY(findings->isEnabled() && findings->count() > 0);
    take(program.window, QStringLiteral("print"), panelAndView(program, panel));
    panel->setState(ui::SidePanel::State::Hidden);
}

void TestGuidePictures::takeBars(Program& program)
{
    const auto takeBar = [&](auto* bar, const QString& name) {
        QTest::qWait(settleMs);
        take(program.window, name, {0, bar->mapTo(&program.window, QPoint()).y(), program.window.width(), 190});
        bar->dismiss();
    };
    takeBar(new ui::RecoveryBar({QStringLiteral("head.glb"), QDateTime({2026, 11, 22}, {14, 3}), 12}, &program.window),
            QStringLiteral("recovery"));
    takeBar(new ui::UnitBar({QStringLiteral("bunny.stl"), 1.5, core::UnitDoubt::Inches}, &program.window),
            QStringLiteral("unit"));
}

void TestGuidePictures::takeRepair(Program& program)
{
    core::MeshReport report;
    report.openEdges.count = 223;
    ui::askToRepair(&program.window, ui::RepairUse::Opening,
                    ui::ErrorMessages::refusal(QStringLiteral("bunny.obj"), report), [](const auto&) {});
    takeDialog(program, {}, QStringLiteral("repair"));
}

/// Takes a picture of the mug's first step.
void TestGuidePictures::takeLesson(Program& program)
{
    program.window.action(QStringLiteral("help.lessons"))->trigger();
    auto* panel = program.window.findChild<ui::SidePanel*>(QStringLiteral("lessonPanel"));
    QVERIFY(panel);
    openAlone(program, panel);
    Q_EMIT panel->findChild<ui::LessonPanel*>()->lessonChosen(QStringLiteral("mug"));
    const auto* marks = panel->findChild<QLabel*>(QStringLiteral("lessonMarks"));
    const QString ballHeight = QStringLiteral("100"); // in mm, which another thread measures
    QTRY_VERIFY(marks->isVisible() && marks->text().contains(ballHeight));
    waitForRest(program);
    QTest::qWait(flightMs);
    take(program.window, QStringLiteral("lesson"), panelAndView(program, panel));
}

/// Takes a picture of the dialog that the action opens, or of the open dialog if the action is empty, and closes it.
void TestGuidePictures::takeDialog(Program& program, const QString& action, const QString& name)
{
    if (!action.isEmpty())
        program.window.action(action)->trigger();
    QDialog* dialog = nullptr;
    QTRY_VERIFY((dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) && dialog->isVisible());
    take(*dialog, name);
    dialog->reject();
    QTRY_VERIFY(!QApplication::activeModalWidget());
}

/// Takes a picture of the simulator's window with a head in the room.
void TestGuidePictures::simulator()
{
    if (!ui::graphicsProblem().isEmpty())
        QSKIP("There is no OpenGL here.");
    if (QGuiApplication::platformName() != QStringLiteral("xcb"))
        QSKIP("The simulator needs X11.");
    QFETCH(QString, language);
    m_language = language;
    m_folder.setPath(QStringLiteral(FETTLE_GUIDE_DIR "/%1/pictures").arg(language));
    QSettings().clear();
    const LoadedLanguage words(language);
    Program program;
    begin(program);
    new SimulatorController(&program.window, &program.worker, Simulator::open(QStringLiteral(FETTLE_BUILD_DIR)));
    auto* simulator = program.window.findChild<ui::SimulatorWindow*>();
    program.window.action(QStringLiteral("vr.enter"))->trigger();
    QTRY_VERIFY(!simulator->view()->picture().isNull());
    for (int frame = 0; frame < 30; ++frame) {
        const qint64 before = simulator->view()->picture().cacheKey();
        sendMouse(simulator->view(), QEvent::MouseMove, simulator->view()->rect().center() + QPoint(20 + frame, 0));
        QTRY_VERIFY(simulator->view()->picture().cacheKey() != before);
    }
    take(*simulator, QStringLiteral("simulator"));
    program.window.action(QStringLiteral("vr.enter"))->trigger();
    QTRY_VERIFY(!simulator->isVisible());
}

void TestGuidePictures::allTogether_areSmall()
{
    qint64 bytes = 0;
    for (const char* language : {"en", "de", "zh_CN"}) {
        const QDir folder(QStringLiteral(FETTLE_GUIDE_DIR "/%1/pictures").arg(QLatin1StringView(language)));
        for (const QFileInfo& file : folder.entryInfoList(QDir::Files)) {
            bytes += file.size();
            QVERIFY2(QImage(file.filePath()).width() <= maxWidth, qPrintable(file.filePath()));
        }
    }
    QVERIFY2(bytes > 0 && bytes < maxBytes, qPrintable(QString::number(bytes)));
}

static int guidePicturesMain(int argc, char* argv[])
{
    ui::prepareGraphics();
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("FettleTest"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_guide_pictures"));
    TestGuidePictures test;
    return QTest::qExec(&test, argc, argv);
}

FETTLE_TEST_MAIN(TestGuidePictures, guidePicturesMain)
#include "tst_guide_pictures.moc"
