// Tests each button of the preset Paper (section 4.1 of the paper): it is pressed in the headset and the document must
// show the effect.
#include "tests/app/headset/headset_visit.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

#include "vr/sculpt/brush_state.h"

#include <numbers>

using namespace app;
using core::Vec3;
using vr::Side;

namespace
{
constexpr QSize large{432, 480}; ///< pixels of an eye, for tests of small details

/// Returns the rotation about the vertical axis in degrees, counter-clockwise from above.
double yawOf(const Eigen::Affine3d& model)
{
    const Vec3 x = model.linear().col(0);
    return std::atan2(-x.z(), x.x()) * 180 / std::numbers::pi;
}
} // namespace

class TestHeadsetPaper : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void leftPadLeft_turnsClockwise() { turns(-0.8, -1); }
    void leftPadRight_turnsAnticlockwise() { turns(0.8, 1); }
    void leftPadTop_togglesTopology() { togglesTopology(0.8); }
    void leftPadBottom_togglesTopology() { togglesTopology(-0.8); }
    void leftSlide_scalesTheModel();
    void leftMenu_showsTheToolsWhichThePadScrolls();
    void leftTrigger_movesTheModel();
    void leftSideHeld_saves();
    void rightPadTop_togglesTheBrush();
    void rightPadBottom_togglesSymmetry();
    void rightPadLeftAndRight_undoAndRedo();
    void rightSlide_setsTheRadius();
    void rightMenu_opensTheColoursWhichThePadSets();
    void rightTrigger_sculptsAsHardAsItIsPulled();
    void rightTrigger_pulledBeforeTheSurfaceWaitsForIt_data();
    void rightTrigger_pulledBeforeTheSurfaceWaitsForIt();
    void rightSideHeld_restoresAndThatCanBeUndone();
    void handsMaySwap();
    void whatIsHeld_fillsARing();
    void labels_fadeOnceUsedAndComeBackWhenLookedAt();

private:
    void turns(double x, int sign);
    void togglesTopology(double y);
    static void movesTheModel(Visit& v, Side side);
    static void scalesTheModel(Visit& v, Side side);
};

void TestHeadsetPaper::turns(double x, int sign)
{
    Alone v;
    const double before = yawOf(v.model());
    v.hand.pressPad(Side::Left, x, 0, 30);
    v.hand.settle();
    const double turned = yawOf(v.model()) - before;
    QVERIFY2(sign * turned > 15 && sign * turned < 25,
             qPrintable(QString::number(turned))); // a third of a second at 60 degrees per second
    QVERIFY(v.isUntouched());
}

/// Toggles uniform topology, in which a small brush does not refine the mesh. `y`: place on the pad, -1 to 1.
void TestHeadsetPaper::togglesTopology(double y)
{
    Alone v;
    const auto vertices = v.program.document.modelInfo().vertices;
    QVERIFY(v.brush().topology != core::Topology::Uniform);
    v.hand.pressPad(Side::Left, 0, y);
    QTRY_COMPARE(v.brush().topology, core::Topology::Uniform);
    core::Topology drawn{};
    QObject::connect(&v.program.document, &Document::stepped,
                     [&drawn](const core::FileEntry& step) { drawn = std::get<core::Stroke>(step).settings.topology; });
    v.pull();
    QTRY_COMPARE(drawn, core::Topology::Uniform);
    QVERIFY(v.program.document.savedState().isModified());
    QVERIFY(v.program.document.modelInfo().vertices < vertices + 20);
    v.hand.pressPad(Side::Left, 0, y);
    QTRY_VERIFY(v.brush().topology != core::Topology::Uniform);
    v.pull();
    QTRY_COMPARE(drawn, core::Topology::Adaptive);
    QVERIFY(v.program.document.modelInfo().vertices > vertices + 100);
}

/// Scaling the model keeps the size of the brush in the room.
void TestHeadsetPaper::scalesTheModel(Visit& v, Side side)
{
    const double before = v.scale(), radius = v.hand.seen().brush.value().radius;
    v.hand.slide(side, {0, 1});
    v.hand.settle();
    QVERIFY(v.scale() > 1.5 * before);
    QCOMPARE(v.hand.seen().brush.value().radius, radius);
    v.hand.slide(side, {0, -1});
    v.hand.settle();
    QVERIFY(std::abs(v.scale() / before - 1) < 0.15);
}

void TestHeadsetPaper::leftSlide_scalesTheModel()
{
    Alone v;
    scalesTheModel(v, Side::Left);
    QVERIFY(v.isUntouched());
}

void TestHeadsetPaper::leftMenu_showsTheToolsWhichThePadScrolls()
{
    using core::Tool;
    Alone v;
    v.hand.pressPad(Side::Left, 0.8, 0); // without the menu the pad turns the model
    v.hand.settle();
    QCOMPARE(v.brush().tool, Tool::Pull);
    v.hand.press(Side::Left, "menu");
    const std::vector<Tool> order = vr::toolOrder(vr::ButtonPreset::Paper);
    for (std::size_t i = 1; i <= order.size(); ++i) {
        v.hand.pressPad(Side::Left, 0.8, 0);
        QTRY_COMPARE(v.brush().tool, order[i % order.size()]);
    }
    v.hand.pressPad(Side::Left, -0.8, 0);
    QTRY_COMPARE(v.brush().tool, Tool::Mask);
    v.hand.press(Side::Left, "menu");
    v.hand.pressPad(Side::Left, 0.8, 0);
    v.hand.settle();
    QCOMPARE(v.brush().tool, Tool::Mask);
    QVERIFY(v.isUntouched());
}

void TestHeadsetPaper::movesTheModel(Visit& v, Side side)
{
    const Vec3 before = v.model().translation(), by(0.1, 0.05, -0.02), from(side == Side::Left ? -0.3 : 0.3, 1.2, -0.4);
    v.hand.put(side, from);
    v.hand.frame();
    v.hand.set(side, "trigger", 1);
    v.hand.frames(2);
    v.hand.put(side, from + by);
    v.hand.frames(2);
    v.hand.set(side, "trigger", 0);
    v.hand.settle();
    QVERIFY((v.model().translation() - before - by).norm() < 1e-3);
}

void TestHeadsetPaper::leftTrigger_movesTheModel()
{
    Alone v;
    movesTheModel(v, Side::Left);
    QVERIFY(v.isUntouched());
}

void TestHeadsetPaper::leftSideHeld_saves()
{
    Alone v;
    v.pull();
    v.hand.press(Side::Left, "squeeze", 20); // too short to count as a long press
    v.hand.settle();
    QCOMPARE(v.files(), QStringList{QStringLiteral("clay.glb")});
    v.hand.hold(Side::Left, "squeeze");
    const QStringList saved{QStringLiteral("clay-001.glb"), QStringLiteral("clay-001.stl"), QStringLiteral("clay.glb")};
    QTRY_COMPARE(v.files(), saved);
    v.hand.settle();
    const core::TriangleMesh now =
        v.hand.ask([](core::Sculptor& sculptor) { return core::extractMesh(sculptor.mesh()); });
    for (const char* name : {"clay-001.glb", "clay-001.stl"})
        QCOMPARE(core::readMesh(v.path(name).toStdU16String()).triangles.size(), now.triangles.size());
    v.hand.hold(Side::Left, "squeeze");
    QTRY_VERIFY(v.files().contains(QStringLiteral("clay-002.stl")));
    v.hand.settle();
}

void TestHeadsetPaper::rightPadTop_togglesTheBrush()
{
    Alone v;
    v.hand.pressPad(Side::Right, 0, 0.8);
    QTRY_COMPARE(v.brush().brush, core::BrushShape::Ray);
    v.hand.put(Side::Right, v.hand.place({0, 0, 90}));
    v.hand.frame();
    v.hand.press(Side::Right, "trigger", 10); // the ray brush sculpts from a distance
    v.hand.settle();
    QVERIFY(v.box().max().z() > 50.2);
    v.hand.pressPad(Side::Right, 0, 0.8);
    QTRY_COMPARE(v.brush().brush, core::BrushShape::Sphere);
}

void TestHeadsetPaper::rightPadBottom_togglesSymmetry()
{
    Alone v;
    v.hand.pressPad(Side::Right, 0, -0.8);
    QTRY_COMPARE(v.brush().symmetry, core::Symmetry::Y); // the paper's xz plane
    v.pull();
    const core::Box box = v.box();
    QVERIFY(box.max().y() > 52);
    QCOMPARE(box.min().y(), -box.max().y());
    v.hand.pressPad(Side::Right, 0, -0.8);
    QTRY_COMPARE(v.brush().symmetry, core::Symmetry::None);
}

void TestHeadsetPaper::rightPadLeftAndRight_undoAndRedo()
{
    Alone v;
    v.pull();
    const std::uint64_t pulled = v.hash();
    QVERIFY(pulled != v.startHash);
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.settle();
    QCOMPARE(v.program.document.history().stack().index(), 0);
    QCOMPARE(v.hash(), v.startHash);
    v.hand.pressPad(Side::Right, 0.8, 0);
    v.hand.settle();
    QCOMPARE(v.program.document.history().stack().index(), 1);
    QCOMPARE(v.hash(), pulled);
    v.program.window.action(QStringLiteral("edit.undo"))->trigger(); // the window undoes the step made in the headset
    v.hand.settle();
    QCOMPARE(v.hash(), v.startHash);
}

void TestHeadsetPaper::rightSlide_setsTheRadius()
{
    Alone v;
    const double before = v.hand.seen().brush->radius;
    v.hand.slide(Side::Right, {1, 0});
    v.hand.settle();
    QVERIFY(v.hand.seen().brush->radius > 1.5 * before);
    v.hand.slide(Side::Right, {-1, 0});
    v.hand.settle();
    QVERIFY(std::abs(v.hand.seen().brush->radius / before - 1) < 0.15);
    QVERIFY(v.isUntouched());
}

void TestHeadsetPaper::rightMenu_opensTheColoursWhichThePadSets()
{
    Alone v;
    const core::Rgb before = v.brush().color;
    v.hand.press(Side::Right, "menu");
    v.hand.slide(Side::Right, {0, -1.6});
    QTRY_VERIFY(v.brush().color.r < before.r);
    QVERIFY(v.brush().color.g == before.g && v.brush().color.b == before.b);
    v.hand.pressPad(Side::Right, 0.8, 0);
    v.hand.slide(Side::Right, {0, -1.6});
    QTRY_VERIFY(v.brush().color.g < before.g);
    v.hand.pressPad(Side::Right, 0.8, 0);
    v.hand.slide(Side::Right, {0, -1.6});
    QTRY_VERIFY(v.brush().color.b < before.b);
    const core::Rgb lower = v.brush().color;
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.slide(Side::Right, {0, 1.6});
    QTRY_VERIFY(v.brush().color.g > lower.g);
    QCOMPARE(v.brush().color.b, lower.b);
    v.hand.press(Side::Right, "menu");
    QVERIFY(v.isUntouched());
}

void TestHeadsetPaper::rightTrigger_sculptsAsHardAsItIsPulled()
{
    Alone v;
    const auto height = [&](double trigger) {
        v.pull(trigger);
        const double top = v.changes() == 1 ? v.box().max().y() : 0;
        v.hand.pressPad(Side::Right, -0.8, 0);
        v.hand.settle();
        return v.isUntouched() ? top : 0;
    };
    const double light = height(0.6), full = height(1);
    QVERIFY2(light > 50.1 && full > light + 0.3, qPrintable(QStringLiteral("%1 %2").arg(light).arg(full)));
}

void TestHeadsetPaper::rightTrigger_pulledBeforeTheSurfaceWaitsForIt_data()
{
    QTest::addColumn<double>("before");
    QTest::addColumn<int>("steps");
    QTest::addColumn<core::Symmetry>("symmetry");
    for (const double radii : {1.01, 1.1})
        for (const int steps : {1, 12, 40})
            for (const core::Symmetry symmetry : {core::Symmetry::None, core::Symmetry::X})
                QTest::addRow("%g radii, %d steps, symmetry %d", radii, steps, int(symmetry))
                    << radii << steps << symmetry;
}

/// A trigger pulled early, away from the surface, waits for it. Nothing is refused, and no ball is reported as too
/// close.
void TestHeadsetPaper::rightTrigger_pulledBeforeTheSurfaceWaitsForIt()
{
    QFETCH(double, before);
    QFETCH(int, steps);
    QFETCH(core::Symmetry, symmetry);
    Alone v;
    v.program.window.brush()->set(&core::StrokeSettings::symmetry, symmetry);
    v.hand.frames(2);
    const double radius = vr::defaultRadius / v.scale();
    const int refusals = pulsesOf(v.hand, Side::Right, {.refused = true});
    const core::Vec3 way = core::Vec3(1, 2, 1).normalized();
    v.hand.begin((50 + before * radius) * way, (50 + before * radius) * way, 30);
    v.hand.stroke((50 + before * radius) * way, (50 - 0.5 * radius) * way, steps);
    QCOMPARE(v.changes(), 1);
    QVERIFY(!v.isUntouched());
    QCOMPARE(pulsesOf(v.hand, Side::Right, {.refused = true}), refusals);
    QVERIFY2(!notice(v.program).contains(QStringLiteral("Nothing")), qPrintable(notice(v.program)));
}

void TestHeadsetPaper::rightSideHeld_restoresAndThatCanBeUndone()
{
    Alone v;
    v.pull();
    const std::uint64_t pulled = v.hash();
    v.hand.press(Side::Right, "squeeze", 20); // too short to count as a long press
    v.hand.settle();
    QCOMPARE(v.hash(), pulled);
    v.hand.hold(Side::Right, "squeeze");
    v.hand.settle();
    QCOMPARE(v.hash(), v.startHash);
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.settle();
    QCOMPARE(v.hash(), pulled);
}

void TestHeadsetPaper::handsMaySwap()
{
    vr::HeadsetSettings settings;
    settings.wands.sculpting = Side::Left;
    Alone v(settings);
    v.hand.put(Side::Left, v.hand.place({0, 49.5, 0}));
    v.hand.frame();
    v.hand.press(Side::Left, "trigger", 8);
    v.hand.settle();
    QVERIFY(v.box().max().y() > 50.1);
    v.hand.hold(Side::Left, "squeeze");
    v.hand.settle();
    QCOMPARE(v.hash(), v.startHash);
    QCOMPARE(v.changes(), 2);
    for (int i = 0; i < 2; ++i)
        v.hand.pressPad(Side::Left, -0.8, 0);
    v.hand.settle();
    QVERIFY(v.isUntouched());
    for (const core::BrushShape shape : {core::BrushShape::Ray, core::BrushShape::Sphere}) {
        v.hand.pressPad(Side::Left, 0, 0.8);
        QTRY_COMPARE(v.brush().brush, shape);
    }

    v.hand.put(Side::Left, {-0.5, 1.1, -0.2});
    v.hand.pressPad(Side::Right, 0, 0.8);
    QTRY_COMPARE(v.brush().topology, core::Topology::Uniform);
    v.hand.press(Side::Right, "menu");
    v.hand.pressPad(Side::Right, 0.8, 0);
    QTRY_COMPARE(v.brush().tool, core::Tool::Push);
    v.hand.press(Side::Right, "menu");
    const double yaw = yawOf(v.model());
    v.hand.pressPad(Side::Right, -0.8, 0, 30);
    v.hand.settle();
    QVERIFY(yawOf(v.model()) < yaw - 15);
    movesTheModel(v, Side::Right);
    scalesTheModel(v, Side::Right);
    QVERIFY(v.isUntouched());
    v.hand.hold(Side::Right, "squeeze");
    QTRY_VERIFY(v.files().contains(QStringLiteral("clay-001.stl")));
    v.hand.settle();
}

/// A ring at the controller fills during a long press and empties after release.
void TestHeadsetPaper::whatIsHeld_fillsARing()
{
    Alone v({}, large);
    const auto amber = [&] {
        const QImage seen = v.hand.picture();
        int count = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x)
                count += seen.pixelColor(x, y).red() > seen.pixelColor(x, y).blue() + 80;
        return count;
    };
    v.hand.setSlow(true);
    for (const Side side : {Side::Left, Side::Right}) {
        v.hand.put(side, {side == Side::Left ? -0.3 : 0.3, 1.5, -0.5});
        v.hand.frames(20); // waits for the labels
        const int none = amber();
        v.hand.set(side, "squeeze", 1);
        v.hand.frames(5);
        const int some = amber();
        v.hand.frames(6);
        const int more = amber();
        QVERIFY2(some > none + 10 && more > some + 10,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(none).arg(some).arg(more)));
        v.hand.set(side, "squeeze", 0);
        v.hand.frames(2);
        QCOMPARE(amber(), none);
    }
    QVERIFY(v.isUntouched());
    QCOMPARE(v.files(), QStringList{QStringLiteral("clay.glb")});
}

/// The label of Undo fades after use, although there is nothing to undo. It returns when the user looks at the
/// controller, 36 degrees aside.
void TestHeadsetPaper::labels_fadeOnceUsedAndComeBackWhenLookedAt()
{
    Alone v({}, large);
    const auto look = [&](double degrees, double seconds) {
        v.hand.headset().step(qPrintable(QStringLiteral("{'head': {'yaw_pitch_roll': [%1, 0, 0]}}").arg(degrees)));
        v.hand.frames(static_cast<int>(seconds * HeadsetHand::slowHertz));
        return v.hand.picture();
    };
    v.hand.drawAllFrames();
    v.hand.setSlow(true);
    v.hand.put(Side::Right, {0.3, 1.6, -0.5});
    const QImage fresh = look(0, 2);
    QCOMPARE(look(0, 1), fresh);
    v.hand.pressPad(Side::Right, -0.8, 0);
    const QImage used = look(0, 2);
    QVERIFY(!changed(fresh, used).isNull());
    const QImage glance = look(-36, 0.2), gaze = look(-36, 2);
    QVERIFY(!changed(glance, gaze).isNull());
    QCOMPARE(look(0, 2), used);
}

FETTLE_TEST(TestHeadsetPaper, app::OnScreen)
#include "tst_headset_paper.moc"
