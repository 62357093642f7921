#include "vr/input/wand_gestures.h"

#include "tests/support/test_main.h"
#include "tests/vr/input/hand_motion.h"

#include <QTest>

#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <vector>

using Eigen::Vector2d;
using vr::GestureReader;
using vr::Sector;
using vr::WandGestures;
using vr::WandState;

namespace
{
constexpr Sector allSectors[] = {Sector::Left, Sector::Right, Sector::Top, Sector::Bottom};

Vector2d at(double degrees, double radius)
{
    const double angle = degrees * std::numbers::pi / 180;
    return radius * Vector2d(std::cos(angle), std::sin(angle));
}

Vector2d middleOf(Sector sector)
{
    switch (sector) {
    case Sector::Left:
        return {-0.8, 0};
    case Sector::Right:
        return {0.8, 0};
    case Sector::Top:
        return {0, 0.8};
    case Sector::Bottom:
        return {0, -0.8};
    }
    return {};
}

/// Returns a reader that has read one frame of a wand with nothing pressed.
GestureReader awake(bool isStick = false)
{
    GestureReader reader;
    reader.read(isStick ? pushing({0, 0}) : restingWand(), 0);
    return reader;
}

/// Reads a sequence of states, one per frame of 1/90 second.
std::vector<WandGestures> readAll(GestureReader& reader, const std::vector<WandState>& wands)
{
    std::vector<WandGestures> all;
    all.reserve(wands.size());
    for (const WandState& wand : wands)
        all.push_back(reader.read(wand, frameLength));
    return all;
}

std::vector<WandGestures> readAll(const std::vector<WandState>& wands)
{
    GestureReader reader = awake(wands[0].isStick);
    return readAll(reader, wands);
}

/// Returns the sector of a press at a place where the thumb has just touched down.
std::optional<Sector> pressAt(const Vector2d& pad)
{
    return readAll({pressing(pad)})[0].pad.pressed;
}

Vector2d slid(const std::vector<WandGestures>& all)
{
    Vector2d sum = Vector2d::Zero();
    for (const WandGestures& gestures : all)
        sum += gestures.pad.slide;
    return sum;
}

/// Counts of the gestures in a movement.
struct Tally
{
    int pulls = 0, releases = 0, menus = 0, taps = 0, menuHolds = 0, squeezes = 0, sideHolds = 0;
    std::map<Sector, int> presses;
    Vector2d slide = Vector2d::Zero();

    friend bool operator==(const Tally& a, const Tally& b)
    {
        return a.pulls == b.pulls && a.releases == b.releases && a.menus == b.menus && a.taps == b.taps &&
               a.menuHolds == b.menuHolds && a.squeezes == b.squeezes && a.sideHolds == b.sideHolds &&
               a.presses == b.presses && (a.slide - b.slide).norm() < 1e-9;
    }
};

void count(const WandGestures& gestures, Tally& tally)
{
    tally.pulls += gestures.trigger.wentDown;
    tally.releases += gestures.trigger.wentUp;
    tally.menus += gestures.menu.wentDown;
    tally.taps += gestures.menu.wasTapped;
    tally.menuHolds += gestures.menu.holdDone;
    tally.squeezes += gestures.side.wentDown;
    tally.sideHolds += gestures.side.holdDone;
    if (gestures.pad.pressed)
        ++tally.presses[*gestures.pad.pressed];
    tally.slide += gestures.pad.slide;
}

Tally tallyOf(const std::function<WandState(double)>& motion, double seconds, double rate)
{
    Tally tally;
    GestureReader reader;
    vr::FrameClock clock;
    for (const double time : frameTimes(seconds, rate))
        count(reader.read(motion(time), clock.step(time)), tally);
    return tally;
}

/// Returns a state that changes over time, with every kind of gesture. Nothing is shorter than two frames at 5 Hz.
WandState everything(double time)
{
    WandState wand = restingWand();
    wand.trigger = isWithin(time, 1, 2) ? 0.9 : isWithin(time, 2, 2.5) ? 0.5 : 0.1;
    wand.menu = isWithin(time, 3, 3.5) || isWithin(time, 4, 5.5);
    wand.side = isWithin(time, 6, 6.5) || isWithin(time, 7, 8.5);
    wand.padPressed = isWithin(time, 9.5, 10) || isWithin(time, 10.5, 11);
    wand.padTouched = isWithin(time, 9, 11.5) || isWithin(time, 12, 15);
    if (wand.padTouched)
        wand.pad = time < 11.5 ? ThumbWay{10, 10.5, {-0.7, 0.05}, {-0.68, 0}}.at(time)
                               : ThumbWay{12.5, 14.5, {0.3, -0.7}, {0.2, 0.6}}.at(time);
    return wand;
}

WandState stickTwice(double time)
{
    WandState wand = pushing({0, 0});
    if (isWithin(time, 1, 1.5))
        wand.pad = {0.1, -0.9};
    if (isWithin(time, 2, 2.5) || isWithin(time, 3, 3.5))
        wand.pad = {1, 0};
    return wand;
}
} // namespace

class TestWandGestures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theTriggerHasHysteresis()
    {
        const std::vector<WandGestures> read = readAll({pulling(0.54), pulling(0.56), pulling(0.5), pulling(0.46),
                                                        pulling(0.44), pulling(0.5), pulling(0.54), pulling(0.56)});
        const bool down[] = {false, true, true, true, false, false, false, true};
        for (std::size_t i = 0; i < read.size(); ++i) {
            QCOMPARE(read[i].trigger.isDown, down[i]);
            QCOMPARE(read[i].trigger.wentDown, i == 1 || i == 7);
            QCOMPARE(read[i].trigger.wentUp, i == 4);
            QCOMPARE(read[i].pressure > 0, down[i]);
        }
    }

    void pressureFollowsTheTriggerAndIsNeverNothing()
    {
        GestureReader reader = awake();
        reader.read(pulling(1), frameLength);
        QCOMPARE(reader.read(pulling(1), frameLength).pressure, 1.0);
        double before = 1;
        for (int percent = 99; percent >= 45; --percent) {
            const double pressure = reader.read(pulling(percent / 100.0), frameLength).pressure;
            QVERIFY(pressure >= vr::minPressure && pressure <= before);
            QVERIFY(pressure < before || pressure == vr::minPressure);
            before = pressure;
        }
        QCOMPARE(before, vr::minPressure);
    }

    void aPressIsOfTheSectorUnderTheThumb()
    {
        for (int degrees = 0; degrees < 360; ++degrees) {
            if (degrees % 90 == 45)
                continue;
            const Sector expected = degrees < 45 || degrees > 315 ? Sector::Right
                                    : degrees < 135               ? Sector::Top
                                    : degrees < 225               ? Sector::Left
                                                                  : Sector::Bottom;
            for (const double radius : {0.4, 0.7, 1.0})
                QCOMPARE(pressAt(at(degrees, radius)), std::optional(expected));
            for (const double radius : {0.0, 0.1, 0.34})
                QVERIFY(!pressAt(at(degrees, radius)));
        }
    }

    /// Checks that a press keeps its sector wherever the thumb moves. A press that begins in the dead centre keeps
    /// having none.
    void aPressStaysWhatItWasWhereverTheThumbGoes()
    {
        for (const Sector sector : allSectors) {
            const Vector2d from = middleOf(sector);
            const auto read = readAll({touching(from), pressing(from), pressing({0.05, 0.02}), pressing(-from),
                                       touching(-from), pressing(-from)});
            QVERIFY(!read[0].pad.pressed && !read[0].pad.held);
            QCOMPARE(read[1].pad.pressed, std::optional(sector));
            for (const int i : {1, 2, 3})
                QCOMPARE(read[std::size_t(i)].pad.held, std::optional(sector));
            QVERIFY(!read[2].pad.pressed && !read[3].pad.pressed && !read[4].pad.pressed && !read[4].pad.held);
            QVERIFY(read[5].pad.pressed && read[5].pad.pressed != sector);
        }
        const auto centre = readAll(
            {pressing({0.1, 0}), pressing({0.5, 0}), pressing({0.9, 0}), touching({0.9, 0}), pressing({0.9, 0})});
        for (const int i : {0, 1, 2, 3})
            QVERIFY(!centre[std::size_t(i)].pad.pressed && !centre[std::size_t(i)].pad.held);
        QCOMPARE(centre[4].pad.pressed, std::optional(Sector::Right));
    }

    /// Checks that a thumb trembling at the border of two sectors stays in its sector.
    void edgesHaveHysteresis()
    {
        GestureReader reader = awake();
        reader.read(touching(at(0, 0.8)), frameLength);
        for (const double degrees : {44.0, 47.0, 44.0, 52.0, 46.0})
            QCOMPARE(reader.read(touching(at(degrees, 0.8)), frameLength).pad.over, std::optional(Sector::Right));
        QCOMPARE(reader.read(touching(at(54, 0.8)), frameLength).pad.over, std::optional(Sector::Top));
        for (const double degrees : {46.0, 43.0, 46.0, 38.0})
            QCOMPARE(reader.read(touching(at(degrees, 0.8)), frameLength).pad.over, std::optional(Sector::Top));
        QCOMPARE(reader.read(touching(at(36, 0.8)), frameLength).pad.over, std::optional(Sector::Right));

        for (const double radius : {0.34, 0.36, 0.3, 0.26})
            QCOMPARE(reader.read(touching(at(0, radius)), frameLength).pad.over, std::optional(Sector::Right));
        for (const double radius : {0.24, 0.3, 0.34})
            QVERIFY(!reader.read(touching(at(0, radius)), frameLength).pad.over);
        QVERIFY(reader.read(touching(at(0, 0.36)), frameLength).pad.over);
        QVERIFY(!reader.read(restingWand(), frameLength).pad.over);
    }

    void aSlideIsTheWayBeyondTheThreshold()
    {
        for (const Vector2d& to :
             {Vector2d(0.3, 0.7), Vector2d(0.3, -0.9), Vector2d(-0.6, -0.1), Vector2d(0.9, -0.1)}) {
            const Vector2d from(0.3, -0.1), way = to - from;
            std::vector<WandState> wands;
            for (int i = 0; i <= 30; ++i)
                wands.push_back(touching(from + i / 30.0 * way));
            const Vector2d sum = slid(readAll(wands));
            QVERIFY((sum - way.normalized() * (way.norm() - vr::slideThreshold)).norm() < 1e-12);
        }
    }

    void aThumbThatRestsSlidesNothing()
    {
        std::vector<WandState> wands;
        for (int i = 0; i < 200; ++i)
            wands.push_back(touching(Vector2d(0.4, 0.4) + at(37 * i, 0.055)));
        QCOMPARE(slid(readAll(wands)), Vector2d(0, 0));
    }

    void aSlideKeepsItsAxis()
    {
        const Vector2d sum =
            slid(readAll({touching({0, -0.5}), touching({0.02, -0.3}), touching({0.5, -0.1}), touching({0.9, 0.1})}));
        QCOMPARE(sum.x(), 0.0);
        QVERIFY(std::abs(sum.y() - (0.6 - vr::slideThreshold)) < 1e-12);
    }

    /// Checks that touching down or lifting is not a slide, nor the position (0, 0) that some runtimes report for one
    /// frame then.
    void whereAThumbComesDownOrLiftsIsNoSlide()
    {
        WandState lifted = restingWand();
        lifted.pad = {0.9, 0.9};
        const WandState zero = touching({0, 0});
        const auto thumbs =
            readAll({restingWand(), touching({0.9, 0.9}), lifted, touching({-0.9, -0.9}), restingWand(), zero,
                     touching({0.9, 0.9}), zero, restingWand(), zero, touching({-0.9, 0.3}), zero, restingWand()});
        for (const WandGestures& gestures : thumbs)
            QCOMPARE(gestures.pad.slide, Vector2d(0, 0));
        const Vector2d through =
            slid(readAll({touching({0, -0.4}), touching({0, -0.2}), zero, touching({0, 0.2}), touching({0, 0.4})}));
        QVERIFY((through - Vector2d(0, 0.8 - vr::slideThreshold)).norm() < 1e-12);
        const Vector2d toRest = slid(readAll({touching({0, -0.4}), touching({0, -0.2}), zero, zero}));
        QVERIFY((toRest - Vector2d(0, 0.4 - vr::slideThreshold)).norm() < 1e-12);
    }

    void aPressEndsTheSlide()
    {
        const auto read = readAll({touching({0, -0.8}), touching({0, -0.4}), pressing({0, 0}), pressing({0, 0.8}),
                                   touching({0, 0.8}), touching({0, 0.9}), touching({0, 0.6})});
        QVERIFY(read[1].pad.slide.y() > 0);
        for (const int i : {3, 4, 5})
            QCOMPARE(read[std::size_t(i)].pad.slide, Vector2d(0, 0));
        QVERIFY(read[6].pad.slide.y() < 0);
    }

    /// Checks that a slide is undone if it ends in a press, but not if it took longer than maxSlideBeforePress.
    void aThumbOnItsWayToPressSlidesBack()
    {
        for (const double rate : frameRates)
            for (const double seconds : {0.4, 1.0}) {
                const ThumbWay way{1, 1 + seconds, {0.1, 0}, {0.7, 0.1}};
                const Tally tally = tallyOf(
                    [&](double time) { return time < 1 + seconds ? touching(way.at(time)) : pressing(way.at(time)); },
                    3, rate);
                QVERIFY(tally.presses == (std::map<Sector, int>{{Sector::Right, 1}}));
                const double last = std::floor((1 + seconds) * rate - 1e-9) / rate; // the last frame before the press
                const double slid = seconds < vr::maxSlideBeforePress ? 0 : way.at(last).x() - 0.1 - vr::slideThreshold;
                QVERIFY((tally.slide - Vector2d(slid, 0)).norm() < 1e-9);
            }
    }

    /// Checks that only the slide that leads to the press is undone, and not a slide before the thumb lifted.
    void onlyTheWayToThePressIsSlidBack()
    {
        GestureReader reader = awake();
        std::vector<WandState> wands;
        for (int i = 0; i <= 90; ++i)
            wands.push_back(touching({0.05, 0.6 - i / 90.0}));
        wands.push_back(restingWand());
        for (int i = 0; i <= 30; ++i)
            wands.push_back(touching({0.05 + i / 40.0, 0.1}));
        wands.push_back(pressing({0.8, 0.1}));
        const Vector2d sum = slid(readAll(reader, wands));
        QVERIFY((sum - Vector2d(0, vr::slideThreshold - 1)).norm() < 1e-9);
    }

    void aHoldTakesItsTimeIsDoneOnceAndIsCancelledByLettingGo()
    {
        GestureReader reader = awake();
        double progress = 0;
        int done = 0;
        for (int i = 0; i < 200; ++i) {
            const vr::ButtonGestures side = reader.read(squeezing(), frameLength).side;
            QVERIFY(side.isDown && side.hold >= progress && side.hold <= 1);
            QCOMPARE(side.wentDown, i == 0);
            QCOMPARE(side.holdDone, i == 72); // 0.8 s
            QCOMPARE(side.hold == 1, i >= 72);
            done += side.holdDone;
            progress = side.hold;
        }
        QCOMPARE(done, 1);
        const vr::ButtonGestures after = reader.read(restingWand(), frameLength).side;
        QVERIFY(after.wentUp && !after.wasTapped && after.hold == 0);

        for (int i = 0; i < 70; ++i)
            QVERIFY(!reader.read(squeezing(), frameLength).side.holdDone);
        QVERIFY(reader.read(restingWand(), frameLength).side.wasTapped);
        for (int i = 0; i < 70; ++i)
            QVERIFY(!reader.read(squeezing(), frameLength).side.holdDone);
    }

    /// Checks that buttons at the wand's sides do not start a long press while the trigger is pulled, because a firm
    /// grip presses them by accident.
    void noHoldRunsWhileTheTriggerIsDown()
    {
        WandState buttons = squeezing();
        buttons.menu = true;
        WandState both = buttons;
        both.trigger = 1;
        for (const WandState& first : {pulling(1), buttons}) {
            GestureReader reader = awake();
            for (int i = 0; i < 40; ++i)
                reader.read(first, frameLength);
            for (const WandState& then : {both, buttons})
                for (int i = 0; i < 100; ++i) {
                    const WandGestures gestures = reader.read(then, frameLength);
                    QVERIFY(gestures.side.hold == 0 && gestures.menu.hold == 0);
                }
            reader.read(restingWand(), frameLength);
            for (int i = 0; i < 100; ++i)
                reader.read(buttons, frameLength);
            const WandGestures gestures = reader.read(buttons, frameLength);
            QVERIFY(gestures.side.hold == 1 && gestures.menu.hold == 1);
        }
    }

    void aStallIsNoHold()
    {
        GestureReader reader;
        vr::FrameClock clock;
        reader.read(restingWand(), clock.step(10));
        reader.read(squeezing(), clock.step(10.1));
        const vr::ButtonGestures side = reader.read(squeezing(), clock.step(70)).side;
        QVERIFY(!side.holdDone && side.hold < 0.5);
        QCOMPARE(clock.step(60), 0.0);
        QCOMPARE(clock.step(60.2), 60.2 - 60);
    }

    void aStickIsPressedByPushingIt()
    {
        for (const Sector sector : allSectors) {
            const Vector2d to = middleOf(sector) / 0.8;
            const auto read = readAll({pushing(0.69 * to), pushing(0.71 * to), pushing(0.6 * to), pushing(0.51 * to),
                                       pushing(0.49 * to), pushing(0.69 * to), pushing(0.71 * to)});
            for (std::size_t i = 0; i < read.size(); ++i) {
                QCOMPARE(read[i].pad.pressed.has_value(), i == 1 || i == 6);
                QCOMPARE(read[i].pad.held, (i >= 1 && i <= 3) || i == 6 ? std::optional(sector) : std::nullopt);
                QCOMPARE(read[i].pad.slide, Vector2d(0, 0));
            }
        }
    }

    void aClickedStickSlidesAtARate()
    {
        for (const double rate : frameRates) {
            GestureReader reader = awake(true);
            double sum = 0, before = 0;
            for (const double time : frameTimes(3, rate)) {
                WandState wand = pushing(ThumbWay{1, 2, {0, 0}, {0, 1}}.at(time));
                wand.padPressed = true;
                const WandGestures gestures = reader.read(wand, time - before);
                QVERIFY(!gestures.pad.pressed && gestures.pad.slide.x() == 0);
                sum += gestures.pad.slide.y();
                before = time;
            }
            // mean slide speed while the stick tilts, as a share of stickSlide
            const double ramp = (1 - vr::stickDeadZone) / 2;
            QVERIFY(std::abs(sum - vr::stickSlide * (ramp + 1)) < 0.25 / rate);

            QVERIFY(!reader.read(pushing({0, 1}), 1 / rate).pad.pressed); // not clicked any more, but still pushed
            reader.read(pushing({0, 0}), 1 / rate);
            QVERIFY(reader.read(pushing({0, 1}), 1 / rate).pad.pressed);
        }
        WandState down = pushing({0, -1});
        down.padPressed = true;
        QVERIFY(slid(readAll({down, down, down})).y() < 0);
        WandState resting = pushing({0.1, 0.15});
        resting.padPressed = true;
        QCOMPARE(slid(readAll({resting, resting, resting})), Vector2d(0, 0));
    }

    void aWandThatIsLostLetsEverythingGo()
    {
        WandState busy = pressing({-0.8, 0});
        busy.trigger = 1;
        busy.menu = busy.side = true;
        GestureReader reader = awake();
        reader.read(busy, frameLength);
        QVERIFY(reader.read(busy, frameLength).pad.held);
        for (int i = 0; i < 3; ++i) {
            const WandGestures lost = reader.read(WandState(), frameLength);
            for (const vr::ButtonGestures* button : {&lost.trigger, &lost.menu, &lost.side}) {
                QVERIFY(!button->isDown && !button->wasTapped && button->hold == 0);
                QCOMPARE(button->wentUp, i == 0);
            }
            QVERIFY(lost.pressure == 0 && !lost.pad.held && !lost.pad.over && lost.pad.slide == Vector2d(0, 0));
        }
        for (int i = 0; i < 100; ++i) {
            const WandGestures back = reader.read(busy, frameLength);
            QVERIFY(!back.trigger.isDown && !back.menu.isDown && !back.side.isDown && !back.pad.pressed &&
                    !back.pad.held);
        }
        reader.read(restingWand(), frameLength);
        const WandGestures again = reader.read(busy, frameLength);
        QVERIFY(again.trigger.wentDown && again.menu.wentDown && again.side.wentDown && again.pad.pressed);
    }

    void aStickThatComesBackPushedMustRestFirst()
    {
        GestureReader reader = awake(true);
        reader.read(WandState(), frameLength);
        for (int i = 0; i < 5; ++i)
            QVERIFY(!reader.read(pushing({1, 0}), frameLength).pad.pressed);
        reader.read(pushing({0, 0}), frameLength);
        QVERIFY(reader.read(pushing({1, 0}), frameLength).pad.pressed);
    }

    void theSameMotionIsTheSameAtAnyFrameRate()
    {
        Tally all;
        all.pulls = all.releases = all.taps = all.menuHolds = all.sideHolds = 1;
        all.menus = all.squeezes = 2;
        all.presses = {{Sector::Left, 2}};
        all.slide = {0, 1.3 - vr::slideThreshold};
        Tally stick;
        stick.presses = {{Sector::Bottom, 1}, {Sector::Right, 2}};
        for (const double rate : frameRates) {
            QVERIFY(tallyOf(everything, 16, rate) == all);
            QVERIFY(tallyOf(stickTwice, 4, rate) == stick);
        }
    }

    /// Feeds random states and checks consistency: a button that went down goes up before it goes down again, a sector
    /// is held from its press on, and there are no slides while pressing.
    void atRandomItAllGoesTogether()
    {
        constexpr unsigned seed = 20261122;
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0, 1), pad(-1, 1);
        GestureReader reader;
        WandState wand;
        WandGestures before;
        for (int i = 0; i < 200000; ++i) {
            const double change = share(random);
            if (change < 0.02)
                wand.isActive = !wand.isActive;
            wand.isStick = i % 20000 > 10000;
            wand.trigger = change < 0.3 ? share(random) : wand.trigger;
            wand.padTouched = change < 0.1 ? !wand.padTouched : wand.padTouched;
            wand.padPressed = share(random) < 0.1 ? !wand.padPressed : wand.padPressed;
            wand.side = share(random) < 0.05 ? !wand.side : wand.side;
            wand.menu = share(random) < 0.05 ? !wand.menu : wand.menu;
            if (share(random) < 0.5)
                wand.pad = share(random) < 0.2 ? Vector2d(0, 0) : Vector2d(pad(random), pad(random));
            const WandGestures now = reader.read(wand, 0.2 * share(random));
            const auto isConsistent = [](const vr::ButtonGestures& was, const vr::ButtonGestures& is) {
                return is.wentDown == (is.isDown && !was.isDown) && is.wentUp == (was.isDown && !is.isDown) &&
                       is.hold >= 0 && is.hold <= 1 && (!is.holdDone || is.hold == 1) && (!is.wasTapped || is.wentUp);
            };
            const bool sectorStays =
                now.pad.pressed ? now.pad.held == now.pad.pressed : !now.pad.held || now.pad.held == before.pad.held;
            const bool slides = now.pad.slide != Vector2d(0, 0);
            QVERIFY2(isConsistent(before.trigger, now.trigger) && isConsistent(before.menu, now.menu) &&
                         isConsistent(before.side, now.side) && sectorStays &&
                         !(slides && now.pad.held && !now.pad.pressed) && (now.pressure > 0) == now.trigger.isDown &&
                         (wand.isActive ||
                          (!now.trigger.isDown && !now.menu.isDown && !now.side.isDown && !now.pad.held && !slides)),
                     qPrintable(QStringLiteral("seed %1, frame %2").arg(seed).arg(i)));
            before = now;
        }
    }
};

FETTLE_TEST(TestWandGestures, QCoreApplication)
#include "tst_wand_gestures.moc"
