#include "vr/frame/frame_timing.h"

#include <QTest>

#include <atomic>
#include <chrono>
#include <thread>

using vr::FrameCost;
using vr::FrameCosts;
using vr::FramePhase;

namespace
{
constexpr std::int64_t period = 11'111'111; ///< 90 Hz

FrameCost numbered(std::uint64_t number)
{
    FrameCost cost;
    cost.workMs = static_cast<double>(number);
    cost.lost = number % 3 == 0 ? 2 : 0;
    return cost;
}

/// Until this thread has had that much of a core.
void work(double ms)
{
    for (const double start = vr::threadMilliseconds(); vr::threadMilliseconds() - start < ms;) {
    }
}
} // namespace

class TestFrameCosts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLastAreKept();
    void nothingIsMissedWhileSomebodyReads();
    void skippedPeriodsAreLost();
    void framesThatAreNotShownAreNotLost();
    void phasesAddUp();
    void sleepCostsNothing();
};

void TestFrameCosts::theLastAreKept()
{
    FrameCosts costs;
    QVERIFY(costs.last().empty());
    const std::uint64_t count = FrameCosts::capacity + 100;
    for (std::uint64_t i = 0; i < count; ++i)
        costs.add(numbered(i));
    const auto last = costs.last();
    QCOMPARE(last.size(), FrameCosts::capacity);
    for (std::size_t i = 0; i < last.size(); ++i)
        QCOMPARE(last[i].workMs, static_cast<double>(100 + i));
    QCOMPARE(costs.frames(), count);
    QCOMPARE(costs.lostFrames(), 2 * ((count + 2) / 3));
}

/// The writer never waits, so what it cannot put in at once it puts in with the next; the one after the reader's end brings all.
void TestFrameCosts::nothingIsMissedWhileSomebodyReads()
{
    FrameCosts costs;
    std::atomic<bool> isOver = false;
    std::thread reader([&] {
        while (!isOver) {
            const auto last = costs.last();
            for (std::size_t i = 1; i < last.size(); ++i)
                if (last[i].workMs != last[i - 1].workMs + 1)
                    qFatal("out of order");
        }
    });
    constexpr std::uint64_t count = 20'000;
    for (std::uint64_t i = 0; i < count; ++i)
        costs.add(numbered(i));
    isOver = true;
    reader.join();
    costs.add(numbered(count));
    QCOMPARE(costs.frames(), count + 1);
    QCOMPARE(costs.last().back().workMs, static_cast<double>(count));
}

void TestFrameCosts::skippedPeriodsAreLost()
{
    vr::LostFrames lost;
    std::int64_t now = 5'000'000'000;
    QCOMPARE(lost.count(now, period, true), 0U);
    QCOMPARE(lost.count(now += period, period, true), 0U);
    QCOMPARE(lost.count(now += period + period / 5, period, true), 0U); // runtimes are not exact
    QCOMPARE(lost.count(now += 2 * period, period, true), 1U);
    QCOMPARE(lost.count(now += 10 * period - period / 5, period, true), 9U);
    QCOMPARE(lost.count(now, period, true), 0U);
    QCOMPARE(lost.count(now + period, 0, true), 0U); // a runtime that does not know its period
}

void TestFrameCosts::framesThatAreNotShownAreNotLost()
{
    vr::LostFrames lost;
    std::int64_t now = 5'000'000'000;
    QCOMPARE(lost.count(now, period, true), 0U);
    QCOMPARE(lost.count(now += 7 * period, period, false), 0U);
    QCOMPARE(lost.count(now += 7 * period, period, true), 0U);
    QCOMPARE(lost.count(now += 3 * period, period, true), 2U);
}

void TestFrameCosts::phasesAddUp()
{
    const double start = vr::threadMilliseconds();
    vr::PhaseClock clock;
    work(2);
    clock.ends(FramePhase::Input);
    work(4);
    clock.ends(FramePhase::Draw);
    work(2);
    clock.ends(FramePhase::Input);
    const double all = vr::threadMilliseconds() - start;
    FrameCost cost = clock.cost();
    QVERIFY(cost.of(FramePhase::Input) >= 4);
    QVERIFY(cost.of(FramePhase::Draw) >= 4);
    QVERIFY(cost.of(FramePhase::Input) + cost.of(FramePhase::Draw) <= all);
    QCOMPARE(cost.of(FramePhase::Wait), 0.0);
    cost.drawCallMs = 3;
    QVERIFY(cost.ownMs() >= 5 && cost.ownMs() <= all - 3);

    clock.startOver();
    QCOMPARE(clock.cost().of(FramePhase::Input), 0.0);
}

void TestFrameCosts::sleepCostsNothing()
{
    const double start = vr::threadMilliseconds();
    vr::PhaseClock clock;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    clock.ends(FramePhase::Wait);
    QVERIFY(clock.cost().of(FramePhase::Wait) <= vr::threadMilliseconds() - start);
    QVERIFY(clock.cost().of(FramePhase::Wait) < 25);
}

QTEST_GUILESS_MAIN(TestFrameCosts)
#include "tst_frame_timing.moc"
