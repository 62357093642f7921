#include "vr/frame/frame_timing.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <atomic>
#include <chrono>
#include <thread>

using vr::FramePhase;
using vr::FrameTiming;
using vr::FrameTimings;

namespace
{
constexpr std::int64_t period = 11'111'111; ///< nanoseconds, for 90 Hz

FrameTiming numbered(std::uint64_t number)
{
    FrameTiming timing;
    timing.workMs = static_cast<double>(number);
    timing.dropped = number % 3 == 0 ? 2 : 0;
    return timing;
}

/// Keeps the CPU busy until this thread has used `ms` milliseconds of CPU time.
void work(double ms)
{
    for (const double start = core::threadCpuMs(); core::threadCpuMs() - start < ms;) {
    }
}
} // namespace

class TestFrameTiming : public QObject
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

void TestFrameTiming::theLastAreKept()
{
    FrameTimings timings;
    QVERIFY(timings.recent().empty());
    const std::uint64_t count = FrameTimings::capacity + 100;
    for (std::uint64_t i = 0; i < count; ++i)
        timings.add(numbered(i));
    const auto last = timings.recent();
    QCOMPARE(last.size(), FrameTimings::capacity);
    for (std::size_t i = 0; i < last.size(); ++i)
        QCOMPARE(last[i].workMs, static_cast<double>(100 + i));
    QCOMPARE(timings.frames(), count);
    QCOMPARE(timings.droppedFrames(), 2 * ((count + 2) / 3));
}

/// Reads timings while another thread writes them. The writer never waits: entries that it cannot store at once are
/// stored with the next one, so the first entry after the reader has ended completes the list.
void TestFrameTiming::nothingIsMissedWhileSomebodyReads()
{
    FrameTimings timings;
    std::atomic<bool> isOver = false;
    std::thread reader([&] {
        while (!isOver) {
            const auto last = timings.recent();
            for (std::size_t i = 1; i < last.size(); ++i)
                if (last[i].workMs != last[i - 1].workMs + 1)
                    qFatal("out of order");
        }
    });
    constexpr std::uint64_t count = 20'000;
    for (std::uint64_t i = 0; i < count; ++i)
        timings.add(numbered(i));
    isOver = true;
    reader.join();
    timings.add(numbered(count));
    QCOMPARE(timings.frames(), count + 1);
    QCOMPARE(timings.recent().back().workMs, static_cast<double>(count));
}

void TestFrameTiming::skippedPeriodsAreLost()
{
    vr::DroppedFrameCounter lost;
    std::int64_t now = 5'000'000'000;
    QCOMPARE(lost.count(now, period, true), 0U);
    QCOMPARE(lost.count(now += period, period, true), 0U);
    QCOMPARE(lost.count(now += period + period / 5, period, true), 0U); // a runtime's times are not exact
    QCOMPARE(lost.count(now += 2 * period, period, true), 1U);
    QCOMPARE(lost.count(now += 10 * period - period / 5, period, true), 9U);
    QCOMPARE(lost.count(now, period, true), 0U);
    QCOMPARE(lost.count(now + period, 0, true), 0U); // a runtime that does not know its period
}

void TestFrameTiming::framesThatAreNotShownAreNotLost()
{
    vr::DroppedFrameCounter lost;
    std::int64_t now = 5'000'000'000;
    QCOMPARE(lost.count(now, period, true), 0U);
    QCOMPARE(lost.count(now += 7 * period, period, false), 0U);
    QCOMPARE(lost.count(now += 7 * period, period, true), 0U);
    QCOMPARE(lost.count(now += 3 * period, period, true), 2U);
}

void TestFrameTiming::phasesAddUp()
{
    const double start = core::threadCpuMs();
    vr::PhaseTimer clock;
    work(2);
    clock.endPhase(FramePhase::Input);
    work(4);
    clock.endPhase(FramePhase::Draw);
    work(2);
    clock.endPhase(FramePhase::Input);
    const double all = core::threadCpuMs() - start;
    FrameTiming timing = clock.timing();
    QVERIFY(timing.of(FramePhase::Input) >= 4);
    QVERIFY(timing.of(FramePhase::Draw) >= 4);
    QVERIFY(timing.of(FramePhase::Input) + timing.of(FramePhase::Draw) <= all);
    QCOMPARE(timing.of(FramePhase::Wait), 0.0);
    timing.drawCallMs = 3;
    QVERIFY(timing.ownMs() >= 5 && timing.ownMs() <= all - 3);

    clock.reset();
    QCOMPARE(clock.timing().of(FramePhase::Input), 0.0);
}

void TestFrameTiming::sleepCostsNothing()
{
    const double start = core::threadCpuMs();
    vr::PhaseTimer clock;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    clock.endPhase(FramePhase::Wait);
    QVERIFY(clock.timing().of(FramePhase::Wait) <= core::threadCpuMs() - start);
    QVERIFY(clock.timing().of(FramePhase::Wait) < 25);
}

FETTLE_TEST(TestFrameTiming, QCoreApplication)
#include "tst_frame_timing.moc"
