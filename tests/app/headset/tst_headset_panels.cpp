// Tests each item of the headset's panels: a controller presses it, and the document and the window must show the
// effect.
#include "tests/app/headset/headset_visit.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

#include "app/headset/headset_files.h"
#include "core/analysis/mesh_check.h"
#include "ui/brush/color_panel.h"
#include "vr/sculpt/brush_state.h"

#include <numbers>

using namespace app;
using core::Vec3;
using vr::PanelCommand;
using vr::PanelKind;
using vr::PanelSlider;
using vr::Side;

namespace
{
constexpr int longPress = HeadsetHand::longPress;

/// Returns the left controller's tool panel. Positions of its items depend only on these switches.
vr::ToolPanel tools()
{
    vr::ToolPanel panel;
    panel.canUndo = panel.canRedo = true;
    return panel;
}

/// A visit as Alone, with the tool panel open and painted, held beside the model.
struct AtTools : Alone
{
    explicit AtTools(const vr::HeadsetSettings& settings = {}, const QSize& pixels = HeadsetHand::few)
        : Alone(settings, pixels)
    {
        const Side support = settings.wands.sculpting == Side::Right ? Side::Left : Side::Right;
        hand.put(support, {support == Side::Left ? -0.35 : 0.35, 1.25, -0.3});
        hand.press(support, "menu");
        for (const core::Tool tool : {core::Tool::Flatten, core::Tool::Pull})
            isOpen = choose(tool, [&] { return brush().tool == tool; });
    }
    /// Clicks the item until `happened` returns true.
    template <class Happened> bool choose(const vr::PanelAction& item, const Happened& happened, int count = 2)
    {
        return hand.choose(tools(), item, happened, count);
    }
    /// Opens a panel in place of the tool panel.
    void open(PanelKind kind) { hand.openFromTools(tools(), kind); }
    vr::HeadsetSettings settings() const { return HeadsetSettingsStore().load(); }

    /// Returns the view of a user who turns to a place in the room, then turns back.
    Look lookAt(const Vec3& place)
    {
        const Vec3 way = place - hand.head.position;
        turnHead(std::atan2(-way.x(), -way.z()) * 180 / std::numbers::pi);
        const Look look{hand.picture(), *hand.seen().head};
        turnHead(0);
        return look;
    }
    QColor colorAt(const Vec3& place)
    {
        const Look look = lookAt(place);
        return look.picture.pixelColor(look.at(place));
    }
    void putWandsAside()
    {
        hand.put(Side::Left, {-0.5, 1.1, -0.1});
        hand.put(Side::Right, {0.5, 1.1, -0.1});
        hand.waitForPanels();
    }
    /// Returns the part of the eye's picture that shows `area` of a panel in front of the user.
    QImage areaOf(const vr::PanelLayout& layout, const QRectF& area)
    {
        putWandsAside();
        const vr::Pose pose = hand.placeOf(layout);
        const auto place = [&](const QPointF& corner) -> Vec3 {
            const QPointF own = corner - QPointF(layout.size.width(), layout.size.height()) / 2;
            return pose * (Vec3(own.x(), -own.y(), 0) * layout.distance / 1000);
        };
        return lookAt(pose.position).between(place(area.topLeft()), place(area.bottomRight()));
    }

    bool isOpen = false;

private:
    void turnHead(double degrees)
    {
        hand.headset().step(qPrintable(QStringLiteral("{'head': {'yaw_pitch_roll': [%1, 0, 0]}}").arg(degrees)));
        hand.frames(2);
    }
};
} // namespace

class TestHeadsetPanels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void tools_chooseTheBrush();
    void tools_undoRedoAndRestore();
    void tools_addABall();
    void tools_invertAndClearTheMask();
    void tools_recentre();
    void tools_leave();
    void presses_neverSculpt();
    void brushInTheClay_sculptsBeforeAPanel();
    void bothWands_pointAtAPanel();
    void colors_bySwatchSliderAndChannel();
    void files_open();
    void files_openLosingChanges();
    void files_save();
    void settings_general();
    void settings_swapHands();
    void settings_vibration();
    void settings_performance();
};

void TestHeadsetPanels::tools_chooseTheBrush()
{
    using core::BrushShape, core::Symmetry, core::Tool, core::Topology;
    AtTools v;
    QVERIFY(v.isOpen);
    const std::size_t count = core::toolNames().size();
    for (std::size_t i = 1; i <= count; ++i) {
        const auto tool = static_cast<Tool>(i % count);
        QVERIFY2(v.choose(tool, [&] { return v.brush().tool == tool; }), core::toolNames()[i % count].data());
    }
    for (const BrushShape shape : {BrushShape::Ray, BrushShape::Sphere})
        QVERIFY(v.choose(shape, [&] { return v.brush().brush == shape; }));
    for (const Topology topology : {Topology::Uniform, Topology::Adaptive})
        QVERIFY(v.choose(topology,
                         [&] { return (v.brush().topology == Topology::Uniform) == (topology == Topology::Uniform); }));
    QVERIFY(v.choose(vr::ChooseSymmetry{true}, [&] { return v.brush().symmetry == Symmetry::Y; }));
    vr::ToolPanel symmetric = tools();
    symmetric.isSymmetric = true;
    QVERIFY(v.hand.choose(symmetric, vr::ChooseSymmetry{false}, [&] { return v.brush().symmetry == Symmetry::None; }));
    for (const int sectors : {6, 1})
        QVERIFY(v.choose(vr::ChooseRadial{sectors}, [&] { return v.brush().radial == sectors; }));
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// A trigger pull adds one ball where it begins, even if the controller moves on. A ball at the surface is joined to
/// the model.
void TestHeadsetPanels::tools_addABall()
{
    AtTools v;
    QVERIFY(v.choose(vr::AddNext{true}, [] { return true; }));
    v.hand.press(Side::Left, "menu");
    const double radius = vr::defaultRadius / v.scale(), height = 50 + radius / 2;
    v.hand.stroke({0, height, 0}, {0, height + 2 * radius, 0});
    QCOMPARE(v.changes(), 1);
    const double top = v.box().max().y();
    QVERIFY2(std::abs(top - height - radius) < 0.1 * radius, qPrintable(QString::number(top)));
    const core::MeshReport joined =
        v.hand.ask([](core::Sculptor& sculptor) { return core::checkMesh(core::extractMesh(sculptor.mesh())); });
    QVERIFY(joined.components == 1 && joined.genus == 0);
    v.hand.stroke({0, top - 1, 0}, {0, top + 4, 0}); // this trigger pull sculpts instead of adding a ball
    QCOMPARE(v.changes(), 2);
    QVERIFY(v.box().max().y() > top + 0.5);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPanels::tools_invertAndClearTheMask()
{
    AtTools v;
    QVERIFY(v.choose(PanelCommand::InvertMask, [&] { return v.changes() == 1; }));
    QVERIFY(v.choose(PanelCommand::ClearMask, [&] { return v.changes() == 2; }));
    QVERIFY(v.choose(PanelCommand::Undo, [&] { return v.changes() == 1; }));
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPanels::tools_undoRedoAndRestore()
{
    AtTools v;
    v.hand.press(Side::Left, "menu");
    v.pull();
    v.hand.press(Side::Left, "menu");
    const std::uint64_t pulled = v.hash();
    QCOMPARE(v.changes(), 1);
    QVERIFY(v.choose(PanelCommand::Undo, [&] { return v.changes() == 0; }));
    QVERIFY(v.isUntouched());
    QVERIFY(v.choose(PanelCommand::Redo, [&] { return v.changes() == 1; }));
    QCOMPARE(v.hash(), pulled);
    v.hand.click(tools(), PanelCommand::RestoreModel); // Restore needs a long press, so a click must do nothing
    QCOMPARE(v.hash(), pulled);
    v.hand.setSlow(true);
    QVERIFY(v.choose(
        PanelCommand::RestoreModel, [&] { return v.hash() == v.startHash; }, longPress));
    QCOMPARE(v.changes(), 2);
    QVERIFY(v.choose(PanelCommand::Undo, [&] { return v.changes() == 1; }));
    QCOMPARE(v.hash(), pulled);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Recentring makes the head's current position the middle of the room again and places the model in front of it.
void TestHeadsetPanels::tools_recentre()
{
    AtTools v;
    v.hand.headset().step("{'head': {'position': [0.4, 1.55, 0.2], 'yaw_pitch_roll': [20, 0, 0]}}");
    v.hand.frames(2);
    const auto isBefore = [&](const vr::Pose& head) {
        return (v.model().translation() - head * Vec3(0, -0.2, -0.6)).norm() < 0.02;
    };
    QVERIFY(v.hand.seen().head && !isBefore(*v.hand.seen().head));
    v.hand.click(tools(), PanelCommand::Recentre);
    v.hand.settle();
    QVERIFY(v.hand.seen().head);
    const vr::Pose head = *v.hand.seen().head;
    QVERIFY((head.position - Vec3(0, 1.55, 0)).norm() < 1e-3);
    QVERIFY((head.forward() + Vec3::UnitZ()).norm() < 1e-3);
    QVERIFY(isBefore(head));
    QVERIFY(v.isUntouched());
    QCOMPARE(v.program.document.history().stack().count(), 0);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPanels::tools_leave()
{
    AtTools v;
    v.hand.press(v.hand.pointAt(tools(), PanelCommand::LeaveVr), "trigger");
    v.hand.waitUntilOut();
    QCOMPARE(notice(v.program), QStringLiteral("Left VR."));
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Pressing panel items must not sculpt: with either brush, with the panel in front of the clay, between items, and
/// while a pulled trigger moves into the clay.
void TestHeadsetPanels::presses_neverSculpt()
{
    AtTools v;
    v.hand.put(Side::Left, {0.05, 1.15, -0.25}); // in front of the ball, so that the panel covers it
    v.hand.settle();
    for (const core::BrushShape shape : {core::BrushShape::Sphere, core::BrushShape::Ray}) {
        v.hand.click(tools(), shape);
        QCOMPARE(v.brush().brush, shape);
        v.hand.press(v.hand.pointAt(tools(), core::Tool::Pull), "trigger", 10);
        const Side side = v.hand.pointAt(tools(), core::Tool::Pull);
        v.hand.set(side, "trigger", 1);
        v.hand.frames(2);
        for (const double y : {80, 60, 50, 48}) {
            v.hand.put(side, v.hand.place({0, y, 0}), {0, -1, 0});
            v.hand.frame();
        }
        v.hand.set(side, "trigger", 0);
        v.hand.settle();
        const vr::PanelLayout layout = vr::layoutOf(tools());
        const vr::Pose pose = v.hand.placeOf(layout);
        const Vec3 edge = pose * Vec3(0, layout.metres().y() / 2 - 0.003, 0), towards = pose.rotation * -Vec3::UnitZ();
        v.hand.put(side, edge - 0.1 * towards, towards);
        v.hand.frame();
        v.hand.press(side, "trigger", 10);
        v.hand.settle();
        QVERIFY(v.isUntouched());
    }
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// A panel behind the surface must not take the trigger.
void TestHeadsetPanels::brushInTheClay_sculptsBeforeAPanel()
{
    AtTools v;
    QVERIFY(v.isOpen);
    const Vec3 tip = v.hand.place({-49, 0, 0});
    const vr::Pose panel = v.hand.placeOf(vr::layoutOf(tools()));
    v.hand.put(Side::Right, tip, (panel.position - tip).normalized());
    v.hand.frames(3);
    v.hand.press(Side::Right, "trigger", 6);
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Each controller shows its own ray. The test looks in front of the panel's title, where nothing else is blue.
void TestHeadsetPanels::bothWands_pointAtAPanel()
{
    AtTools v({}, HeadsetHand::enough);
    v.open(PanelKind::Settings);
    v.hand.waitForPanels();
    const vr::PanelLayout layout = layoutOf(vr::SettingsPanel::of(v.settings(), vr::SettingsPage::General));
    const vr::Pose pose = v.hand.placeOf(layout);
    const Vec3 towards = pose.rotation * -Vec3::UnitZ();
    const auto before = [&](double x, double distance) -> Vec3 {
        return pose * Vec3(x, layout.metres().y() / 2 - 0.035, 0) - distance * towards;
    };
    const auto isRayAt = [&](double x) {
        const Look look = v.lookAt(before(x, 0.05));
        const QPoint at = look.at(before(x, 0.05));
        int bluest = 0;
        for (int dy = -3; dy <= 3; ++dy)
            for (int dx = -3; dx <= 3; ++dx) {
                const QColor color = look.picture.pixelColor(at + QPoint(dx, dy));
                bluest = std::max(bluest, color.blue() - color.red());
            }
        return bluest > 40;
    };
    constexpr double left = -0.08, right = 0.08;
    QVERIFY(!isRayAt(left) && !isRayAt(right));
    v.hand.put(Side::Left, before(left, 0.1), towards);
    QVERIFY(isRayAt(left) && !isRayAt(right));
    v.hand.put(Side::Right, before(right, 0.1), towards);
    QVERIFY(isRayAt(left));
    QVERIFY(isRayAt(right));
}

void TestHeadsetPanels::colors_bySwatchSliderAndChannel()
{
    Alone v;
    v.hand.put(Side::Right, {0.35, 1.25, -0.3});
    v.hand.press(Side::Right, "menu");
    const auto panel = [&] {
        return vr::ColorPanel{v.brush().color, 0, v.program.window.findChild<ui::ColorPanel*>()->swatches()};
    };
    const core::Rgb swatch = panel().swatches.at(3);
    QVERIFY(v.brush().color != swatch);
    QVERIFY(v.hand.choose(panel(), vr::ChooseColor{swatch}, [&] { return v.brush().color == swatch; }));
    for (const double value : {0.0, 255.0})
        QVERIFY(
            v.hand.choose(panel(), vr::Slide{PanelSlider::Green, value}, [&] { return v.brush().color.g == value; }));
    QCOMPARE(v.brush().color.r, swatch.r);
    v.hand.click(panel(), vr::ChooseChannel{2});
    v.hand.slide(Side::Right, {0, v.brush().color.b > 128 ? -1.0 : 1.0});
    v.hand.settle();
    QVERIFY(v.brush().color.b != swatch.b); // sliding on the pad changes the channel chosen last, blue
    QCOMPARE(v.brush().color.r, swatch.r);
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Returns the content of the files panel for the folder of the visit.
vr::FilesPanel filesOf(const HeadsetFixture& fixture)
{
    HeadsetFiles files;
    files.watch(QFileInfo(fixture.path("clay.glb")).absolutePath());
    [&] { QTRY_VERIFY(!files.tiles().isEmpty()); }();
    vr::FilesPanel panel;
    panel.files = files.tiles();
    return panel;
}

void TestHeadsetPanels::files_open()
{
    AtTools v;
    core::writeMesh(v.path("other.stl").toStdU16String(), core::icosphere(3, 20));
    QTest::qWait(600); // gives the folder watcher time to notice
    v.open(PanelKind::Files);
    vr::FilesPanel panel = filesOf(v);
    QCOMPARE(panel.files.size(), 2);
    const QString other = panel.files[panel.files[0].path.endsWith(QStringLiteral("other.stl")) ? 0 : 1].path;
    const auto isOpened = [&] { return v.program.document.modelInfo().path == other; };
    for (int i = 0; i < 6 && !isOpened(); ++i) {
        v.hand.click(panel, vr::ChooseFile{other});
        panel.chosen = other;
        v.hand.waitForPanels();
        v.hand.click(panel, vr::OpenFile{other});
    }
    QVERIFY(isOpened());
    v.hand.settle();
    QVERIFY(std::abs(v.scale() * 40 - 0.5) < 0.01);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPanels::files_openLosingChanges()
{
    AtTools v;
    core::writeMesh(v.path("other.stl").toStdU16String(), core::icosphere(3, 20));
    v.hand.stroke({0, 49, 0}, {0, 54, 0}, 8);
    QVERIFY(v.program.document.savedState().isModified());
    const std::uint64_t pulled = v.hash();
    QTest::qWait(600);
    v.open(PanelKind::Files);
    vr::FilesPanel panel = filesOf(v);
    panel.hasUnsavedChanges = true;
    const QString other = panel.files[panel.files[0].path.endsWith(QStringLiteral("other.stl")) ? 0 : 1].path;
    const auto isOpened = [&] { return v.program.document.modelInfo().path == other; };
    for (int i = 0; i < 6 && !isOpened(); ++i) {
        v.hand.click(panel, vr::ChooseFile{other});
        panel.chosen = other;
        v.hand.waitForPanels();
        // discarding changes needs a long press, so a click must do nothing
        v.hand.click(panel, vr::OpenFile{other, true});
        QCOMPARE(v.hash(), pulled);
        v.hand.setSlow(true);
        v.hand.click(panel, vr::OpenFile{other, true}, longPress);
        v.hand.setSlow(false);
    }
    QVERIFY(isOpened());
    v.hand.settle();
    QCOMPARE(v.changes(), 0);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// The panel shows the file name after saving.
void TestHeadsetPanels::files_save()
{
    AtTools v({}, {432, 480});
    v.open(PanelKind::Files);
    vr::FilesPanel panel = filesOf(v);
    const vr::PanelLayout before = layoutOf(panel);
    panel.saved = QStringLiteral("clay-001.glb");
    const vr::PanelLayout after = layoutOf(panel);
    const QRectF area = after.items.back().area;
    const auto* status = std::get_if<vr::TextLook>(&after.items.back().look);
    QVERIFY(status && status->text.contains(panel.saved));

    const QImage silent = v.areaOf(before, area);
    const auto isSaved = [&] { return v.files().contains(QStringLiteral("clay-001.stl")); };
    QVERIFY(v.hand.choose(panel, PanelCommand::SaveModel, isSaved));
    const QImage told = v.areaOf(after, area);
    const QImage painted = vr::paint(after);
    const double share =
        changed(vr::paint(before), painted).width() / (painted.width() * area.width() / after.size.width());
    QVERIFY(share > 0.1 && share < 0.9);
    const double seen = static_cast<double>(changed(silent, told).width()) / told.width();
    QVERIFY2(std::abs(seen - share) < 0.04, qPrintable(QStringLiteral("%1 %2").arg(seen).arg(share)));
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPanels::settings_general()
{
    AtTools v({}, HeadsetHand::enough);
    v.open(PanelKind::Settings);
    const auto panel = [&] { return vr::SettingsPanel::of(v.settings(), vr::SettingsPage::General); };
    const Vec3 before = v.model().translation();
    QVERIFY(v.hand.choose(panel(), vr::Slide{PanelSlider::Height, 0.2},
                          [&] { return std::abs(v.settings().heightOffset - 0.2) < 0.021; }));
    QVERIFY((v.model().translation() - before - Vec3(0, v.settings().heightOffset, 0)).norm() < 1e-3);
    QVERIFY(
        v.hand.choose(panel(), vr::Slide{PanelSlider::TurnSpeed, 180}, [&] { return v.settings().turnRate == 180; }));
    const auto floor = [&] {
        v.putWandsAside();
        return v.lookAt({1.4, 0, -1.4}).between({1.2, 0, -1.6}, {1.6, 0, -1.2});
    };
    const QImage grid = floor();
    QVERIFY(v.hand.choose(panel(), vr::ShowFloor{false}, [&] { return !v.settings().showsFloor; }));
    QVERIFY(floor() != grid);
    QVERIFY(v.hand.choose(panel(), vr::ButtonPreset::Studio,
                          [&] { return v.settings().wands.preset == vr::ButtonPreset::Studio; }));
    QVERIFY(v.hand.choose(panel(), vr::ButtonPreset::Paper,
                          [&] { return v.settings().wands.preset == vr::ButtonPreset::Paper; }));
    v.hand.click(panel(), vr::ShowPanel{PanelKind::Settings, false});
    const auto yaw = [&] {
        return std::atan2(-v.model().linear()(2, 0), v.model().linear()(0, 0)) * 180 / std::numbers::pi;
    };
    const double turned = yaw();
    v.hand.pressPad(Side::Left, 0.8, 0, 30);
    v.hand.settle();
    QVERIFY2(std::abs(yaw() - turned - 60) < 8, qPrintable(QString::number(yaw() - turned)));
    QVERIFY(v.isUntouched());
    v.hand.leave();
    v.hand.enter(); // the settings persist after leaving VR
    v.hand.settle();
    QVERIFY(std::abs((v.model().translation() - before).y() - v.settings().heightOffset) < 1e-3);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPanels::settings_swapHands()
{
    AtTools v;
    v.open(PanelKind::Settings);
    const auto panel = vr::SettingsPanel::of(v.settings(), vr::SettingsPage::General);
    QVERIFY(
        v.hand.choose(panel, vr::ChooseHand{Side::Left}, [&] { return v.settings().wands.sculpting == Side::Left; }));
    v.hand.put(Side::Right, {0.5, 1.1, -0.2});
    v.hand.put(Side::Left, v.hand.place({0, 49, 0}));
    v.hand.frame();
    v.hand.press(Side::Left, "trigger", 8);
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    v.hand.pressPad(Side::Left, -0.8, 0);
    v.hand.settle();
    QVERIFY(v.isUntouched());

    v.hand.put(Side::Left, {-0.5, 1.1, -0.2});
    v.hand.put(Side::Right, {0.3, 1.15, -0.2});
    v.hand.press(Side::Right, "menu"); // the tool panel is now on the other hand, and replaces the settings
    QVERIFY(v.choose(core::Tool::Paint, [&] { return v.brush().tool == core::Tool::Paint; }));
    v.hand.press(Side::Right, "menu");
    v.hand.put(Side::Left, {-0.35, 1.25, -0.3});
    v.hand.press(Side::Left, "menu"); // the colours have swapped hands, too
    const vr::ColorPanel colors{v.brush().color, 0, v.program.window.findChild<ui::ColorPanel*>()->swatches()};
    const core::Rgb swatch = colors.swatches.at(3);
    QVERIFY(v.brush().color != swatch);
    QVERIFY(v.hand.choose(colors, vr::ChooseColor{swatch}, [&] { return v.brush().color == swatch; }));
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetPanels::settings_vibration()
{
    AtTools v;
    v.open(PanelKind::Settings);
    const auto page = [&](vr::SettingsPage shown) { return vr::SettingsPanel::of(v.settings(), shown); };
    v.hand.waitForPanels();
    v.hand.click(page(vr::SettingsPage::General), vr::SettingsPage::Haptics);
    for (std::size_t i = 0; i < vr::sensationCount; ++i) {
        const auto slider = static_cast<PanelSlider>(static_cast<std::size_t>(PanelSlider::Contact) + i);
        QVERIFY(v.hand.choose(page(vr::SettingsPage::Haptics), vr::Slide{slider, 0},
                              [&] { return v.settings().hapticLevels.of[i] == 0; }));
    }
    v.hand.click(page(vr::SettingsPage::Haptics), vr::ShowPanel{PanelKind::Settings, false});
    const qsizetype before = v.hand.headset().report()["haptics"].toArray().size();
    QVERIFY(before > 0);
    v.pull();
    v.hand.hold(Side::Right, "squeeze");
    v.hand.settle();
    QVERIFY(v.changes() == 2);
    QCOMPARE(v.hand.headset().report()["haptics"].toArray().size(), before);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// The performance panel can be shown and hidden, and counts lost frames.
void TestHeadsetPanels::settings_performance()
{
    AtTools v({}, HeadsetHand::enough);
    v.open(PanelKind::Settings);
    v.hand.drawAllFrames(); // only drawn frames can be lost
    v.hand.setSlow(true);   // the numbers are updated twice per second
    const auto panel = [&] { return vr::SettingsPanel::of(v.settings(), vr::SettingsPage::General); };
    const vr::PanelLayout layout = layoutOf(vr::PerformancePanel());
    const QRectF line = layout.items.back().area; // the changing line above may reach into the first pixels
    const QRectF lost = line.adjusted(0, line.height() / 3, 0, 0);
    const auto* number = std::get_if<vr::TextLook>(&layout.items.back().look);
    QVERIFY(number && number->text == QStringLiteral("0"));
    const QImage before = v.areaOf(layout, lost);
    QVERIFY(v.hand.choose(panel(), vr::ShowPerformance{true}, [&] { return v.settings().showsPerformance; }));
    const QImage none = v.areaOf(layout, lost);
    QVERIFY(none != before);
    QCOMPARE(v.areaOf(layout, lost), none);
    v.hand.headset().step("{'late_ms': 400}");
    QVERIFY(v.areaOf(layout, lost) != none);
    QVERIFY(v.hand.choose(panel(), vr::ShowPerformance{false}, [&] { return !v.settings().showsPerformance; }));
    QCOMPARE(v.areaOf(layout, lost), before);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

FETTLE_TEST(TestHeadsetPanels, app::OnScreen)
#include "tst_headset_panels.moc"
