#include "vr/panels/panel_content.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <numeric>

using vr::FramePhase;
using vr::FrameTiming;
using vr::PerformancePanel;

namespace
{
constexpr double period90 = 1000.0 / 90;

/// Returns a timing in which phase i takes (i + 1) tenths of a millisecond, with half a millisecond of draw calls added
/// to Draw.
FrameTiming timing(double factor = 1)
{
    FrameTiming made{.drawCallMs = 0.5 * factor, .periodMs = period90, .isShown = true};
    for (std::size_t i = 0; i < vr::framePhaseCount; ++i)
        made.cpuMs[i] = 0.1 * static_cast<double>(i + 1) * factor;
    made.cpuMs[static_cast<std::size_t>(FramePhase::Draw)] += made.drawCallMs;
    return made;
}

std::vector<FrameTiming> many(std::size_t count, const FrameTiming& each = timing())
{
    return std::vector(count, each);
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}
} // namespace

class TestPerformancePanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutFrames_allIsNothing();
    void drawCalls_areTheirOwn();
    void aHitch_isNoMedian();
    void onlyTheLastSecond_counts();
    void framesThatAreNotShown_costNothingHere();
    void framesThatAreLost_takeTime_data();
    void framesThatAreLost_takeTime();
    void lostFrames_areTold();
    void afterFewFrames_itKnowsTheRate();
};

void TestPerformancePanel::withoutFrames_allIsNothing()
{
    QVERIFY(PerformancePanel::of({}, 0) == PerformancePanel());
    FrameTiming hidden = timing();
    hidden.isShown = false;
    QVERIFY(PerformancePanel::of(many(300, hidden), 0) == PerformancePanel());
}

/// Checks that draw calls are not included in the phases and their sum.
void TestPerformancePanel::drawCalls_areTheirOwn()
{
    const PerformancePanel panel = PerformancePanel::of(many(90), 0);
    for (std::size_t i = 0; i < vr::framePhaseCount; ++i)
        QVERIFY(isNear(panel.cpuMs[i], 0.1 * static_cast<double>(i + 1)));
    QVERIFY(isNear(panel.totalMs, std::accumulate(panel.cpuMs.begin(), panel.cpuMs.end(), 0.0)));
    QVERIFY(isNear(panel.drawCallMs, 0.5));
}

void TestPerformancePanel::aHitch_isNoMedian()
{
    std::vector<FrameTiming> timings = many(90);
    for (const std::size_t i : {3UL, 40UL, 41UL, 42UL, 89UL})
        timings[i] = timing(100);
    QVERIFY(PerformancePanel::of(timings, 0) == PerformancePanel::of(many(90), 0));
}

void TestPerformancePanel::onlyTheLastSecond_counts()
{
    std::vector<FrameTiming> timings = many(300, timing(7));
    const std::vector<FrameTiming> last = many(91);
    timings.insert(timings.end(), last.begin(), last.end());
    QVERIFY(PerformancePanel::of(timings, 0) == PerformancePanel::of(last, 0));
}

void TestPerformancePanel::framesThatAreNotShown_costNothingHere()
{
    FrameTiming hidden = timing(9);
    hidden.isShown = false;
    std::vector<FrameTiming> timings;
    for (int i = 0; i < 60; ++i)
        timings.insert(timings.end(), {timing(), hidden});
    const PerformancePanel panel = PerformancePanel::of(timings, 0);
    QVERIFY(isNear(panel.totalMs, timing().ownMs()));
    QCOMPARE(panel.framesPerSecond, 45);
}

void TestPerformancePanel::framesThatAreLost_takeTime_data()
{
    QTest::addColumn<unsigned>("lost");
    QTest::addColumn<int>("framesPerSecond");
    QTest::newRow("none") << 0U << 90;
    QTest::newRow("every other") << 1U << 45;
    QTest::newRow("two of three") << 2U << 30;
    QTest::newRow("most") << 17U << 5;
}

void TestPerformancePanel::framesThatAreLost_takeTime()
{
    QFETCH(unsigned, lost);
    QFETCH(int, framesPerSecond);
    FrameTiming each = timing();
    each.dropped = lost;
    QCOMPARE(PerformancePanel::of(many(200, each), 0).framesPerSecond, framesPerSecond);
}

void TestPerformancePanel::lostFrames_areTold()
{
    QCOMPARE(PerformancePanel::of(many(9), 12'345'678'901).dropped, std::uint64_t(12'345'678'901));
}

void TestPerformancePanel::afterFewFrames_itKnowsTheRate()
{
    QCOMPARE(PerformancePanel::of(many(4), 0).framesPerSecond, 90);
}

FETTLE_TEST(TestPerformancePanel, QCoreApplication)
#include "tst_performance_panel.moc"
