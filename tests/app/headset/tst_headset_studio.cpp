// Tests each function of the preset Studio: it is used in the headset and the document must show the effect.
#include "tests/app/headset/headset_visit.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

#include <numbers>

using namespace app;
using core::Vec3;
using vr::Side;

namespace
{
vr::HeadsetSettings studio()
{
    vr::HeadsetSettings settings;
    settings.wands.preset = vr::ButtonPreset::Studio;
    return settings;
}

struct AtStudio : Alone
{
    AtStudio() : Alone(studio()) {}
    Vec3 middle() const { return model().translation(); } ///< centre of the ball, which is the document's origin
};
} // namespace

class TestHeadsetStudio : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void supportPad_undoesAndRedoes();
    void supportPad_togglesTopology();
    void supportMenu_opensTheTools();
    void supportTrigger_smooths();
    void supportTrigger_hasNoToolThatIsNotOffered();
    void oneGrip_movesAndTurns();
    void bothGrips_scaleAndTurn();
    void sculptingPad_choosesBrushSymmetryAndTool();
    void sculptingSlide_setsTheRadius();
    void sculptingMenu_opensColorsOrInverts();
    void sideButtons_neitherSaveNorRestore();
};

void TestHeadsetStudio::supportPad_undoesAndRedoes()
{
    AtStudio v;
    v.pull();
    const std::uint64_t pulled = v.hash();
    v.hand.pressPad(Side::Left, -0.8, 0);
    v.hand.settle();
    QVERIFY(v.isUntouched());
    v.hand.pressPad(Side::Left, 0.8, 0);
    v.hand.settle();
    QCOMPARE(v.hash(), pulled);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetStudio::supportPad_togglesTopology()
{
    AtStudio v;
    v.hand.pressPad(Side::Left, 0, 0.8);
    v.hand.settle();
    QCOMPARE(v.brush().topology, core::Topology::Uniform);
    v.hand.pressPad(Side::Left, 0, -0.8);
    v.hand.settle();
    QCOMPARE(v.brush().topology, core::Topology::Refine);
    QVERIFY(v.isUntouched());
}

/// The tool panel opens on the support hand, and the other controller presses its items.
void TestHeadsetStudio::supportMenu_opensTheTools()
{
    AtStudio v;
    v.hand.put(Side::Left, {-0.35, 1.25, -0.3});
    v.hand.press(Side::Left, "menu");
    QVERIFY(v.hand.choose(vr::ToolPanel(), core::Tool::Paint, [&] { return v.brush().tool == core::Tool::Paint; }));
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Smooth is active only while the support trigger is held, even within one pull of the other trigger. The previous
/// tool then returns.
void TestHeadsetStudio::supportTrigger_smooths()
{
    AtStudio v;
    v.pull();
    const double height = v.box().max().y();
    v.hand.set(Side::Left, "trigger", 1);
    v.hand.frame();
    // many samples at one place, because the pulled area is finer now
    v.hand.stroke({0, height - 1, 0}, {0, height - 1, 0}, 60);
    const double smoothed = v.box().max().y();
    QVERIFY2(smoothed < height - 0.2, qPrintable(QStringLiteral("%1 %2").arg(height).arg(smoothed)));
    QCOMPARE(v.changes(), 2);
    v.hand.set(Side::Left, "trigger", 0);
    v.hand.frame();
    v.hand.begin({49, 0, 0}, {52, 0, 0}, 6);
    v.hand.set(Side::Left, "trigger", 1);
    v.hand.frames(4);
    v.hand.set(Side::Left, "trigger", 0);
    v.hand.frames(4);
    v.hand.end();
    v.hand.settle();
    QCOMPARE(v.changes(), 5); // pulled, smoothed; then pulled, smoothed, pulled in one trigger pull
    QCOMPARE(v.brush().tool, core::Tool::Pull);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Lesson steps and classes may exclude Smooth. The support trigger must then not switch the tool, even within a
/// stroke.
void TestHeadsetStudio::supportTrigger_hasNoToolThatIsNotOffered()
{
    AtStudio v;
    v.program.window.brush()->offerTools({core::Tool::Pull});
    v.hand.frames(4);
    const double before = v.box().max().y();
    v.hand.set(Side::Left, "trigger", 1);
    v.pull();
    QVERIFY2(v.box().max().y() > before + 0.2, qPrintable(QStringLiteral("%1 %2").arg(before).arg(v.box().max().y())));
    QCOMPARE(v.brush().tool, core::Tool::Pull);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetStudio::oneGrip_movesAndTurns()
{
    AtStudio v;
    for (const Side side : {Side::Left, Side::Right}) {
        const Vec3 before = v.middle(), by(0.1, 0.05, -0.02), from(side == Side::Left ? -0.3 : 0.3, 1.2, -0.4);
        v.hand.put(side, from);
        v.hand.frame();
        v.hand.set(side, "squeeze", 1);
        v.hand.frames(2);
        v.hand.put(side, from + by);
        v.hand.frames(2);
        QVERIFY((v.middle() - before - by).norm() < 1e-3);
        v.hand.put(side, from + by, Vec3(1, 0, -1).normalized());
        v.hand.frames(2);
        v.hand.set(side, "squeeze", 0);
        v.hand.settle();
        const Vec3 ahead = v.model().linear().col(2).normalized();
        const double turned = std::acos(std::clamp(std::abs(ahead.z()), 0.0, 1.0)) * 180 / std::numbers::pi;
        QVERIFY2(std::abs(turned - (side == Side::Left ? 45 : 90)) < 1, qPrintable(QString::number(turned)));
    }
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetStudio::bothGrips_scaleAndTurn()
{
    AtStudio v;
    const auto span = [&](const Vec3& half) {
        const Vec3 middle(0, 1.2, -0.4), reach(0, 0, -vr::tipReach); // positions of the grips, not of the tips
        v.hand.put(Side::Left, middle - half + reach);
        v.hand.put(Side::Right, middle + half + reach);
        v.hand.frames(2);
    };
    span({0.2, 0, 0});
    const double before = v.scale();
    v.hand.set(Side::Left, "squeeze", 1);
    v.hand.set(Side::Right, "squeeze", 1);
    v.hand.frames(2);
    span({0.3, 0, 0});
    QVERIFY(std::abs(v.scale() / before - 1.5) < 0.01);
    const double s = 0.15 * std::numbers::sqrt2;
    span({s, 0, -s});
    v.hand.set(Side::Left, "squeeze", 0);
    v.hand.set(Side::Right, "squeeze", 0);
    v.hand.settle();
    QVERIFY(std::abs(v.scale() / before - 1.5) < 0.01);
    const Vec3 x = v.model().linear().col(0).normalized();
    QVERIFY2((x - Vec3(1, 0, -1).normalized()).norm() < 0.01,
             qPrintable(QStringLiteral("%1 %2").arg(x.x()).arg(x.z())));
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetStudio::sculptingPad_choosesBrushSymmetryAndTool()
{
    AtStudio v;
    v.hand.pressPad(Side::Right, 0, 0.8);
    v.hand.settle();
    QCOMPARE(v.brush().brush, core::BrushShape::Ray);
    v.hand.pressPad(Side::Right, 0, -0.8);
    v.hand.settle();
    QCOMPARE(v.brush().symmetry, core::Symmetry::X);
    v.hand.pressPad(Side::Right, 0.8, 0);
    v.hand.settle();
    QCOMPARE(v.brush().tool, core::Tool::Push);
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.pressPad(Side::Right, -0.8, 0);
    v.hand.settle();
    QCOMPARE(v.brush().tool, core::Tool::Mask);
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetStudio::sculptingSlide_setsTheRadius()
{
    AtStudio v;
    const double before = v.hand.seen().brush->radius;
    v.hand.slide(Side::Right, {0, 1});
    v.hand.settle();
    QVERIFY(v.hand.seen().brush->radius > 1.5 * before);
    const double wide = v.hand.seen().brush->radius;
    v.hand.slide(Side::Right, {1, 0}); // sliding sideways has no effect
    v.hand.settle();
    QCOMPARE(v.hand.seen().brush->radius, wide);
    QVERIFY(v.isUntouched());
}

/// A tap opens the colours, a long press inverts the tool.
void TestHeadsetStudio::sculptingMenu_opensColorsOrInverts()
{
    AtStudio v;
    const core::Rgb before = v.brush().color;
    v.hand.press(Side::Right, "menu");
    v.hand.pressPad(Side::Right, 0.8, 0);
    v.hand.slide(Side::Right, {0, -1.6});
    v.hand.settle();
    QVERIFY(v.brush().color.g < before.g && v.brush().color.r == before.r);
    QCOMPARE(v.brush().tool, core::Tool::Pull);
    v.hand.press(Side::Right, "menu");

    v.hand.hold(Side::Right, "menu");
    v.hand.stroke({0, 51, 0}, {0, 47, 0}, 8);
    QVERIFY(v.box().max().y() < 49.9); // Pull is inverted, so it pushes
    v.hand.hold(Side::Right, "menu");
    v.hand.stroke({0, -49, 0}, {0, -54, 0}, 8);
    QVERIFY(v.box().min().y() < -51);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetStudio::sideButtons_neitherSaveNorRestore()
{
    AtStudio v;
    v.pull();
    const std::uint64_t pulled = v.hash();
    v.hand.hold(Side::Left, "squeeze");
    v.hand.hold(Side::Right, "squeeze");
    v.hand.settle();
    QCOMPARE(v.hash(), pulled);
    QCOMPARE(v.files(), QStringList{QStringLiteral("clay.glb")});
}

FETTLE_TEST(TestHeadsetStudio, app::OnScreen)
#include "tst_headset_studio.moc"
