// Tests the VR simulator as a desktop user sees it: keys and mouse in its window, the real OpenXR loader and the same
// headset code.
#include "app/commands/command_line.h"
#include "app/headset/headset.h"
#include "app/headset/headset_settings_store.h"
#include "app/headset/simulator_controller.h"
#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"
#include "tests/support/other_windows_x11.h"
#include "tests/support/program_driver.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"
#include "tests/vr/simulator/scripted_runtime.h"
#include "tests/vr/vr_test.h"
#include "ui/headset/simulator_view.h"
#include "ui/headset/simulator_window.h"
#include "ui/settings/brush_settings.h"
#include "vr/panels/panel_content.h"

#include <QFile>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>

#include <future>

using namespace app;
using core::Vec3;

namespace
{
/// The program with a ball 100 mm in diameter, as if started with --vr-simulator.
struct SimulatorFixture
{
    explicit SimulatorFixture(const vr::HeadsetSettings& settings = {})
    {
        QSettings().clear();
        HeadsetSettingsStore().save(settings);
        core::writeMesh(m_folder.filePath(QStringLiteral("clay.glb")).toStdU16String(), core::icosphere(4, 50));
        new SimulatorController(&program.window, &program.worker, Simulator::open(QStringLiteral(FETTLE_BUILD_DIR)));
        window = program.window.findChild<ui::SimulatorWindow*>();
        view = window->view();
        openFile(program, m_folder.filePath(QStringLiteral("clay.glb")), {640, 480});
        auto* headset = program.window.findChild<Headset*>();
        QObject::connect(headset, &Headset::avatarChanged, headset,
                         [this](const std::optional<vr::AvatarState>& presence) { seen = presence.value_or(seen); });
    }

    void enter()
    {
        seen = {};
        program.window.action(QStringLiteral("vr.enter"))->trigger();
        QTRY_VERIFY(runtime.report()[QStringLiteral("state")].toString().contains(QStringLiteral("FOCUSED")));
        QTRY_VERIFY(!view->picture().isNull());
        QVERIFY(window->isVisible());
        QTRY_VERIFY(seen.brush);
        frames(4);
    }
    bool isIn() const { return program.window.findChild<Headset*>()->isActive(); }
    /// Waits until the headset has shown `count` more frames.
    void frames(int count)
    {
        for (int i = 0; i < count; ++i) {
            const qint64 before = view->picture().cacheKey();
            QTRY_VERIFY(view->picture().cacheKey() != before);
        }
    }
    void move(const Eigen::Vector2d& place, Qt::MouseButton button = Qt::NoButton, Qt::KeyboardModifiers modifiers = {})
    {
        sendMouse(view, QEvent::MouseMove, view->placeOf(place).toPoint(), button, modifiers);
    }
    /// Returns where a point in the room appears in the eye's view: -1 to 1 from left to right and from bottom to top.
    Eigen::Vector2d placeOf(const Vec3& point) const
    {
        const Vec3 own = view->controls().head().inverse() * point;
        return Eigen::Vector2d(own.x() / ui::SimulatorControls::sideTangent,
                               own.y() / ui::SimulatorControls::upTangent) /
               -own.z();
    }
    Vec3 tip() const { return view->controls().tip(view->controls().hand()).translation(); }
    /// Moves the mouse to the middle of the model's front.
    void touchModel()
    {
        const Vec3 front = seen.model * Vec3(0, 0, 50);
        move(placeOf(front));
        QTRY_VERIFY((tip() - front).norm() < 0.005);
        frames(3);
    }
    /// Drags sideways with the left mouse button.
    void stroke()
    {
        touchModel();
        const Eigen::Vector2d from = placeOf(view->controls().tip(view->controls().hand()).translation());
        sendMouse(view, QEvent::MouseButtonPress, view->placeOf(from).toPoint(), Qt::LeftButton);
        for (int i = 1; i <= 8; ++i) {
            move(from + Eigen::Vector2d(0.02 * i, 0), Qt::LeftButton);
            frames(1);
        }
        sendMouse(view, QEvent::MouseButtonRelease, view->placeOf(from).toPoint(), Qt::LeftButton);
        frames(4);
        QTRY_VERIFY(program.document.queue().isSettled());
    }
    void click(Qt::Key key)
    {
        QTest::keyClick(view, key);
        frames(6);
    }
    template <class Ask> auto ask(const Ask& what)
    {
        std::promise<decltype(what(std::declval<core::Sculptor&>()))> answer;
        program.worker.post([&](core::Sculptor& sculptor) { answer.set_value(what(sculptor)); });
        return answer.get_future().get();
    }
    std::uint64_t hash()
    {
        return ask([](core::Sculptor& sculptor) { return sculptor.mesh().meshHash(); });
    }
    int changes() { return program.document.history().stack().index(); }

    ScriptedRuntime runtime; ///< records invalid calls of the client
    Program program;
    ui::SimulatorWindow* window = nullptr;
    ui::SimulatorView* view = nullptr;
    vr::AvatarState seen;

private:
    QTemporaryDir m_folder;
};

/// Returns the number of pixels of the model in the middle of the picture.
int modelPixels(const QImage& picture)
{
    int count = 0;
    for (int y = picture.height() / 3; y < 2 * picture.height() / 3; y += 4)
        for (int x = picture.width() / 3; x < 2 * picture.width() / 3; x += 4)
            count += picture.pixelColor(x, y).lightness() > 60;
    return count;
}
} // namespace

class TestSimulator : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void visit_fromTheFirstFrameToTheNextVisit();
    void mouse_isWhereTheWandSculptsAndPoints();
    void restingHand_showsItsPanelWhole();
    void hand_thatRestsMovesTheModel();
    void bothHands_stretchTheModel();
    void window_closedLeavesVr();
    void process_entersAndEnds();
    void missing_isSaid();
};

/// A stroke is one step and keeps the model valid. The controller's undo removes it. Afterwards sculpting continues at
/// the desktop and in VR.
void TestSimulator::visit_fromTheFirstFrameToTheNextVisit()
{
    SimulatorFixture fixture;
    QVERIFY(!fixture.window->isVisible());
    const std::uint64_t before = fixture.hash();
    fixture.enter();
    QVERIFY(modelPixels(fixture.view->picture()) > 1000);

    fixture.stroke();
    QCOMPARE(fixture.changes(), 1);
    QVERIFY(fixture.hash() != before);
    const std::string unsoundness =
        fixture.ask([](core::Sculptor& sculptor) { return mesh_asserts::unsoundness(sculptor.mesh()); });
    QVERIFY2(unsoundness.empty(), unsoundness.c_str());

    const double radius = fixture.seen.brush->radius;
    QTest::keyPress(fixture.view, Qt::Key_Control);
    fixture.frames(3);
    for (int i = 1; i <= 4; ++i) {
        fixture.move({0.1 * i, 0}, Qt::NoButton, Qt::ControlModifier);
        fixture.frames(2);
    }
    QTest::keyRelease(fixture.view, Qt::Key_Control);
    QTRY_VERIFY(fixture.seen.brush && fixture.seen.brush->radius > 1.1 * radius);

    fixture.click(Qt::Key_Left); // left side of the sculpting controller's pad: undo
    QTRY_COMPARE(fixture.changes(), 0);
    QCOMPARE(fixture.hash(), before);

    QTest::keyClick(fixture.view, Qt::Key_Escape);
    QTRY_VERIFY(!fixture.isIn());
    QVERIFY(!fixture.window->isVisible());
    fixture.program.window.action(QStringLiteral("edit.redo"))->trigger();
    QTRY_COMPARE(fixture.changes(), 1);
    fixture.enter();
    QTest::keyClick(fixture.view, Qt::Key_Escape);
    QTRY_VERIFY(!fixture.isIn());
    QCOMPARE(fixture.runtime.clientErrors(), QStringList());
    QCOMPARE(fixture.runtime.clientWarnings(), QStringList());
}

/// The sphere brush follows the mouse on the surface, and so do the controller's ray and the laser at a panel.
void TestSimulator::mouse_isWhereTheWandSculptsAndPoints()
{
    SimulatorFixture fixture;
    fixture.enter();
    const auto isOnSurface = [&](double slack) {
        const Vec3 place = fixture.seen.model.inverse() * fixture.tip();
        return std::abs(place.norm() - 50) < slack;
    };
    for (const Vec3& place : {Vec3(0, 0, 50), Vec3(-30, 0, 40), Vec3(0, 30, 40)}) {
        fixture.move(fixture.placeOf(fixture.seen.model * place));
        QTRY_VERIFY(isOnSurface(1));
        const auto isBrushThere = [&] {
            return fixture.seen.brush &&
                   (fixture.placeOf(fixture.seen.brush->center) - fixture.placeOf(fixture.tip())).norm() < 0.02;
        };
        QTRY_VERIFY(isBrushThere());
    }
    fixture.program.window.brush()->set(&core::StrokeSettings::brush, core::BrushShape::Ray);
    for (const Vec3& place : {Vec3(0, 0, 50), Vec3(-30, 0, 40), Vec3(0, 30, 40)}) {
        const Vec3 wanted = fixture.seen.model * place;
        fixture.move(fixture.placeOf(wanted));
        const auto missesBy = [&] {
            const Eigen::Isometry3d wand = fixture.view->controls().tip(fixture.view->controls().hand());
            const Vec3 way = wanted - wand.translation(), forward = wand.linear() * -Vec3::UnitZ();
            return (way - way.dot(forward) * forward).norm();
        };
        QTRY_VERIFY(missesBy() < 0.005);
    }
    fixture.click(Qt::Key_Tab); // the left controller's menu button opens the tool panel
    fixture.click(Qt::Key_M);
    QTRY_VERIFY(!fixture.seen.panels.empty());
    QTRY_COMPARE(fixture.view->controls().hand(), ui::SimulatedHand::Right); // the other hand points at the panel
    const auto isSeenWhole = [&] {
        const vr::PanelTarget panel = fixture.seen.panels.front();
        double farthest = 0;
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) {
                const Vec3 corner = panel.pose * Vec3(x * panel.size.x(), y * panel.size.y(), 0);
                farthest = std::max(farthest, fixture.placeOf(corner).cwiseAbs().maxCoeff());
            }
        return farthest < 1;
    };
    QTRY_VERIFY(isSeenWhole()); // the head turns to the panel
    fixture.frames(20);
    const vr::PanelTarget panel = fixture.seen.panels.front();
    const Vec3 corner = panel.pose * Vec3(panel.size.x() * 0.4, panel.size.y() * 0.2, 0);
    fixture.move(fixture.placeOf(corner));
    const auto missesBy = [&] {
        const Eigen::Isometry3d wand = fixture.view->controls().tip(fixture.view->controls().hand());
        const vr::PanelTarget seen = fixture.seen.panels.front();
        const auto laser = vr::intersect({wand.translation(), wand.linear() * -Vec3::UnitZ()}, seen.pose);
        const auto sight = vr::intersect(fixture.view->controls().sight(), seen.pose);
        return laser && sight ? (laser->at - sight->at).norm() : 1;
    };
    QTRY_VERIFY(missesBy() < 0.005);
    fixture.click(Qt::Key_Tab);
    QCOMPARE(fixture.view->controls().hand(), ui::SimulatedHand::Left);
    fixture.click(Qt::Key_M);
    QTRY_VERIFY(fixture.seen.panels.empty());
    const auto aside = [&] { return fixture.view->controls().head().linear().col(2).x(); };
    QTRY_VERIFY(std::abs(aside()) < 0.02); // the head turns back
    QTest::keyClick(fixture.view, Qt::Key_Escape);
    QTRY_VERIFY(!fixture.isIn());
}

/// A panel must be completely visible once the head has turned to it. It is above the hand if nothing is in its way.
void TestSimulator::restingHand_showsItsPanelWhole()
{
    const ui::SimulatorControls controls;
    const Eigen::Isometry3d eye = controls.head(), wand = controls.tip(ui::SimulatedHand::Left);
    const auto poseOf = [](const Eigen::Isometry3d& at) {
        return vr::Pose{Eigen::Quaterniond(at.linear()), at.translation()};
    };
    const vr::Pose grip = poseOf(wand * Eigen::Translation3d(0, 0, vr::tipReach));
    for (const vr::PanelContent& content : {vr::PanelContent(vr::ToolPanel()), vr::PanelContent(vr::ColorPanel())}) {
        const Eigen::Vector2d size = vr::layoutOf(content).metres();
        const vr::Pose panel = vr::placeAtHand(grip, poseOf(eye), {size});
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) {
                const Vec3 own = eye.inverse() * (panel * Vec3(x * size.x(), y * size.y(), 0));
                QVERIFY(own.z() < 0 && std::abs(own.x() / own.z()) < 0.98 * ui::SimulatorControls::sideTangent &&
                        std::abs(own.y() / own.z()) < 0.98 * ui::SimulatorControls::upTangent);
            }
    }
}

/// The trigger of the other hand grabs the model in the preset Paper.
void TestSimulator::hand_thatRestsMovesTheModel()
{
    SimulatorFixture fixture;
    fixture.enter();
    fixture.click(Qt::Key_Tab);
    fixture.move({-0.2, 0.3});
    fixture.frames(3);
    const Vec3 before = fixture.seen.model.translation();
    QTest::keyPress(fixture.view, Qt::Key_Space);
    fixture.frames(3);
    fixture.move({-0.4, 0.3});
    fixture.frames(3);
    QTest::keyRelease(fixture.view, Qt::Key_Space);
    QTRY_VERIFY(before.x() - fixture.seen.model.translation().x() > 0.03);
    QCOMPARE(fixture.changes(), 0);
    QTest::keyClick(fixture.view, Qt::Key_Escape);
    QTRY_VERIFY(!fixture.isIn());
}

/// Squeezing grabs in the preset Studio: one hand moves the model, both hands scale it.
void TestSimulator::bothHands_stretchTheModel()
{
    vr::HeadsetSettings settings;
    settings.wands.preset = vr::ButtonPreset::Studio;
    SimulatorFixture fixture(settings);
    fixture.enter();
    const auto scale = [&fixture] { return fixture.seen.model.linear().col(0).norm(); };
    const double before = scale();
    fixture.move({-0.1, -0.3});
    fixture.frames(3);
    QTest::keyPress(fixture.view, Qt::Key_B);
    fixture.frames(3);
    for (int i = 1; i <= 4; ++i) {
        fixture.move({-0.1 + 0.2 * i, -0.3});
        fixture.frames(2);
    }
    QTest::keyRelease(fixture.view, Qt::Key_B);
    QTRY_VERIFY(scale() > 1.3 * before);
    fixture.frames(4);
    const Vec3 place = fixture.seen.model.translation();
    const double stretched = scale();
    QTest::keyPress(fixture.view, Qt::Key_G);
    fixture.frames(3);
    fixture.move({0.5, 0});
    fixture.frames(3);
    QTest::keyRelease(fixture.view, Qt::Key_G);
    QTRY_VERIFY((fixture.seen.model.translation() - place).norm() > 0.02);
    QVERIFY(std::abs(scale() / stretched - 1) < 1e-6);
    QCOMPARE(fixture.changes(), 0);
    QTest::keyClick(fixture.view, Qt::Key_Escape);
    QTRY_VERIFY(!fixture.isIn());
}

void TestSimulator::window_closedLeavesVr()
{
    SimulatorFixture fixture;
    fixture.enter();
    fixture.window->close();
    QTRY_VERIFY(!fixture.isIn());
    QVERIFY(fixture.program.window.isVisible());
    fixture.enter();
    fixture.program.window.close(); // the program leaves VR before it closes the window
    QTRY_VERIFY(!fixture.program.window.isVisible());
    QVERIFY(!fixture.isIn() && !fixture.window->isVisible());
}

/// Runs the program as from a shell: VR starts with the file's model without asking another runtime, and closing the
/// windows ends it.
void TestSimulator::process_entersAndEnds()
{
    const QTemporaryDir folder;
    const QString model = folder.filePath(QStringLiteral("clay.glb")), log = folder.filePath(QStringLiteral("log"));
    core::writeMesh(model.toStdU16String(), core::icosphere(4, 50));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XR_RUNTIME_JSON"), folder.filePath(QStringLiteral("none.json")));
    environment.insert(QStringLiteral("FETTLE_XR_LOG"), log);
    for (const char* home : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"})
        environment.insert(QString::fromLatin1(home), folder.filePath(QString::fromLatin1(home)));
    QProcess fettle;
    fettle.setProcessEnvironment(environment);
    fettle.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    fettle.start(QStringLiteral(FETTLE_PROGRAM), {QStringLiteral("--vr-simulator"), model});
    const auto hasFocus = [&log] {
        QFile file(log);
        return file.open(QIODevice::ReadOnly) && file.readAll().contains("XR_SESSION_STATE_FOCUSED");
    };
    QTRY_VERIFY(hasFocus());
    QTRY_VERIFY(askToClose(fettle.processId()));
    QTRY_COMPARE(fettle.state(), QProcess::NotRunning);
    QCOMPARE(fettle.exitStatus(), QProcess::NormalExit);
    QCOMPARE(fettle.exitCode(), 0);
}

void TestSimulator::missing_isSaid()
{
    const QTemporaryDir empty;
    try {
        Simulator::open(empty.path());
        QFAIL("there is none");
    } catch (const CommandFailure& failure) {
        QVERIFY(failure.sentence.contains(QStringLiteral("fettle_simulator.json")));
    }
}

FETTLE_TEST(TestSimulator, app::OnScreen)
#include "tst_simulator.moc"
