// Tests bare hands: what they do in the headset, and the effect that the document shows.
#include "tests/app/headset/headset_visit.h"
#include "tests/support/test_main.h"
#include "tests/vr/vr_test.h"

using namespace app;
using core::Vec3;
using vr::Side;

namespace
{
/// A visit without controllers.
struct BareHanded : Alone
{
    explicit BareHanded(const vr::HeadsetSettings& settings = {}) : Alone(settings) { hand.putWandsDown(); }

    vr::ToolPanel tools() const
    {
        vr::ToolPanel panel;
        panel.canUndo = panel.canRedo = true;
        return panel;
    }
};
} // namespace

class TestHeadsetHands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GLX(); }

    void pinch_sculptsWhereTheFingersMeet();
    void stroke_outlastsAMomentWithoutTheHand();
    void fist_movesTheModelAndNeverSculpts();
    void twoFists_scaleTheModel();
    void palm_opensTheToolsAndAPinchPressesThem();
    void slider_setsTheRadius();
    void oneHand_hasTheToolsToo();
    void wand_mayBeTakenUpAgain();
};

void TestHeadsetHands::pinch_sculptsWhereTheFingersMeet()
{
    BareHanded v;
    v.pull();
    QCOMPARE(v.changes(), 1);
    QVERIFY(v.box().max().y() > 50.2);
    QVERIFY(v.box().max().x() < 50.5);
    v.pull(0.3); // fingers that do not meet
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Checks that a stroke goes on if the runtime loses the pinching hand for three frames.
void TestHeadsetHands::stroke_outlastsAMomentWithoutTheHand()
{
    BareHanded v;
    v.hand.begin({0, 49, 0}, {0, 50, 0}, 3);
    v.hand.headset().step("{'right': {'on': false}}");
    v.hand.frames(3);
    v.hand.headset().step("{'right': {'on': true}}");
    v.hand.frames(2);
    const double before = v.box().max().y();
    for (int i = 1; i <= 12; ++i) {
        v.hand.put(Side::Right, v.hand.place({0, 50 + 0.25 * i, 0}));
        v.hand.frame();
    }
    v.hand.end();
    v.hand.settle();
    QCOMPARE(v.changes(), 1);
    QVERIFY(v.box().max().y() > before + 0.05);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

/// Checks that a fist, on whose way finger and thumb meet, carries the model and leaves it whole. With the preset Paper
/// the side button of a controller would restore the model.
void TestHeadsetHands::fist_movesTheModelAndNeverSculpts()
{
    BareHanded v;
    const Vec3 before = v.model().translation(), start = v.hand.place({0, 49, 0}), by(0.1, -0.05, 0.02);
    v.hand.put(Side::Right, start);
    for (int i = 0; i <= 10; ++i) {
        v.hand.set(Side::Right, "squeeze", 0.1 * i);
        v.hand.set(Side::Right, "trigger", 0.1 * i);
        v.hand.frame();
    }
    v.hand.put(Side::Right, start + by, -Vec3::UnitZ(), 8);
    v.hand.frames(static_cast<int>(vr::holdSeconds * 90) + 20);
    QVERIFY((v.model().translation() - before - by).norm() < 1e-3);
    for (int i = 10; i >= 0; --i) {
        v.hand.set(Side::Right, "squeeze", 0.1 * i);
        v.hand.set(Side::Right, "trigger", 0.1 * i);
        v.hand.frame();
    }
    v.hand.settle();
    QVERIFY(v.isUntouched());
    QCOMPARE(v.changes(), 0);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetHands::twoFists_scaleTheModel()
{
    BareHanded v;
    const double before = v.scale();
    for (const Side side : {Side::Left, Side::Right})
        v.hand.put(side, {side == Side::Left ? -0.2 : 0.2, 1.3, -0.4});
    v.hand.frame();
    for (const Side side : {Side::Left, Side::Right})
        v.hand.set(side, "squeeze", 1);
    v.hand.frames(2);
    for (const Side side : {Side::Left, Side::Right})
        v.hand.put(side, {side == Side::Left ? -0.3 : 0.3, 1.3, -0.4}, -Vec3::UnitZ(), 8);
    v.hand.frames(12);
    for (const Side side : {Side::Left, Side::Right})
        v.hand.set(side, "squeeze", 0);
    v.hand.settle();
    QVERIFY(std::abs(v.scale() / before - 1.5) < 0.01);
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetHands::palm_opensTheToolsAndAPinchPressesThem()
{
    BareHanded v;
    v.pull();
    v.hand.showPalm(Side::Left);
    QVERIFY(v.hand.choose(v.tools(), vr::PanelCommand::Undo, [&] { return v.changes() == 0; }));
    QVERIFY(v.isUntouched());
    QVERIFY(v.hand.choose(v.tools(), core::Tool::Paint, [&] { return v.brush().tool == core::Tool::Paint; }));
    v.hand.showPalm(Side::Left); // closes them
    v.hand.stroke({0, 49, 0}, {10, 48, 0}, 4);
    QCOMPARE(v.changes(), 1);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetHands::slider_setsTheRadius()
{
    BareHanded v;
    v.hand.showPalm(Side::Left);
    for (const double doublings : {2.0, 5.0}) {
        const double wanted = vr::minRadius * std::exp2(doublings);
        QVERIFY(v.hand.choose(v.tools(), vr::Slide{vr::PanelSlider::Radius, doublings},
                              [&] { return std::abs(v.hand.seen().radius / wanted - 1) < 1e-6; }));
    }
    QVERIFY(v.isUntouched());
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetHands::oneHand_hasTheToolsToo()
{
    vr::HeadsetSettings settings;
    settings.wands.preset = vr::ButtonPreset::OneHand;
    BareHanded v(settings);
    v.pull();
    QCOMPARE(v.changes(), 1);
    v.hand.headset().step("{'left': {'on': false}}");
    v.hand.showPalm(Side::Right);
    v.hand.waitForPanels();
    QVERIFY(v.hand.seen().panels.size() == 1 && v.hand.seen().panels[0].kind == vr::PanelKind::Tools);
    QCOMPARE(v.hand.headset().complaints(), QString());
}

void TestHeadsetHands::wand_mayBeTakenUpAgain()
{
    BareHanded v;
    v.pull();
    v.hand.headset().step("{'profile': '/interaction_profiles/htc/vive_controller'}");
    v.hand.frames(4);
    v.hand.headset().step("{'right': {'pad': [-0.8, 0], 'pad_touch': true}}");
    v.hand.frame();
    v.hand.headset().step("{'right': {'pad_press': true}}");
    v.hand.frames(2);
    v.hand.headset().step("{'right': {'pad_press': false, 'pad_touch': false}}");
    v.hand.settle();
    QVERIFY(v.isUntouched()); // undone by the pad
    QCOMPARE(v.hand.headset().complaints(), QString());
}

FETTLE_TEST(TestHeadsetHands, app::OnScreen)
#include "tst_headset_hands.moc"
