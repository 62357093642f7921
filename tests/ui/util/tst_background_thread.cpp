#include "ui/util/background_thread.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <future>
#include <memory>
#include <thread>

using ui::BackgroundThread;

class TestBackgroundThread : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void worksInBackgroundAndReturnsHere();
    void handsOverWhatCannotBeCopied();
    void worksInOrder();
    void doesAllBeforeItGoes();
    void dropsWhatHasNotBegun();
};

void TestBackgroundThread::worksInBackgroundAndReturnsHere()
{
    BackgroundThread background;
    std::thread::id worked, taken;
    background.run([] { return std::this_thread::get_id(); },
                   [&](std::thread::id id) {
                       worked = id;
                       taken = std::this_thread::get_id();
                   });
    QTRY_VERIFY(worked != std::thread::id());
    QVERIFY(worked != std::this_thread::get_id());
    QVERIFY(taken == std::this_thread::get_id());
}

void TestBackgroundThread::handsOverWhatCannotBeCopied()
{
    BackgroundThread background;
    std::unique_ptr<int> made;
    background.run([] { return std::make_unique<int>(7); }, [&](std::unique_ptr<int> it) { made = std::move(it); });
    QTRY_VERIFY(made);
    QCOMPARE(*made, 7);
}

void TestBackgroundThread::worksInOrder()
{
    BackgroundThread background;
    QList<int> taken, expected;
    for (int i = 0; i < 200; ++i) {
        expected << i;
        background.run([i] { return QList<int>{i}; }, [&](const QList<int>& some) { taken << some; });
    }
    QTRY_COMPARE(taken, expected);
}

void TestBackgroundThread::doesAllBeforeItGoes()
{
    int done = 0, taken = 0;
    {
        BackgroundThread background;
        for (int i = 0; i < 50; ++i)
            background.run([&done] { return ++done; }, [&taken](int) { ++taken; });
    }
    QCOMPARE(done, 50);
    QCoreApplication::processEvents();
    QCOMPARE(taken, 0);
}

void TestBackgroundThread::dropsWhatHasNotBegun()
{
    bool isDone = false;
    std::promise<void> began, mayEnd;
    {
        BackgroundThread background;
        background.run([&] {
            began.set_value();
            mayEnd.get_future().wait();
        });
        began.get_future().wait();
        background.run([&] { isDone = true; });
        background.drop();
        mayEnd.set_value();
    }
    QVERIFY(!isDone);
}

FETTLE_TEST(TestBackgroundThread, QCoreApplication)
#include "tst_background_thread.moc"
