#include "vr/input/bare_hand.h"

#include "vr/input/wand_mapping.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <numbers>

using core::Vec3;
using vr::Pose;
using vr::Side;
using vr::WandState;

namespace
{
constexpr double frameSeconds = 1.0 / 90;

/// A bare hand before the face of a user, played frame by frame.
class Hand
{
public:
    explicit Hand(Side side = Side::Right) : m_reader(side), m_side(side)
    {
        state.isHand = state.isActive = state.isTracked = true;
        state.grip.position = head.position + Vec3(0, -0.1, -0.4);
        turnPalm(180);
    }

    /// Turns the palm about the vertical: 0 degrees to the face, 180 degrees away from it.
    void turnPalm(double degrees)
    {
        const double toFace = m_side == Side::Left ? -90 : 90; // turns the palm's normal to +Z
        state.grip.rotation = Eigen::AngleAxisd((toFace + degrees) * std::numbers::pi / 180, Vec3::UnitY());
    }

    WandState frame()
    {
        state.side = state.squeeze >= (state.side ? 0.5 : 0.7);
        time += frameSeconds;
        return m_reader.read(state, head, time);
    }
    /// Plays frames for some seconds. Returns the last one.
    WandState frames(double seconds)
    {
        for (double passed = 0; passed < seconds; passed += frameSeconds)
            frame();
        return frame();
    }
    WandState with(double pinch, double fist)
    {
        state.trigger = pinch;
        state.squeeze = fist;
        return frame();
    }

    WandState state;
    Pose head{Eigen::Quaterniond::Identity(), {0, 1.6, 0}};
    double time = 1;

private:
    vr::BareHandReader m_reader;
    Side m_side;
};
} // namespace

class TestBareHand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPinch_isTheTrigger();
    void aFist_isTheSideButton();
    void aFist_doesNotPinch();
    void aPinch_doesNotGrab();
    void aPalmTurnedToTheFace_isTheMenuButton_data();
    void aPalmTurnedToTheFace_isTheMenuButton();
    void aPalm_countsOnlyIfItIsShown();
    void aPalm_countsOnce();
    void aStall_isNotATimeOfShowing();
    void aHandThatIsLost_holdsOnForAMoment();
    void aWand_isLeftAlone();
};

void TestBareHand::aPinch_isTheTrigger()
{
    Hand hand;
    for (const double pinch : {0.0, 0.3, 0.6, 1.0, 0.5}) {
        const WandState wand = hand.with(pinch, 0.1);
        QCOMPARE(wand.trigger, pinch);
        QVERIFY(!wand.side && !wand.menu);
    }
}

void TestBareHand::aFist_isTheSideButton()
{
    Hand hand;
    QVERIFY(!hand.with(0, 0.6).side);
    QVERIFY(hand.with(0, 0.8).side && hand.with(0, 0.6).side);
    QVERIFY(!hand.with(0, 0.4).side);
}

/// Checks that closing and opening a fist, which brings finger and thumb together on the way, gives no pinch.
void TestBareHand::aFist_doesNotPinch()
{
    Hand hand;
    for (int i = 0; i <= 20; ++i)
        QVERIFY(hand.with(0.05 * i, i < 2 ? 0.2 : 0.05 * i).trigger < vr::triggerPress);
    QVERIFY(hand.with(1, 1).side);
    for (int i = 20; i >= 0; --i)
        QVERIFY(hand.with(i < 5 ? 0.05 * i : 1.0, 0.05 * i).trigger < vr::triggerPress);
    QCOMPARE(hand.with(0.9, 0).trigger, 0.9); // the next pinch counts
}

void TestBareHand::aPinch_doesNotGrab()
{
    Hand hand;
    QCOMPARE(hand.with(0.8, 0.2).trigger, 0.8);
    const WandState curled = hand.with(0.8, 0.9);
    QVERIFY(!curled.side);
    QCOMPARE(curled.trigger, 0.8);
    QVERIFY(hand.with(0.2, 0.9).side);
}

void TestBareHand::aPalmTurnedToTheFace_isTheMenuButton_data()
{
    QTest::addColumn<Side>("side");
    QTest::newRow("left") << Side::Left;
    QTest::newRow("right") << Side::Right;
}

/// Checks the time and the hysteresis of the gesture for either hand, whose palms are mirror images.
void TestBareHand::aPalmTurnedToTheFace_isTheMenuButton()
{
    QFETCH(Side, side);
    Hand hand(side);
    QVERIFY(!hand.frames(1).menu);
    hand.turnPalm(0);
    QVERIFY(!hand.frames(vr::palmSeconds / 2).menu);
    QVERIFY(hand.frames(vr::palmSeconds).menu);
    hand.turnPalm((vr::palmAngle + vr::palmAwayAngle) / 2);
    QVERIFY(hand.frames(1).menu);
    hand.turnPalm(vr::palmAwayAngle + 10);
    QVERIFY(!hand.frame().menu);
    hand.turnPalm((vr::palmAngle + vr::palmAwayAngle) / 2);
    QVERIFY(!hand.frames(1).menu);
}

void TestBareHand::aPalm_countsOnlyIfItIsShown()
{
    Hand pinching, closed, aside;
    for (Hand* hand : {&pinching, &closed, &aside})
        hand->turnPalm(0);
    pinching.state.trigger = 0.6;
    closed.state.squeeze = 0.5;
    aside.head.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY());
    for (Hand* hand : {&pinching, &closed, &aside})
        QVERIFY(!hand->frames(1).menu);
}

/// Checks that a palm that counts is one press until it is turned away, whatever hand and eyes do meanwhile, and that a
/// hand that comes back after a long time presses again.
void TestBareHand::aPalm_countsOnce()
{
    Hand hand;
    hand.turnPalm(0);
    QVERIFY(hand.frames(1).menu);
    QVERIFY(hand.with(0.9, 0.1).menu && hand.with(0.9, 0.9).menu && hand.with(0, 0).menu);
    hand.head.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY());
    QVERIFY(hand.frames(1).menu);
    hand.head.rotation = Eigen::Quaterniond::Identity();
    QVERIFY(hand.frames(1).menu);
    for (bool WandState::*lost : {&WandState::isTracked, &WandState::isActive}) {
        hand.state.*lost = false;
        hand.frames(0.8 * vr::maxPalmGap);
        hand.state.*lost = true;
        QVERIFY(hand.frame().menu);
        hand.state.*lost = false;
        hand.frames(1.5 * vr::maxPalmGap);
        hand.state.*lost = true;
        QVERIFY(!hand.frame().menu);
        QVERIFY(hand.frames(1.5 * vr::palmSeconds).menu);
    }
}

void TestBareHand::aStall_isNotATimeOfShowing()
{
    Hand hand;
    hand.frames(0.1);
    hand.turnPalm(0);
    hand.time += 3;
    QVERIFY(!hand.frame().menu);
}

/// Checks that a hand without gestures keeps those that it had, untracked, for as long as a wand may be lost, and that
/// it is inactive after that and begins anew when it comes back.
void TestBareHand::aHandThatIsLost_holdsOnForAMoment()
{
    Hand hand;
    hand.with(0.8, 0.1);
    const auto lose = [&](bool isLost) {
        hand.state.isActive = hand.state.isTracked = !isLost;
        hand.state.trigger = hand.state.squeeze = 0;
    };
    lose(true);
    const WandState lost = hand.frames(0.5 * vr::maxTrackingGap);
    QVERIFY(lost.isActive && !lost.isTracked && lost.isHand);
    QCOMPARE(lost.trigger, 0.8);
    lose(false);
    QCOMPARE(hand.with(0.7, 0.1).trigger, 0.7);
    QVERIFY(!hand.with(0.7, 0.9).side); // the same pinch still

    lose(false);
    hand.frame();
    QVERIFY(hand.with(0, 0.9).side);
    lose(true);
    const WandState gone = hand.frames(1.5 * vr::maxTrackingGap);
    QVERIFY(!gone.isActive && !gone.isTracked && gone.trigger == 0 && !gone.side);
    lose(false);
    QCOMPARE(hand.with(0.9, 0).trigger, 0.9); // the fist is forgotten
}

void TestBareHand::aWand_isLeftAlone()
{
    Hand hand;
    hand.state.isHand = false;
    hand.turnPalm(0);
    hand.state.trigger = hand.state.squeeze = 1;
    const WandState wand = hand.frames(1);
    QVERIFY(wand.side && !wand.menu);
    QCOMPARE(wand.trigger, 1.0);
}

FETTLE_TEST(TestBareHand)
#include "tst_bare_hand.moc"
