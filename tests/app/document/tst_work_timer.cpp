#include "app/document/work_timer.h"

#include "tests/support/test_main.h"

#include <QTest>

using app::WorkTimer;
using namespace std::chrono_literals;

class TestWorkTimer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pauses_areCountedUpToTheLongest();
    void oneStroke_takesNoTime();
    void anotherSitting_goesOnCounting();
};

void TestWorkTimer::pauses_areCountedUpToTheLongest()
{
    WorkTimer clock;
    core::WorkDone work;
    std::chrono::nanoseconds now = 5h;
    clock.count(work, now.count());
    for (const std::chrono::nanoseconds pause :
         {std::chrono::nanoseconds(1500ms), std::chrono::nanoseconds(40s), WorkTimer::maxPause,
          WorkTimer::maxPause + 1ns, std::chrono::nanoseconds(8h), std::chrono::nanoseconds(0s)})
        clock.count(work, (now += pause).count());
    QCOMPARE(work.strokes, 7U);
    QCOMPARE(work.seconds, 1.5 + 40 + std::chrono::duration<double>(WorkTimer::maxPause).count());
}

void TestWorkTimer::oneStroke_takesNoTime()
{
    WorkTimer clock;
    core::WorkDone work;
    clock.count(work, 7);
    QVERIFY((work == core::WorkDone{1, 0}));
}

/// Reopening the model the next day continues its time without counting the night.
void TestWorkTimer::anotherSitting_goesOnCounting()
{
    WorkTimer clock;
    core::WorkDone work{100, 3600};
    clock.count(work, std::chrono::nanoseconds(24h).count());
    clock.count(work, std::chrono::nanoseconds(24h + 10s).count());
    QVERIFY((work == core::WorkDone{102, 3610}));
}

FETTLE_TEST(TestWorkTimer, QCoreApplication)
#include "tst_work_timer.moc"
