#include "vr/openxr/runtime_thread.h"

#include "tests/support/test_main.h"

#include <QSignalSpy>
#include <QTest>

#include <atomic>

using vr::RuntimeThread;

class TestRuntimeThread : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tasks_runHereInOrder();
    void ended_comesWhenAllIsGone();
    void ended_mayBeginOtherWork();
    void waitForEnd_doesNotWaitForEver();
    void finishedWork_isNotLeft();
    void work_isLeftBehind();
};

void TestRuntimeThread::tasks_runHereInOrder()
{
    RuntimeThread thread;
    QSignalSpy ended(&thread, &RuntimeThread::ended);
    std::thread::id worker;
    QList<int> opened;
    bool areHere = true, isLast = true;
    thread.start([&](const RuntimeThread::Post& post) {
        worker = std::this_thread::get_id();
        for (int i = 0; i < 100; ++i)
            post([&, i, here = worker] {
                opened << i;
                areHere = areHere && std::this_thread::get_id() != here;
                isLast = isLast && ended.isEmpty();
            });
    });
    QVERIFY(opened.isEmpty());
    QTRY_COMPARE(ended.size(), 1);
    QVERIFY(areHere && isLast);
    QVERIFY(worker != std::this_thread::get_id());
    QCOMPARE(opened.size(), 100);
    QVERIFY(std::ranges::is_sorted(opened));
}

void TestRuntimeThread::ended_comesWhenAllIsGone()
{
    RuntimeThread thread;
    auto held = std::make_shared<int>(1);
    const std::weak_ptr<int> seen = held;
    bool wasGone = false;
    QObject::connect(&thread, &RuntimeThread::ended, &thread, [&] { wasGone = seen.expired() && !thread.isWorking(); });
    QVERIFY(!thread.isWorking());
    thread.start([held = std::move(held)](const auto&) {});
    QVERIFY(thread.isWorking());
    QTRY_VERIFY(!thread.isWorking());
    QVERIFY(wasGone);
}

void TestRuntimeThread::ended_mayBeginOtherWork()
{
    RuntimeThread thread;
    int more = 3, done = 0; // one work after the other
    const auto begin = [&] { thread.start([&](const auto&) { ++done; }); };
    QObject::connect(&thread, &RuntimeThread::ended, &thread, [&] {
        if (more-- > 0)
            begin();
    });
    begin();
    QTRY_VERIFY(!thread.isWorking());
    QCOMPARE(done, 4);
}

void TestRuntimeThread::waitForEnd_doesNotWaitForEver()
{
    using namespace std::chrono_literals;
    RuntimeThread thread;
    QVERIFY(thread.waitForEnd(0ms));
    std::promise<void> gate;
    thread.start([&](const auto&) { gate.get_future().wait(); });
    QVERIFY(!thread.waitForEnd(50ms));
    QVERIFY(!thread.waitForEnd(-1ms));
    gate.set_value();
    QVERIFY(thread.waitForEnd(60s));
    QTRY_VERIFY(!thread.isWorking());
}

void TestRuntimeThread::finishedWork_isNotLeft()
{
    {
        RuntimeThread thread;
        thread.start([](const RuntimeThread::Post& post) { post([] { qFatal("opened for nobody"); }); });
        QVERIFY(thread.waitForEnd(std::chrono::minutes(1)));
    }
    QCoreApplication::processEvents();
    QVERIFY(!RuntimeThread::hasAbandonedWork());
}

/// Checks that abandoned work goes on and that its tasks are dropped.
void TestRuntimeThread::work_isLeftBehind()
{
    struct Shared
    {
        std::promise<void> gate;
        std::atomic<bool> isDone = false;
    };
    const auto shared = std::make_shared<Shared>();
    {
        RuntimeThread thread;
        thread.start([shared](const RuntimeThread::Post& post) {
            post([] { qFatal("opened for nobody"); });
            shared->gate.get_future().wait();
            post([] { qFatal("opened for nobody"); });
            shared->isDone = true;
        });
        QVERIFY(!thread.waitForEnd(std::chrono::milliseconds(10)));
    }
    QVERIFY(RuntimeThread::hasAbandonedWork());
    QVERIFY(!shared->isDone);
    shared->gate.set_value();
    QTRY_COMPARE(shared.use_count(), 1L);
    QVERIFY(shared->isDone);
}

FETTLE_TEST(TestRuntimeThread, QCoreApplication)
#include "tst_runtime_thread.moc"
