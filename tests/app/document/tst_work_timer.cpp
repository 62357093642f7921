#include "app/document/work_timer.h"

#include <QTest>

using app::WorkClock;
using namespace std::chrono_literals;

class TestWorkClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pauses_areCountedUpToTheLongest();
    void oneStroke_takesNoTime();
    void anotherSitting_goesOnCounting();
};

void TestWorkClock::pauses_areCountedUpToTheLongest()
{
    WorkClock clock;
    core::WorkDone work;
    std::chrono::nanoseconds now = 5h;
    clock.count(work, now.count());
    for (const std::chrono::nanoseconds pause :
         {std::chrono::nanoseconds(1500ms), std::chrono::nanoseconds(40s), WorkClock::longestPause,
          WorkClock::longestPause + 1ns, std::chrono::nanoseconds(8h), std::chrono::nanoseconds(0s)})
        clock.count(work, (now += pause).count());
    QCOMPARE(work.strokes, 7U);
    QCOMPARE(work.seconds, 1.5 + 40 + std::chrono::duration<double>(WorkClock::longestPause).count());
}

void TestWorkClock::oneStroke_takesNoTime()
{
    WorkClock clock;
    core::WorkDone work;
    clock.count(work, 7);
    QVERIFY((work == core::WorkDone{1, 0}));
}

/// Of the same model, on another day: the night between does not count.
void TestWorkClock::anotherSitting_goesOnCounting()
{
    WorkClock clock;
    core::WorkDone work{100, 3600};
    clock.count(work, std::chrono::nanoseconds(24h).count());
    clock.count(work, std::chrono::nanoseconds(24h + 10s).count());
    QVERIFY((work == core::WorkDone{102, 3610}));
}

QTEST_GUILESS_MAIN(TestWorkClock)
#include "tst_work_timer.moc"
