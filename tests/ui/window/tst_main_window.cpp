#include "ui/actions/actions.h"
#include "ui/actions/command_list.h"
#include "ui/brush/brush_palette.h"
#include "ui/brush/color_wheel.h"
#include "ui/brush/falloff_curve.h"
#include "ui/classroom/classroom_dialog.h"
#include "ui/settings/settings.h"
#include "ui/util/format_filters.h"
#include "ui/widgets/side_column.h"
#include "ui/window/main_window.h"
#include "ui/window/tool_palette.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>

using core::Parameter;
using ui::MainWindow;

namespace
{
ui::ModelInfo modelInfo(const QString& name, double size)
{
    const core::Vec3 half = core::Vec3::Constant(size / 2);
    return {name, 2562, 5120, 2 * half, core::Box(-half, half)};
}

QAction* act(const MainWindow& window, const char* id)
{
    return window.action(QLatin1StringView(id));
}

template <class Widget> Widget* child(const MainWindow& window, const char* name)
{
    return window.findChild<Widget*>(QLatin1StringView(name));
}
} // namespace

class TestMainWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    void itShowsItselfOrSaysWhyNot()
    {
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const bool canDraw = ui::graphicsProblem().isEmpty();
        QCOMPARE(window.viewport()->isVisible(), canDraw);
        const auto* sentence = child<QLabel>(window, "graphicsProblem");
        QCOMPARE(sentence != nullptr, !canDraw);
        if (sentence)
            QCOMPARE(sentence->text(), ui::graphicsProblem());
        window.setModel(modelInfo(QStringLiteral("ball"), 100));
        window.grab();
    }

    void aModelIsNamedAndMeasured()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("lion.stl"), 80));
        QVERIFY(window.windowTitle().startsWith(QStringLiteral("lion.stl[*]")));
        QCOMPARE(child<QLabel>(window, "facts.name")->text(), QStringLiteral("lion.stl"));
        QVERIFY(child<QLabel>(window, "facts.vertices")->text().contains(QLocale().toString(2562)));
        QVERIFY(child<QLabel>(window, "facts.size")->text().contains(QLocale().toString(80.0, 'f', 1)));
        window.showSaved(modelInfo(QStringLiteral("lion-001.glb"), 80)); // saved from VR under another name
        QVERIFY(window.windowTitle().startsWith(QStringLiteral("lion-001.glb[*]")));
        QCOMPARE(child<QLabel>(window, "facts.name")->text(), QStringLiteral("lion-001.glb"));
        QVERIFY(!window.isWindowModified());
        window.setWindowModified(true);
        QVERIFY(window.isWindowModified());

        ui::ModelInfo more = modelInfo(QStringLiteral("lion.stl"), 80);
        more.vertices = 3000;
        window.updateModelInfo(more);
        QVERIFY(child<QLabel>(window, "facts.vertices")->text().contains(QLocale().toString(3000)));
        QVERIFY(window.isWindowModified());
    }

    void newBeginsWithTheStarter()
    {
        MainWindow window;
        QSignalSpy requested(window.files(), &ui::ModelFiles::starterRequested);
        window.action(QStringLiteral("new.vase"))->trigger();
        QCOMPARE(requested.size(), 1);
        QCOMPARE(requested.at(0).at(0).value<core::Starter>(), core::Starter::Vase);
    }

    void whatNeedsAFile_restsWithoutOne()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 80));
        window.progress()->begin(QStringLiteral("Thinking"));
        for (const char* id : {"file.save", "file.saveCopy", "file.revert", "model.reset"})
            QVERIFY2(!act(window, id)->isEnabled(), id);
        for (const char* id : {"file.open", "new.vase", "file.quit"}) // allowed while a file is being opened
            QVERIFY2(act(window, id)->isEnabled(), id);
        window.progress()->end();
        for (const char* id : {"file.open", "file.save", "file.saveCopy", "model.reset"})
            QVERIFY2(act(window, id)->isEnabled(), id);
        QVERIFY(!act(window, "file.revert")->isEnabled());
    }

    void recentFilesAreOfferedTheLatestFirst()
    {
        const auto open = [](MainWindow& window, const QString& path) {
            ui::ModelInfo model = modelInfo(QFileInfo(path).fileName(), 80);
            model.path = path;
            window.setModel(model);
        };
        {
            MainWindow window;
            QVERIFY(!child<QMenu>(window, "recentMenu")->isEnabled());
            QVERIFY(!window.action(QStringLiteral("file.revert"))->isEnabled());
            for (const char* name : {"/a/lion.stl", "/a/ox & cow.stl", "/a/lion.stl"})
                open(window, QString::fromLatin1(name));
            QVERIFY(window.action(QStringLiteral("file.revert"))->isEnabled());
        }
        MainWindow window;
        const auto* menu = child<QMenu>(window, "recentMenu");
        QVERIFY(menu->isEnabled());
        QCOMPARE(menu->actions().size(), qsizetype(4)); // two files, a separator and Clear
        QCOMPARE(menu->actions().at(0)->text(), QStringLiteral("lion.stl"));
        QSignalSpy requested(window.files(), &ui::ModelFiles::openRequested);
        menu->actions().at(1)->trigger();
        QCOMPARE(requested.at(0).at(0).toString(), QStringLiteral("/a/ox & cow.stl"));
        menu->actions().last()->trigger();
        QTRY_VERIFY(menu->isEmpty() && !menu->isEnabled());
    }

    void theRadiusFitsTheModel()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        QCOMPARE(window.brush()->stroke().radius, 10.0);
        window.setModel(modelInfo(QStringLiteral("b"), 2));
        QCOMPARE(window.brush()->stroke().radius, 0.2);
        window.brush()->scaleRadius(1e9);
        QCOMPARE(window.brush()->stroke().radius, 1.0);
    }

    void bracketsScaleTheRadius()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        act(window, "brush.smaller")->trigger();
        QCOMPARE(window.brush()->stroke().radius, 9.0);
        act(window, "brush.larger")->trigger();
        QCOMPARE(window.brush()->stroke().radius, 10.0);
    }

    void theRadiusFollowsThePointer_data()
    {
        QTest::addColumn<int>("end"); // the key or mouse button that ends the adjustment
        QTest::addColumn<bool>("isKey");
        QTest::addColumn<bool>("keeps");
        QTest::newRow("click") << int(Qt::LeftButton) << false << true;
        QTest::newRow("Return") << int(Qt::Key_Return) << true << true;
        QTest::newRow("F again") << int(Qt::Key_F) << true << true;
        QTest::newRow("right button") << int(Qt::RightButton) << false << false;
        QTest::newRow("Esc") << int(Qt::Key_Escape) << true << false;
    }

    void theRadiusFollowsThePointer()
    {
        SKIP_WITHOUT_GRAPHICS();
        QFETCH(int, end);
        QFETCH(bool, isKey);
        QFETCH(bool, keeps);
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        ui::Viewport* view = window.viewport();
        const QSignalSpy strokes(view->input(), &ui::PointerInput::strokeBegan),
            stops(window.action(QStringLiteral("edit.stop")), &QAction::triggered),
            questions(view->input(), &ui::PointerInput::hoverRequested);
        for (const auto& [key, modifiers, parameter] :
             {std::tuple(Qt::Key_F, Qt::NoModifier, Parameter::Radius),
              std::tuple(Qt::Key_F, Qt::ShiftModifier, Parameter::Strength)}) {
            const double before = window.brush()->value(parameter);
            const auto asked = questions.size();
            QTest::keyClick(&window, key, modifiers);
            auto* word = child<QLabel>(window, "brushDrag");
            QVERIFY(word->isVisible());
            sendMouse(view, QEvent::MouseMove, {200, 200});
            QCOMPARE(window.brush()->value(parameter), before);
            const int beside = word->x();
            sendMouse(view, QEvent::MouseMove, {230, 190});
            const double wider = window.brush()->value(parameter);
            QVERIFY(wider > before && !word->text().isEmpty());
            QCOMPARE(word->x() > beside, parameter == Parameter::Radius); // the text moves with the ring
            sendMouse(view, QEvent::MouseMove, {170, 200});
            QVERIFY(window.brush()->value(parameter) < before);
            sendMouse(view, QEvent::MouseMove, {230, 200});
            QCOMPARE(window.brush()->value(parameter), wider);
            if (isKey) {
                QTest::keyClick(window.windowHandle(), Qt::Key(end), end == Qt::Key_F ? modifiers : Qt::NoModifier);
            } else {
                sendMouse(view, QEvent::MouseButtonPress, {230, 200}, Qt::MouseButton(end));
                sendMouse(view, QEvent::MouseButtonRelease, {230, 200}, Qt::MouseButton(end));
            }
            QVERIFY(!word->isVisible());
            QCOMPARE(window.brush()->value(parameter), keeps ? wider : before);
            QCOMPARE(questions.size(), asked); // no hover requests meanwhile
            sendMouse(view, QEvent::MouseMove, {300, 200});
            QCOMPARE(window.brush()->value(parameter), keeps ? wider : before);
        }
        QVERIFY(strokes.isEmpty() && stops.isEmpty());
    }

    void theTurntableTurnsTheView()
    {
        {
            MainWindow window;
            window.setModel(modelInfo(QStringLiteral("a"), 100));
            const core::Vec3 eye = window.viewport()->camera().eye();
            child<QDoubleSpinBox>(window, "turnSpeed")->setValue(200);
            auto* direction = child<QComboBox>(window, "turnDirection");
            direction->setCurrentIndex(1);
            Q_EMIT direction->activated(1);
            act(window, "turntable.on")->trigger();
            QVERIFY(child<QCheckBox>(window, "turns")->isChecked());
            QTRY_VERIFY((window.viewport()->camera().eye() - eye).norm() > 1);
            QVERIFY(std::abs(window.viewport()->camera().eye().y() - eye.y()) < 1e-6);
            child<QCheckBox>(window, "turns")->click();
            QVERIFY(!act(window, "turntable.on")->isChecked());
            const core::Vec3 there = window.viewport()->camera().eye();
            QTest::qWait(60);
            QCOMPARE(window.viewport()->camera().eye(), there);
        }
        MainWindow window; // direction and speed are restored, but the turntable is off
        QCOMPARE(child<QDoubleSpinBox>(window, "turnSpeed")->value(), 200.0);
        QCOMPARE(child<QComboBox>(window, "turnDirection")->currentIndex(), 1);
        QVERIFY(!act(window, "turntable.on")->isChecked());
    }

    void addingABallIsArmedOnce()
    {
        SKIP_WITHOUT_GRAPHICS();
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const QSignalSpy spheres(window.viewport()->input(), &ui::PointerInput::sphereRequested);
        const auto click = [&] {
            sendMouse(window.viewport(), QEvent::MouseButtonPress, {30, 40}, Qt::LeftButton);
            sendMouse(window.viewport(), QEvent::MouseButtonRelease, {30, 40}, Qt::LeftButton);
        };
        QTest::keyClick(window.windowHandle(), Qt::Key_A);
        QVERIFY(act(window, "brush.add")->isChecked());
        QTest::keyClick(window.windowHandle(), Qt::Key_Escape);
        QVERIFY(!act(window, "brush.add")->isChecked());
        click();
        QVERIFY(spheres.isEmpty());
        window.viewport()->input()->setHover({});
        QTest::keyClick(window.windowHandle(), Qt::Key_A);
        click();
        QCOMPARE(spheres.size(), 1);
        QVERIFY(!act(window, "brush.add")->isChecked());
        click();
        QCOMPARE(spheres.size(), 1);
    }

    void aSteadyHandIsRemembered()
    {
        {
            MainWindow window;
            QVERIFY(!window.brush()->isSteady());
            act(window, "brush.steady")->trigger();
            QVERIFY(window.brush()->isSteady() && child<QCheckBox>(window, "steady")->isChecked());
            child<QSpinBox>(window, "stringLength")->setValue(77);
        }
        MainWindow window;
        QVERIFY(window.brush()->isSteady() && act(window, "brush.steady")->isChecked());
        QCOMPARE(window.brush()->stabilizerLength(), 77.0);
        child<QCheckBox>(window, "steady")->click();
        QVERIFY(!window.brush()->isSteady() && !act(window, "brush.steady")->isChecked());
    }

    void theBarAndTheBrushAreOne()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        auto* box = child<QDoubleSpinBox>(window, "radius.box");
        auto* slider = child<QSlider>(window, "radius.slider");
        QVERIFY(box && slider);
        box->setValue(25);
        QCOMPARE(window.brush()->stroke().radius, 25.0);
        slider->setValue(slider->maximum());
        QCOMPARE(window.brush()->stroke().radius, 50.0);
        QCOMPARE(box->value(), 50.0);
        window.brush()->setValue(Parameter::Radius, 3.14159);
        QCOMPARE(box->value(), 3.14);
        QCOMPARE(window.brush()->stroke().radius, 3.14159); // showing a value does not change it
        child<QDoubleSpinBox>(window, "strength.box")->setValue(0.5);
        QCOMPARE(window.brush()->stroke().strength, 0.5);
    }

    void oneToolIsChosen()
    {
        MainWindow window;
        QVERIFY(act(window, "tool.pull")->isChecked());
        act(window, "tool.smooth")->trigger();
        QCOMPARE(window.brush()->stroke().tool, core::Tool::Smooth);
        QVERIFY(!act(window, "tool.pull")->isChecked());
        window.brush()->setTool(core::Tool::Push);
        QVERIFY(act(window, "tool.push")->isChecked() && !act(window, "tool.smooth")->isChecked());
    }

    void everyToolIsInThePalette_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("isNamed");
        for (const QSize size : {QSize(960, 540), QSize(1280, 720), QSize(1920, 1080)})
            for (const bool isNamed : {false, true})
                QTest::addRow("%d x %d%s", size.width(), size.height(), isNamed ? ", named" : "") << size << isNamed;
    }

    /// Each tool and option is fully visible, and each tool can be chosen by its button.
    void everyToolIsInThePalette()
    {
        QFETCH(const QSize, size);
        QFETCH(const bool, isNamed);
        MainWindow window;
        window.resize(size);
        act(window, "view.toolNames")->setChecked(isNamed);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QTRY_COMPARE(window.size(), size);
        auto* options = child<QToolBar>(window, "toolOptions");
        for (QAction* action : options->actions())
            QTRY_VERIFY2(options->widgetForAction(action)->isVisible(), qPrintable(action->objectName()));
        auto* palette = window.findChild<ui::ToolPalette*>();
        const auto areTools = palette->findChildren<QToolButton*>();
        QCOMPARE(static_cast<std::size_t>(areTools.size()), core::toolNames().size());
        QRegion taken;
        std::size_t tools = 0;
        for (QToolButton* tool : areTools) {
            QTRY_VERIFY2(tool->isVisible() && tool->visibleRegion() == tool->rect(), qPrintable(tool->text()));
            QVERIFY2(!taken.intersects(tool->geometry()), qPrintable(tool->text()));
            taken += tool->geometry();
            tool->click();
            QVERIFY(tool->isChecked());
            QCOMPARE(window.brush()->stroke().tool, static_cast<core::Tool>(tools++));
        }
    }

    /// No dialog is larger than a small screen.
    void dialogsFitASmallScreen()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        const auto open = [&window](const char* id) {
            if (qstrcmp(id, "edit.classroom") == 0) // this action is handled by app, which reads and writes classes
                (new ui::ClassroomDialog(&window, window.commands(), QDir::homePath()))->open();
            else
                act(window, id)->trigger();
        };
        for (const char* id :
             {"edit.preferences", "edit.classroom", "help.keys", "help.about", "model.scale", "model.mirror",
              "model.symmetrize", "model.remesh", "model.flattenBase", "file.exportFor"}) {
            open(id);
            QDialog* dialog = nullptr;
            QTRY_VERIFY((dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())));
            const QSize least = dialog->minimumSizeHint();
            QVERIFY2(
                least.width() <= 940 && least.height() <= 500,
                qPrintable(
                    QStringLiteral("%1: %2 x %3").arg(QLatin1StringView(id)).arg(least.width()).arg(least.height())));
            dialog->reject();
            QTRY_VERIFY(!QApplication::activeModalWidget());
        }
    }

    /// The palette at the pointer contains tools, radius and strength, and closes when a tool is chosen.
    void paletteChoosesATool()
    {
        MainWindow window;
        window.show();
        act(window, "brush.palette")->trigger();
        QPointer<ui::BrushPalette> palette = window.findChild<ui::BrushPalette*>();
        QVERIFY(palette && palette->isVisible());
        auto* slider = palette->findChild<QSlider*>();
        const double radius = window.brush()->value(Parameter::Radius);
        slider->setValue(slider->value() + 5);
        QVERIFY(window.brush()->value(Parameter::Radius) > radius && palette->isVisible());
        for (QToolButton* button : palette->findChildren<QToolButton*>())
            if (button->defaultAction() == act(window, "tool.clay"))
                button->click();
        QCOMPARE(window.brush()->stroke().tool, core::Tool::Clay);
        QTRY_VERIFY(!palette);
    }

    void paletteTakesAPreset()
    {
        MainWindow window;
        window.show();
        act(window, "brush.palette")->trigger();
        QPointer<ui::BrushPalette> palette = window.findChild<ui::BrushPalette*>();
        const auto* presets = palette->findChild<QListView*>(QStringLiteral("brushPalette.presets"));
        const auto preset = [presets](int row) { return presets->model()->index(row, 0); };
        QTRY_VERIFY(presets->model()->rowCount() > 8);
        const auto isDrawn = [&](const QModelIndex& index) {
            const QImage picture = index.data(Qt::DecorationRole).value<QIcon>().pixmap(48).toImage();
            return picture.pixelColor(picture.rect().center()).alpha() > 0;
        };
        QTRY_VERIFY(isDrawn(preset(0)) && isDrawn(preset(1)));
        const core::StrokeSettings before = window.brush()->stroke();
        QTest::mouseClick(presets->viewport(), Qt::LeftButton, {}, presets->visualRect(preset(1)).center());
        QVERIFY(window.brush()->stroke().tool != before.tool || window.brush()->stroke().strength != before.strength ||
                window.brush()->stroke().radius != before.radius);
        QTRY_VERIFY(!palette);
    }

    /// A window state stored by a version with other bars hides none of the present bars.
    void anOlderWindowsStateHidesNoPalette()
    {
        QByteArray state;
        {
            MainWindow older;
            delete child<QToolBar>(older, "toolOptions");
            state = older.saveState(1);
        }
        ui::Settings().set(&ui::Setting::windowState, state);
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(child<QToolBar>(window, "toolOptions")->isVisible());
        QVERIFY(window.findChild<ui::ToolPalette*>()->isVisible());
    }

    void panelsStayOnTheirSide()
    {
        for (const auto side : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea}) {
            {
                MainWindow window;
                act(window, "view.panelsLeft")->setChecked(side == Qt::LeftDockWidgetArea);
                QCOMPARE(window.dockWidgetArea(window.findChild<ui::SideColumn*>()), side);
                window.show();
                window.close();
            }
            const MainWindow later;
            QCOMPARE(later.dockWidgetArea(later.findChild<ui::SideColumn*>()), side);
            QCOMPARE(act(later, "view.panelsLeft")->isChecked(), side == Qt::LeftDockWidgetArea);
        }
    }

    void switchesAndPanelsShowTheBrush()
    {
        MainWindow window;
        const auto& stroke = window.brush()->stroke();
        act(window, "brush.ray")->trigger();
        QCOMPARE(stroke.brush, core::BrushShape::Ray);
        QCOMPARE(child<QComboBox>(window, "reach")->currentIndex(), 1);
        act(window, "topology.uniform")->trigger();
        QCOMPARE(stroke.topology, core::Topology::Uniform);
        QCOMPARE(child<QComboBox>(window, "topology")->currentIndex(), 3);
        act(window, "topology.uniform")->trigger();
        QCOMPARE(stroke.topology, core::Topology::Refine);
        auto* topologies = child<QComboBox>(window, "topology");
        topologies->setCurrentIndex(2);
        Q_EMIT topologies->activated(2);
        QCOMPARE(stroke.topology, core::Topology::Keep);
        act(window, "topology.uniform")->trigger();
        act(window, "topology.uniform")->trigger();
        QCOMPARE(stroke.topology, core::Topology::Keep);
        auto* airbrush = child<QCheckBox>(window, "airbrush");
        QVERIFY(airbrush->isChecked() && airbrush->isEnabled());
        airbrush->click();
        QVERIFY(!window.brush()->tools()->isAirbrush(core::Tool::Pull) &&
                window.brush()->tools()->isAirbrush(core::Tool::Push));
        auto* anchored = child<QCheckBox>(window, "anchored");
        QVERIFY(!anchored->isChecked() && anchored->isEnabled());
        anchored->click();
        QVERIFY(stroke.anchored);
        window.brush()->setTool(core::Tool::Grab);
        QVERIFY(!anchored->isChecked() && !anchored->isEnabled());
        window.brush()->setTool(core::Tool::Pull);
        QVERIFY(anchored->isChecked());
        child<QCheckBox>(window, "fusion")->click();
        QVERIFY(!stroke.fusion && !act(window, "topology.fusion")->isChecked());

        auto* planes = child<QComboBox>(window, "symmetry");
        planes->setCurrentIndex(3);
        Q_EMIT planes->activated(3);
        QCOMPARE(stroke.symmetry, core::Symmetry::Z);
        QVERIFY(act(window, "symmetry.on")->isChecked());
        act(window, "symmetry.on")->trigger();
        QCOMPARE(stroke.symmetry, core::Symmetry::None);
        QCOMPARE(planes->currentIndex(), 0);

        auto* sectors = child<QSpinBox>(window, "radial");
        auto* hint = child<QLabel>(window, "radialHint");
        QVERIFY(sectors->text() == QStringLiteral("Off") && hint->isHidden() &&
                !act(window, "symmetry.radial")->isChecked());
        act(window, "symmetry.radial")->trigger();
        QVERIFY(stroke.radial == 6 && sectors->value() == 6 && !hint->isHidden());
        sectors->setValue(4);
        QVERIFY(stroke.radial == 4 && hint->isHidden());
        act(window, "symmetry.radial")->trigger();
        act(window, "symmetry.radial")->trigger();
        QVERIFY(stroke.radial == 4 && act(window, "symmetry.radial")->isChecked());

        child<QDoubleSpinBox>(window, "detail.box")->setValue(0.5);
        QCOMPARE(stroke.detail, 0.5);
    }

    void theFalloffCurveIsBentByHand()
    {
        MainWindow window;
        auto* curve = child<ui::FalloffCurve>(window, "falloffCurve");
        QVERIFY(curve);
        curve->resize(216, 116); // 200 x 100 pixels inside its margin
        for (const int n : {0, 3, 5, 9, 16}) {
            const double x = 0.5;
            const QPoint at(8 + 100, 108 - static_cast<int>(std::lround(100 * core::falloff(x, n))));
            sendMouse(curve, QEvent::MouseButtonPress, at, Qt::LeftButton);
            QVERIFY(std::abs(core::falloff(x, window.brush()->stroke().falloff) - core::falloff(x, n)) <= 0.01);
        }
        window.brush()->setValue(Parameter::Falloff, 3);
        QTest::keyClick(curve, Qt::Key_Down);
        QCOMPARE(window.brush()->stroke().falloff, 0);
        QTest::keyClick(curve, Qt::Key_Down);
        QCOMPARE(window.brush()->stroke().falloff, 0);
        QTest::keyClick(curve, Qt::Key_Up);
        QTest::keyClick(curve, Qt::Key_Up);
        QCOMPARE(window.brush()->stroke().falloff, 4);
    }

    void thePaintColourHasAPanel()
    {
        MainWindow window;
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        auto* wheel = child<ui::ColorWheel>(window, "colorWheel");
        for (const auto state :
             {ui::SidePanel::State::Open, ui::SidePanel::State::Folded, ui::SidePanel::State::Hidden}) {
            child<ui::SidePanel>(window, "colorPanel")->setState(state);
            act(window, "brush.color")->trigger();
            QTRY_VERIFY(wheel->isVisible() && !wheel->visibleRegion().isEmpty());
            QTRY_VERIFY(wheel->hasFocus());
        }
    }

    void theModelIsFilledWithThePaintColour()
    {
        MainWindow window;
        QSignalSpy asked(&window, &MainWindow::commandRequested);
        window.brush()->set(&core::StrokeSettings::color, core::Rgb{10, 20, 30});
        act(window, "model.fill")->trigger();
        QCOMPARE(asked.count(), 1);
        QCOMPARE(std::get<core::Fill>(asked[0][0].value<core::ModelCommand>()).color, (core::Rgb{10, 20, 30}));
    }

    void theMaskIsChangedFromTheMenu()
    {
        using How = core::MaskOperation::Kind;
        MainWindow window;
        QSignalSpy asked(&window, &MainWindow::commandRequested);
        window.brush()->set(&core::StrokeSettings::color, core::Rgb{10, 20, 30});
        const std::pair<const char*, How> actions[] = {
            {"mask.invert", How::Invert},   {"mask.clear", How::Clear}, {"mask.blur", How::Blur},
            {"mask.sharpen", How::Sharpen}, {"mask.grow", How::Grow},   {"mask.shrink", How::Shrink},
            {"mask.cavity", How::Cavity},   {"mask.color", How::Color}, {"mask.part", How::Part}};
        for (const auto& [id, how] : actions) {
            act(window, id)->trigger();
            const auto change = std::get<core::MaskOperation>(asked.takeLast()[0].value<core::ModelCommand>());
            QCOMPARE(change.how, how);
            QVERIFY(how != How::Color || change.color == (core::Rgb{10, 20, 30}));
        }
        QCOMPARE(act(window, "mask.invert")->shortcut(), QKeySequence(QStringLiteral("Ctrl+I")));
        QCOMPARE(act(window, "mask.clear")->shortcut(), QKeySequence(QStringLiteral("Alt+M")));
    }

    /// Alt+M runs the command, because no menu has this mnemonic.
    void theMaskIsClearedByItsKey()
    {
        MainWindow window;
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QSignalSpy asked(&window, &MainWindow::commandRequested);
        QTest::keyClick(&window, Qt::Key_M, Qt::AltModifier);
        QCOMPARE(asked.count(), 1);
        QCOMPARE(std::get<core::MaskOperation>(asked[0][0].value<core::ModelCommand>()).how,
                 core::MaskOperation::Kind::Clear);
    }

    void aColourIsPickedFromTheModel()
    {
        MainWindow window;
        QAction* pick = act(window, "color.pick");
        const core::SurfaceHit red{core::Vec3::Zero(), core::Vec3::UnitZ(), 1, 0, {250, 10, 20}};
        const auto click = [&](const std::optional<core::SurfaceHit>& hit) {
            sendMouse(window.viewport(), QEvent::MouseButtonPress, {50, 50}, Qt::LeftButton);
            window.viewport()->input()->setHover(hit);
            sendMouse(window.viewport(), QEvent::MouseButtonRelease, {50, 50}, Qt::LeftButton);
        };
        QSignalSpy strokes(window.viewport()->input(), &ui::PointerInput::strokeBegan);
        pick->trigger();
        click(red);
        QCOMPARE(window.brush()->stroke().color, red.color);
        QVERIFY(!pick->isChecked());
        QCOMPARE(strokes.count(), 0);
        click(red);
        QCOMPARE(strokes.count(), 1); // picking ends after one click

        pick->trigger();
        QTest::keyClick(window.viewport(), Qt::Key_Escape);
        QVERIFY(!pick->isChecked());
    }

    /// Folded panels, hidden panels and the column's place are restored at the next start.
    void panelsComeBackAsLeft()
    {
        using State = ui::SidePanel::State;
        {
            MainWindow window;
            window.show();
            child<ui::SidePanel>(window, "topologyPanel")->toggleViewAction()->trigger();
            child<ui::SidePanel>(window, "brushPanel")->setState(State::Folded);
            child<ui::SidePanel>(window, "modelPanel")->setState(State::Open);
            window.addDockWidget(Qt::LeftDockWidgetArea, window.findChild<ui::SideColumn*>());
            window.brush()->setValue(Parameter::Falloff, 7);
            window.close();
        }
        MainWindow window;
        window.show();
        QCOMPARE(child<ui::SidePanel>(window, "topologyPanel")->state(), State::Hidden);
        QCOMPARE(child<ui::SidePanel>(window, "brushPanel")->state(), State::Folded);
        QCOMPARE(child<ui::SidePanel>(window, "modelPanel")->state(), State::Open);
        QCOMPARE(child<ui::SidePanel>(window, "symmetryPanel")->state(), State::Folded);
        QCOMPARE(window.dockWidgetArea(window.findChild<ui::SideColumn*>()), Qt::LeftDockWidgetArea);
        QCOMPARE(window.brush()->stroke().falloff, 7);
    }

    void everyCommandIsFoundByItsWords()
    {
        MainWindow window;
        window.show();
        for (const ui::ActionInfo& row : ui::actionTable()) {
            act(window, "help.keys")->trigger();
            auto* box = child<QDialog>(window, "commandBox");
            QVERIFY(box);
            auto* list = box->findChild<QTreeWidget*>();
            box->findChild<QLineEdit*>()->setText(act(window, row.id)->statusTip());
            QStringList found;
            for (QTreeWidgetItemIterator i(list,
                                           QTreeWidgetItemIterator::NotHidden | QTreeWidgetItemIterator::NoChildren);
                 *i; ++i)
                found << (*i)->text(0);
            QVERIFY2(found.contains(ui::Actions::plain(act(window, row.id)->text())), row.id);
            box->close();
            QCoreApplication::sendPostedEvents(box, QEvent::DeferredDelete);
        }
    }

    void aCommandIsDoneFromTheBox()
    {
        MainWindow window;
        window.show();
        act(window, "help.keys")->trigger();
        auto* box = child<QDialog>(window, "commandBox");
        auto* words = box->findChild<QLineEdit*>();
        QTest::keyClicks(words, QStringLiteral("undone step")); // matches Redo, which is disabled
        QTest::keyClick(words, Qt::Key_Return);
        QVERIFY(box->isVisible());
        words->clear();
        QTest::keyClicks(words, QStringLiteral("RELAX smooths"));
        QTest::keyClick(words, Qt::Key_Return);
        QVERIFY(!box->isVisible());
        QCOMPARE(window.brush()->stroke().tool, core::Tool::Smooth);
    }

    /// A command named exactly as typed ("pull") is selected before earlier commands that contain it ("Undo Pull").
    void whatIsCalledSoComesFirst()
    {
        MainWindow window;
        window.show();
        act(window, "tool.smooth")->trigger();
        QAction* undo = act(window, "edit.undo");
        undo->setText(QStringLiteral("Undo Pull"));
        undo->setEnabled(true);
        QSignalSpy undone(undo, &QAction::triggered);
        act(window, "help.keys")->trigger();
        auto* words = child<QDialog>(window, "commandBox")->findChild<QLineEdit*>();
        QTest::keyClicks(words, QStringLiteral("pull"));
        QTest::keyClick(words, Qt::Key_Return);
        QCOMPARE(window.brush()->stroke().tool, core::Tool::Pull);
        QVERIFY(undone.isEmpty());
    }

    /// Words that are not part of a command's name find it as synonyms.
    void commandsAreFoundByOtherWords()
    {
        constexpr std::pair<const char*, const char*> wishes[] = {
            {"size", "model.scale"},          {"bigger", "brush.radius"},     {"eraser", "mask.clear"},
            {"mirror", "symmetry.on"},        {"hollow", "model.printCheck"}, {"carve", "tool.push"},
            {"settings", "edit.preferences"}, {"headset", "vr.enter"},        {"manual", "help.guide"}};
        MainWindow window;
        window.show();
        act(window, "help.keys")->trigger();
        auto* box = child<QDialog>(window, "commandBox");
        const auto* list = box->findChild<ui::CommandList*>();
        for (const auto& [word, id] : wishes) {
            box->findChild<QLineEdit*>()->setText(QLatin1StringView(word));
            QVERIFY2(!list->itemOf(QLatin1StringView(id))->isHidden(), word);
            QVERIFY2(list->currentItem(), word);
        }
    }

    void arrowsMoveThroughTheCommands()
    {
        MainWindow window;
        window.show();
        act(window, "help.keys")->trigger();
        auto* box = child<QDialog>(window, "commandBox");
        auto* words = box->findChild<QLineEdit*>();
        const auto current = [&] {
            const QTreeWidgetItem* item = box->findChild<QTreeWidget*>()->currentItem();
            return item ? item->text(0) : QString();
        };
        words->setText(QStringLiteral("brush"));
        const QString first = current();
        QTest::keyClick(words, Qt::Key_Down);
        QVERIFY(!current().isEmpty() && current() != first);
        QTest::keyClick(words, Qt::Key_Up);
        QCOMPARE(current(), first);
        for (int i = 0; i < 50; ++i)
            QTest::keyClick(words, Qt::Key_Up);
        const QString top = current(); // the first command
        QVERIFY(!top.isEmpty());
        QTest::keyClick(words, Qt::Key_Up);
        QCOMPARE(current(), top);
    }

    /// Keys work by their position if they type no Latin letter (Russian, Greek) or no digit without Shift (French).
    void keysGoByTheirPlaceWhereTheirLetterSaysNothing()
    {
        MainWindow window;
        window.show();
        const auto press = [&](int key, quint32 scanCode, const QString& text, Qt::KeyboardModifiers held = {}) {
            for (const QEvent::Type type : {QEvent::ShortcutOverride, QEvent::KeyPress}) {
                QKeyEvent event(type, key, held, scanCode, 0, 0, text);
                QCoreApplication::sendEvent(&window, &event);
            }
        };
        const auto tool = [&] { return window.brush()->stroke().tool; };
        press(Qt::Key_Egrave, 16, QStringLiteral("è"));
        QCOMPARE(tool(), core::Tool::Clay); // the key at the position of 7
        press(Qt::Key_QuoteDbl, 12, QStringLiteral("\""));
        QCOMPARE(tool(), core::Tool::Flatten); // the key at the position of 3
        press(0x041b, 45, QStringLiteral("л"));
        QCOMPARE(tool(), core::Tool::SnakeHook); // the key at the position of K
        press(0x03a0, 33, QStringLiteral("π"));
        QCOMPARE(tool(), core::Tool::Pinch);                // the key at the position of P
        press(Qt::Key_Adiaeresis, 45, QStringLiteral("ä")); // a Latin letter is used as it is
        press(0x041b, 45, QStringLiteral("л"), Qt::ControlModifier);
        QCOMPARE(tool(), core::Tool::Pinch);
        press(0x0426, 25, QStringLiteral("Ц"), Qt::ShiftModifier);
        QVERIFY(act(window, "view.flat")->isChecked()); // the key at the position of W, with Shift
    }

    /// Digits of the number pad show sides; the digits above the letters choose tools.
    void theNumberPadTurnsTheView()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        act(window, "tool.smooth")->trigger();
        const auto looksAlong = [&](Qt::Key key, Qt::KeyboardModifiers keys, const core::Vec3& direction) {
            QTest::keyClick(&window, key, keys | Qt::KeypadModifier);
            return (window.viewport()->camera().viewDirection() - direction).norm() < 1e-9;
        };
        QVERIFY(looksAlong(Qt::Key_1, {}, {0, 0, -1}) && looksAlong(Qt::Key_1, Qt::ControlModifier, {0, 0, 1}));
        QVERIFY(looksAlong(Qt::Key_3, {}, {-1, 0, 0}) && looksAlong(Qt::Key_3, Qt::ControlModifier, {1, 0, 0}));
        QVERIFY(looksAlong(Qt::Key_7, {}, {0, -1, 0}) && looksAlong(Qt::Key_7, Qt::ControlModifier, {0, 1, 0}));
        QCOMPARE(window.brush()->stroke().tool, core::Tool::Smooth);
        QTest::keyClick(&window, Qt::Key_1);
        QCOMPARE(window.brush()->stroke().tool, core::Tool::Pull);
        QVERIFY(looksAlong(Qt::Key_7, Qt::ControlModifier, {0, 1, 0})); // the tool's key did not turn the view

        // The window accepts the pad's keys before Qt looks for shortcuts: on X11 Qt would find the shortcuts of the
        // digits above the letters.
        QKeyEvent ofPad(QEvent::ShortcutOverride, Qt::Key_1, Qt::KeypadModifier);
        ofPad.ignore();
        QCoreApplication::sendEvent(&window, &ofPad);
        QVERIFY(ofPad.isAccepted());
        QKeyEvent elsewhere(QEvent::ShortcutOverride, Qt::Key_1, Qt::NoModifier);
        elsewhere.ignore();
        QCoreApplication::sendEvent(&window, &elsewhere);
        QVERIFY(!elsewhere.isAccepted());
    }

    void theNumberPadTypesNumbers()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const core::Vec3 direction = window.viewport()->camera().viewDirection();
        auto* box = child<QDoubleSpinBox>(window, "radius.box");
        box->setFocus();
        box->selectAll();
        QTest::keyClick(box, Qt::Key_1, Qt::KeypadModifier);
        QTest::keyClick(box, Qt::Key_7, Qt::KeypadModifier);
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(window.brush()->stroke().radius, 17.0);
        QCOMPARE(window.viewport()->camera().viewDirection(), direction);
    }

    void theMenuTurnsTheView()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        const ui::OrbitCamera& camera = window.viewport()->camera();
        QList<core::Vec3> seen;
        for (const char* id : {"view.front", "view.back", "view.right", "view.left", "view.top", "view.bottom"}) {
            act(window, id)->trigger();
            for (const core::Vec3& direction : seen)
                QVERIFY2((camera.viewDirection() - direction).norm() > 1, id);
            seen << camera.viewDirection();
        }
        act(window, "view.orthographic")->trigger();
        QCOMPARE(camera.projection(), ui::OrbitCamera::Projection::Orthographic);
        QVERIFY(act(window, "view.orthographic")->isChecked());
        act(window, "view.orthographic")->trigger();
        QCOMPARE(camera.projection(), ui::OrbitCamera::Projection::Perspective);
    }

    /// The appearance is changed by key and menu, and restored at the next start.
    void theAppearanceIsChosenAndRemembered()
    {
        ui::ViewAppearance appearance;
        {
            MainWindow window;
            window.show();
            window.activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(&window));
            appearance = window.viewport()->appearance();
            QCOMPARE(appearance, ui::ViewAppearance());
            QTest::keyClick(&window, Qt::Key_W);
            QTest::keyClick(&window, Qt::Key_G);
            appearance.wireframe = true;
            appearance.ground = false;
            QCOMPARE(window.viewport()->appearance(), appearance);
            for (const auto& row : ui::materials) {
                appearance.material = row.value;
                window.action(QStringLiteral("material.") + QLatin1StringView(row.key))->trigger();
                QCOMPARE(window.viewport()->appearance(), appearance);
            }
            appearance.background = ui::Background::Sky;
            window.action(QStringLiteral("background.sky"))->trigger();
            QCOMPARE(window.viewport()->appearance(), appearance);
        }
        const MainWindow again;
        QCOMPARE(again.viewport()->appearance(), appearance);
        QVERIFY(again.action(QStringLiteral("material.paint"))->isChecked());
        QVERIFY(!again.action(QStringLiteral("material.clay"))->isChecked());
        QVERIFY(again.action(QStringLiteral("view.wireframe"))->isChecked());
    }

    void preferencesHoldAtOnceAndAtTheNextStart()
    {
        const auto isDark = [] { return QApplication::palette().window().color().lightness() < 128; };
        {
            MainWindow window;
            window.show();
            QVERIFY(QTest::qWaitForWindowActive(&window));
            QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
            auto* dialog = child<QDialog>(window, "preferences");
            QVERIFY(dialog->isVisible());
            QTest::keyClick(dialog->findChild<QComboBox*>(QStringLiteral("theme")), Qt::Key_End);
            QVERIFY(isDark());
            QTest::keyClick(dialog, Qt::Key_Escape);
            QTRY_VERIFY(!window.findChild<QDialog*>(QStringLiteral("preferences")));
        }
        ui::Settings().set(ui::Preferences{.theme = ui::ThemeChoice::Light, .input = {}});
        {
            const MainWindow light;
            QVERIFY(!isDark());
        }
        ui::Settings().set(ui::Preferences{.theme = ui::ThemeChoice::Dark, .input = {}});
        const MainWindow dark;
        QVERIFY(isDark());
    }

    /// Shortcuts changed in the dialog work, are shown everywhere, and are restored at the next start.
    void keysAreChosenAndRemembered()
    {
        {
            MainWindow window;
            window.show();
            window.activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(&window));
            QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
            auto* dialog = child<QDialog>(window, "preferences");
            QTest::keyClick(dialog->findChild<QComboBox*>(QStringLiteral("keyPreset")), Qt::Key_End);
            auto* list = dialog->findChild<ui::CommandList*>(QStringLiteral("keyList"));
            list->setCurrentItem(list->itemOf(QStringLiteral("view.ground")));
            QTest::keyClick(dialog->findChild<QWidget*>(QStringLiteral("key1")), Qt::Key_9, Qt::KeypadModifier);
            QTest::keyClick(dialog, Qt::Key_Escape);
            QTRY_VERIFY(!window.findChild<QDialog*>(QStringLiteral("preferences")));
        }
        MainWindow window;
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QVERIFY(act(window, "tool.pull")->toolTip().contains(QStringLiteral("Alt")));
        QVERIFY(act(window, "view.wireframe")->toolTip().contains(QStringLiteral("Shift+F")));
        QTest::keyClick(&window, Qt::Key_F, Qt::ShiftModifier);
        QVERIFY(act(window, "view.wireframe")->isChecked());
        QTest::keyClick(&window, Qt::Key_W);
        QVERIFY(act(window, "view.wireframe")->isChecked()); // no longer its key
        QTest::keyClick(&window, Qt::Key_G);
        QVERIFY(act(window, "view.ground")->isChecked());
        QTest::keyClick(&window, Qt::Key_9, Qt::KeypadModifier);
        QVERIFY(!act(window, "view.ground")->isChecked());
        QTest::keyClick(&window, Qt::Key_F1);
        const auto* sheet = child<QDialog>(window, "commandBox")->findChild<ui::CommandList*>();
        QCOMPARE(sheet->itemOf(QStringLiteral("brush.radius"))->text(ui::CommandList::Key), QStringLiteral("S"));
    }

    /// A reset undoes every change the user can make, and the next start has the defaults too.
    void resetBringsEverythingBack()
    {
        const auto isAsAtFirst = [](const MainWindow& window) {
            const auto* brushPanel = child<ui::SidePanel>(window, "brushPanel");
            return window.viewport()->appearance() == ui::ViewAppearance() &&
                   window.brush()->value(Parameter::Strength) == 1 && window.brush()->value(Parameter::Radius) == 10 &&
                   !window.brush()->isSteady() && brushPanel->state() == ui::SidePanel::State::Open &&
                   act(window, "view.wireframe")->shortcut() == QKeySequence(Qt::Key_W) &&
                   !act(window, "view.wireframe")->isChecked() && act(window, "material.clay")->isChecked() &&
                   child<QSpinBox>(window, "historyCap")->value() == ui::defaultHistoryMegabytes &&
                   child<QComboBox>(window, "preview.style")->currentIndex() == 0 &&
                   child<QDoubleSpinBox>(window, "turnSpeed")->value() == ui::defaultTurn;
        };
        {
            MainWindow window;
            window.setModel(modelInfo(QStringLiteral("a"), 100));
            window.show();
            QVERIFY(isAsAtFirst(window));
            act(window, "material.wax")->trigger();
            act(window, "view.wireframe")->trigger();
            act(window, "brush.steady")->trigger();
            window.brush()->setValue(Parameter::Strength, 3);
            window.brush()->setValue(Parameter::Radius, 33);
            child<ui::SidePanel>(window, "brushPanel")->setState(ui::SidePanel::State::Hidden);
            child<QSpinBox>(window, "historyCap")->setValue(100);
            child<QComboBox>(window, "preview.style")->setCurrentIndex(1);
            child<QDoubleSpinBox>(window, "turnSpeed")->setValue(77);
            act(window, "edit.preferences")->trigger();
            auto* dialog = child<QDialog>(window, "preferences");
            QTest::keyClick(dialog->findChild<QComboBox*>(QStringLiteral("keyPreset")), Qt::Key_End);
            QVERIFY(!isAsAtFirst(window));
            dialog->findChild<QPushButton*>(QStringLiteral("reset"))->click();
            auto* question = dialog->findChild<QMessageBox*>();
            for (QAbstractButton* button : question->buttons())
                if (question->buttonRole(button) == QMessageBox::AcceptRole)
                    button->click();
            QVERIFY(isAsAtFirst(window));
            QCOMPARE(dialog->findChild<QComboBox*>(QStringLiteral("keyPreset"))->currentIndex(), 0);
            dialog->reject();
            window.close();
        }
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        QVERIFY(isAsAtFirst(window));
    }

    void noSettingsFileStopsTheProgram_data()
    {
        QTest::addColumn<QByteArray>("content");
        QByteArray noise;
        for (int i = 0; i < 20000; ++i)
            noise += static_cast<char>((i * 7919 + i / 256 * 31) % 256);
        QTest::newRow("noise") << noise;
        QTest::newRow("not ini") << QByteArray("<?xml version=\"1.0\"?><settings/>");
        QTest::newRow("cut off") << QByteArray("[window]\nstate=@ByteArray(\\0\\0\\0\\xff\\0\\0");
        QTest::newRow("zeros") << QByteArray(4096, '\0');
        QTest::newRow("older") << QByteArray(
            "[brush]\nradius=12\nshape=round\n[keys]\nundo=Ctrl+Z\n[window]\nsize=@Size(640 480)\n");
        QByteArray wrong;
        for (const char* value : {"@Size(1 2)", "@Invalid()", "@Variant(\\0\\0\\0\\x7f\\0\\0\\0\\xfgarbage)",
                                  "@ByteArray(\\xff\\xff\\xff\\xff)", "a, b, c", "-1e999", ""}) {
            wrong.clear();
            for (const char* group : {"window", "history", "files", "hand", "drawing", "turntable", "brush",
                                      "preferences", "view", "color", "keys"}) {
                wrong += QByteArray("[") + group + "]\n";
                for (const char* key :
                     {"geometry",  "state",   "megabytes",  "recent",   "lastFolder",     "steady",       "string",
                      "sides",     "shaded",  "dimensions", "speed",    "clockwise",      "radiusShare",  "strength",
                      "falloff",   "spacing", "theme",      "language", "altMovesView",   "material",     "background",
                      "wireframe", "ground",  "swatches",   "preset",   "own\\tool.pull", "own\\no.such", "own"})
                    wrong += QByteArray(key) + "=" + value + "\n";
            }
            QTest::newRow(qPrintable(QStringLiteral("every value is %1").arg(QLatin1StringView(value)))) << wrong;
        }
    }

    void noSettingsFileStopsTheProgram()
    {
        QFETCH(QByteArray, content);
        QFile file(QSettings().fileName());
        QVERIFY(QDir().mkpath(QFileInfo(file).path()) && file.open(QIODevice::WriteOnly) &&
                file.write(content) == content.size());
        file.close();
        {
            MainWindow window;
            window.setModel(modelInfo(QStringLiteral("a"), 100));
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            QVERIFY(window.screen()->geometry().intersects(window.geometry()) && window.width() >= 200);
            QVERIFY(window.brush()->stroke().radius > 0 && window.brush()->stroke().strength >= 0);
            QSet<QKeySequence> keys;
            for (const ui::ActionInfo& row : ui::actionTable())
                for (const QKeySequence& key : act(window, row.id)->shortcuts()) {
                    QVERIFY2(!keys.contains(key), row.id);
                    keys << key;
                }
            act(window, "edit.preferences")->trigger();
            window.close();
        }
        MainWindow again;
        QCOMPARE(act(again, "edit.undo")->shortcut(), QKeySequence(QStringLiteral("Ctrl+Z")));
    }

    void theScaleBarIsShownAndHidden()
    {
        const MainWindow window;
        auto* bar = window.viewport()->findChild<QWidget*>(QStringLiteral("scaleBar"));
        QVERIFY(bar && !bar->isHidden());
        window.action(QStringLiteral("view.scaleBar"))->trigger();
        QVERIFY(bar->isHidden());
    }

    void undoIsWordedFromOutside()
    {
        MainWindow window;
        QVERIFY(!act(window, "edit.undo")->isEnabled() && !act(window, "edit.redo")->isEnabled());
        window.setUndoText(QStringLiteral("Pull"));
        QVERIFY(act(window, "edit.undo")->text().contains(QStringLiteral("Pull")));
        window.setUndoText({});
        QVERIFY(!act(window, "edit.undo")->text().contains(QStringLiteral("Pull")));
    }

    void filesAreOpenedByDrop()
    {
        MainWindow window;
        QSignalSpy opened(window.files(), &ui::ModelFiles::openRequested);
        QVERIFY(drop(window, {QUrl::fromLocalFile(QStringLiteral("/tmp/a model.stl"))}));
        QTRY_COMPARE(opened.count(), 1);
        QCOMPARE(opened[0][0].toString(), QStringLiteral("/tmp/a model.stl"));
        QVERIFY(!drop(window, {QUrl(QStringLiteral("https://example.org/a.stl"))}));
        QVERIFY(!drop(window, {}));
        window.progress()->begin(QStringLiteral("Opening"));
        // Allowed while a file is being opened
        QVERIFY(drop(window, {QUrl::fromLocalFile(QStringLiteral("/tmp/b.stl"))}));
        QTRY_COMPARE(opened.count(), 2);
    }

    void filesAreOpenedByDialog()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("cup.stl")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        MainWindow window;
        window.show();
        QSignalSpy opened(window.files(), &ui::ModelFiles::openRequested);
        act(window, "file.open")->trigger();
        auto* dialog = child<QFileDialog>(window, "openDialog");
        QVERIFY(dialog);
        dialog->setDirectory(folder.path());
        child<QLineEdit>(window, "fileNameEdit")->setText(QStringLiteral("cup.stl"));
        dialog->QDialog::accept();
        Q_EMIT dialog->fileSelected(file.fileName());
        QCOMPARE(opened.count(), 1);
        QCOMPARE(opened[0][0].toString(), file.fileName());
    }

    void insertingHasATitleOfItsOwn()
    {
        MainWindow window;
        window.show();
        QStringList titles;
        for (const char* id : {"file.open", "model.insert"}) {
            act(window, id)->trigger();
            auto* dialog = window.findChild<QFileDialog*>();
            QVERIFY(dialog);
            titles << dialog->windowTitle();
            dialog->reject();
            QTRY_VERIFY(!window.findChild<QFileDialog*>());
        }
        QCOMPARE(titles, QStringList({QStringLiteral("Open a Model"), QStringLiteral("Insert a Model")}));
    }

    void theExportsEndingFollowsTheFilter()
    {
        QTemporaryDir folder;
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("cup.obj"), 10));
        window.show();
        act(window, "file.exportAs")->trigger();
        auto* dialog = child<QFileDialog>(window, "exportDialog");
        QVERIFY(dialog);
        const QStringList endings = ui::writtenEndings();
        QCOMPARE(dialog->nameFilters().size(), endings.size());
        QCOMPARE(dialog->defaultSuffix(), endings.constFirst());
        Q_EMIT dialog->filterSelected(dialog->nameFilters().constLast());
        QCOMPARE(dialog->defaultSuffix(), endings.constLast());
        dialog->setDirectory(folder.path());
        QVERIFY(dialog->selectedFiles().constFirst().endsWith(QStringLiteral("cup.") + endings.constLast()));
        dialog->reject();
    }

    void problemsDoNotStackUp()
    {
        MainWindow window;
        window.show();
        window.showProblem(QStringLiteral("One."));
        window.showProblem(QStringLiteral("Two."));
        const auto boxes = window.findChildren<QMessageBox*>();
        QCOMPARE(boxes.size(), 1);
        QCOMPARE(boxes[0]->text(), QStringLiteral("Two."));
        boxes[0]->button(QMessageBox::Ok)->click();
        QTRY_VERIFY(window.findChildren<QMessageBox*>().isEmpty());
        window.showProblem(QStringLiteral("Three."));
        QCOMPARE(window.findChildren<QMessageBox*>().size(), 1);
    }

    void noticesGoByThemselves()
    {
        MainWindow window;
        window.show();
        window.showNotice(QStringLiteral("Done."));
        auto* banner = child<QLabel>(window, "banner");
        QVERIFY(banner->isVisible());
        QCOMPARE(banner->text(), QStringLiteral("Done."));
        QTRY_VERIFY(!banner->isVisible());
    }

    /// A notice does not overlap the scale bar, whatever their widths and whichever is shown first.
    void aNoticeLeavesTheScaleBarAlone()
    {
        SKIP_WITHOUT_GRAPHICS();
        MainWindow window;
        window.resize(1000, 700);
        window.show();
        const auto* bar = window.viewport()->findChild<QWidget*>(QStringLiteral("scaleBar"));
        const auto* banner = child<QLabel>(window, "banner");
        int moved = 0;
        for (int words = 1; words < 200; words *= 2) {
            window.showNotice(QStringLiteral("The stroke ended early. ").repeated(words));
            for (const int width : {700, 1000, 1500}) {
                window.resize(width, 700);
                QTRY_COMPARE(window.width(), width);
                QVERIFY(bar->isVisible() && banner->isVisible() && !banner->geometry().intersects(bar->geometry()));
                moved += banner->geometry().bottom() < bar->y() ? 1 : 0;
            }
        }
        QVERIFY(moved > 0 && moved < 24);
        const QRect above = banner->geometry();
        window.action(QStringLiteral("view.scaleBar"))->trigger();
        QVERIFY(banner->geometry().bottom() > above.bottom());
        window.action(QStringLiteral("view.scaleBar"))->trigger();
        QCOMPARE(banner->geometry(), above);
    }

    void busyIsSaid()
    {
        MainWindow window;
        window.show();
        window.progress()->begin(QStringLiteral("Opening lion.stl"));
        QVERIFY(child<QLabel>(window, "busyText")->isVisible());
        QVERIFY(!act(window, "file.save")->isEnabled() && !act(window, "model.recentre")->isEnabled());
        QVERIFY(act(window, "file.open")->isEnabled() && act(window, "new.cube")->isEnabled());
        window.progress()->end();
        QVERIFY(!child<QLabel>(window, "busyText")->isVisible());
        QVERIFY(act(window, "file.save")->isEnabled() && act(window, "model.recentre")->isEnabled());
    }

    void aLongTipEndsBeforeWhatIsGoingOn()
    {
        MainWindow window;
        window.show();
        window.progress()->begin(QStringLiteral("Opening lion.stl"));
        QStatusBar* bar = window.statusBar();
        const auto* what = child<QLabel>(window, "busyText");
        const int end = what->mapTo(bar, QPoint()).x();
        const auto picture = [bar, end](const QString& tip) {
            bar->showMessage(tip);
            return std::pair(bar->grab({0, 0, end - 12, bar->height()}).toImage(),
                             bar->grab({end - 12, 0, 12, bar->height()}).toImage());
        };
        const auto [none, gap] = picture({});
        const auto [tip, gapBesideTip] = picture(QString(500, u'M'));
        QVERIFY(tip != none);
        QCOMPARE(gapBesideTip, gap);
    }

    void whatIsGoingOnStaysStoppableUnderAnotherName()
    {
        MainWindow window;
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QSignalSpy stopped(window.action(QStringLiteral("edit.stop")), &QAction::triggered);
        window.progress()->begin(QStringLiteral("Opening lion.stl"));
        QVERIFY(!act(window, "edit.stop")->isEnabled());
        window.progress()->setStoppable(true);
        window.progress()->setProgress(0.25);
        window.progress()->begin(QStringLiteral("Checking lion.stl"));
        QCOMPARE(child<QLabel>(window, "busyText")->text(), QStringLiteral("Checking lion.stl"));
        QCOMPARE(window.statusBar()->findChild<QProgressBar*>()->value(), 25);
        QVERIFY(act(window, "edit.stop")->isEnabled());
        QTest::keyClick(&window, Qt::Key_Escape);
        QCOMPARE(stopped.count(), 1);
        window.progress()->end();
        QVERIFY(!act(window, "edit.stop")->isEnabled());
        window.progress()->begin(QStringLiteral("Opening cup.stl"));
        QVERIFY(!act(window, "edit.stop")->isEnabled());
        QCOMPARE(window.statusBar()->findChild<QProgressBar*>()->maximum(), 0);
    }

    void vrIsEnteredAndLeft()
    {
        MainWindow window;
        QSignalSpy entering(window.headset(), &ui::HeadsetActions::enterRequested),
            leaving(window.headset(), &ui::HeadsetActions::leaveRequested);
        QAction *enter = act(window, "vr.enter"), *follow = act(window, "vr.follow"), *find = act(window, "vr.status");
        const auto* said = child<QLabel>(window, "headsetText");
        QVERIFY(enter->isEnabled() && !follow->isEnabled() && find->isEnabled() && said->isHidden());
        QCOMPARE(enter->iconText(), QStringLiteral("Enter VR"));
        enter->trigger();
        QVERIFY(entering.size() == 1 && leaving.isEmpty());

        window.setHeadset(ui::HeadsetState::Changing, QStringLiteral("It starts."));
        QVERIFY(!enter->isEnabled() && !follow->isEnabled() && !find->isEnabled() && !said->isHidden());
        QCOMPARE(enter->iconText(), QStringLiteral("Enter VR"));
        window.setHeadset(ui::HeadsetState::In, QStringLiteral("In VR."));
        QVERIFY(enter->isEnabled() && follow->isEnabled() && !find->isEnabled());
        QCOMPARE(said->text(), QStringLiteral("In VR."));
        QCOMPARE(enter->iconText(), QStringLiteral("Leave VR"));
        enter->trigger();
        QVERIFY(entering.size() == 1 && leaving.size() == 1);

        window.setHeadset(ui::HeadsetState::Out, {});
        QVERIFY(enter->isEnabled() && !follow->isEnabled() && said->isHidden());
        QCOMPARE(enter->iconText(), QStringLiteral("Enter VR"));
    }

    /// The action's check mark shows whether the view follows the head, however following began or ended.
    void theHeadIsFollowed()
    {
        MainWindow window;
        window.setHeadset(ui::HeadsetState::In, QStringLiteral("In VR."));
        QAction* follow = act(window, "vr.follow");
        follow->trigger();
        QVERIFY(!follow->isChecked()); // nobody is in VR yet
        ui::HeadsetAvatar avatar;
        avatar.head = Eigen::Isometry3d::Identity();
        window.viewport()->showAvatar(avatar);
        follow->trigger();
        QVERIFY(follow->isChecked() && window.viewport()->navigation()->isFollowing());
        act(window, "view.frame")->trigger();
        QVERIFY(!follow->isChecked());
        follow->trigger();
        window.setHeadset(ui::HeadsetState::Out, {});
        QVERIFY(!follow->isChecked() && !window.viewport()->navigation()->isFollowing());
    }

    void closingAsks()
    {
        MainWindow window;
        window.show();
        bool may = false;
        window.setCanClose([&may] { return may; });
        QVERIFY(!window.close());
        QVERIFY(window.isVisible());
        may = true;
        QVERIFY(window.close());
    }

    void closingWaitsUntilAllIsSettled()
    {
        MainWindow window;
        window.show();
        bool settled = false;
        int asked = 0;
        window.setIsSettled([&settled] { return settled; });
        window.setCanClose([&asked] { return ++asked > 1; });
        QVERIFY(!window.close());
        window.continueClosing();
        QCOMPARE(asked, 0);
        settled = true;
        window.continueClosing();
        QCOMPARE(asked, 1);
        window.continueClosing(); // the user has chosen to stay
        QVERIFY(window.isVisible());
        QCOMPARE(asked, 1);
    }

    void returnGivesTheKeysBack()
    {
        SKIP_WITHOUT_GRAPHICS();
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        auto* box = child<QDoubleSpinBox>(window, "radius.box");
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QLocale().toString(25));
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(window.brush()->stroke().radius, 25.0);
        QVERIFY(window.viewport()->hasFocus());
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Tab);
        QVERIFY(!box->hasFocus() && !window.viewport()->hasFocus());
    }

    void whatIsTypedBeyondIsClampedWithAWord_data()
    {
        QTest::addColumn<QString>("box");
        QTest::addColumn<double>("typed");
        QTest::addColumn<double>("becomes");
        QTest::newRow("larger than the model") << "radius.box" << 999.0 << 50.0;
        QTest::newRow("zero") << "radius.box" << 0.0 << 0.5;
        QTest::newRow("below the finest detail") << "radius.box" << 0.001 << 0.5;
        QTest::newRow("too strong") << "strength.box" << 77.0 << 10.0;
        QTest::newRow("can be") << "radius.box" << 12.0 << 12.0;
        QTest::newRow("can be, with more digits than are shown") << "radius.box" << 12.3456 << 12.3456;
    }

    void whatIsTypedBeyondIsClampedWithAWord()
    {
        QFETCH(QString, box);
        QFETCH(double, typed);
        QFETCH(double, becomes);
        MainWindow window;
        ui::ModelInfo model = modelInfo(QStringLiteral("a"), 100);
        model.minDetail = core::edgeBounds(0.5, 1).detail;
        window.setModel(model);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        auto* field = window.findChild<QDoubleSpinBox*>(box);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QLocale().toString(typed, 'g', 8));
        QTest::keyClick(field, Qt::Key_Return);
        const Parameter parameter = box.startsWith(QStringLiteral("radius")) ? Parameter::Radius : Parameter::Strength;
        QCOMPARE(window.brush()->value(parameter), becomes);
        QCOMPARE(field->value(), QLocale().toDouble(QString::number(becomes, 'f', field->decimals())));
        const auto* banner = child<QLabel>(window, "banner");
        QCOMPARE(banner->isVisible(), typed != becomes);
        if (typed != becomes)
            QVERIFY2(banner->text().contains(QLocale().toString(becomes)), qPrintable(banner->text()));
    }

    void whatIsNoNumberCannotBeTyped()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        auto* box = child<QDoubleSpinBox>(window, "radius.box");
        for (const char* text : {"nan", "inf", "1e400", "x"}) {
            box->selectAll();
            QTest::keyClicks(box, QLatin1StringView(text));
            QTest::keyClick(box, Qt::Key_Return);
            QVERIFY(window.brush()->stroke().radius >= 1e-6 && window.brush()->stroke().radius <= 50);
        }
    }

    void bracketsSayWhereTheyEnd()
    {
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("a"), 100));
        window.show();
        const auto* banner = child<QLabel>(window, "banner");
        for (int i = 0; i < 15; ++i)
            act(window, "brush.larger")->trigger();
        QVERIFY(window.brush()->stroke().radius < 50 && !banner->isVisible());
        act(window, "brush.larger")->trigger();
        QCOMPARE(window.brush()->stroke().radius, 50.0);
        QVERIFY(banner->isVisible());
    }

    void itFitsTheScreen()
    {
        MainWindow big;
        big.resize(big.screen()->availableSize() * 2);
        big.close(); // stores its size
        MainWindow window;
        const QSize available = window.screen()->availableSize();
        QVERIFY(window.width() <= available.width() && window.height() <= available.height());
    }

    void theBrushIsRemembered()
    {
        {
            MainWindow window;
            window.setModel(modelInfo(QStringLiteral("a"), 100));
            window.brush()->setValue(Parameter::Radius, 20);
            window.brush()->setValue(Parameter::Strength, 0.75);
            window.close();
        }
        MainWindow window;
        window.setModel(modelInfo(QStringLiteral("b"), 50));
        QCOMPARE(window.brush()->stroke().radius, 10.0);
        QCOMPARE(window.brush()->stroke().strength, 0.75);
    }

    void aBrokenSettingsFileDoesNoHarm()
    {
        QSettings().setValue(QStringLiteral("window/geometry"), QByteArray("rubbish"));
        QSettings().setValue(QStringLiteral("window/state"), QByteArray("rubbish"));
        MainWindow window;
        window.show();
        QVERIFY(window.width() >= 400 && window.height() >= 300);
    }

    void nothingIsClippedInASmallWindow()
    {
        MainWindow window;
        window.resize(1280, 720);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        for (const char* name : {"radius.box", "radius.slider", "strength.box", "strength.slider"}) {
            const auto* widget = child<QWidget>(window, name);
            QVERIFY2(widget->isVisible() && widget->width() >= widget->minimumSizeHint().width(), name);
        }
    }
};

FETTLE_TEST(TestMainWindow, ui::TestApplication)
#include "tst_main_window.moc"
