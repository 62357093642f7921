#include "ui/util/background_thread.h"

#include <QTest>

#include <future>
#include <memory>
#include <thread>

using ui::SideThread;

class TestSideThread : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void worksAsideAndTakesHere();
    void handsOverWhatCannotBeCopied();
    void worksInOrder();
    void doesAllBeforeItGoes();
    void dropsWhatHasNotBegun();
};

void TestSideThread::worksAsideAndTakesHere()
{
    SideThread aside;
    std::thread::id worked, taken;
    aside.run([] { return std::this_thread::get_id(); },
              [&](std::thread::id id) {
                  worked = id;
                  taken = std::this_thread::get_id();
              });
    QTRY_VERIFY(worked != std::thread::id());
    QVERIFY(worked != std::this_thread::get_id());
    QVERIFY(taken == std::this_thread::get_id());
}

void TestSideThread::handsOverWhatCannotBeCopied()
{
    SideThread aside;
    std::unique_ptr<int> made;
    aside.run([] { return std::make_unique<int>(7); }, [&](std::unique_ptr<int> it) { made = std::move(it); });
    QTRY_VERIFY(made);
    QCOMPARE(*made, 7);
}

void TestSideThread::worksInOrder()
{
    SideThread aside;
    QList<int> taken, expected;
    for (int i = 0; i < 200; ++i) {
        expected << i;
        aside.run([i] { return QList<int>{i}; }, [&](const QList<int>& some) { taken << some; });
    }
    QTRY_COMPARE(taken, expected);
}

void TestSideThread::doesAllBeforeItGoes()
{
    int done = 0, taken = 0;
    {
        SideThread aside;
        for (int i = 0; i < 50; ++i)
            aside.run([&done] { return ++done; }, [&taken](int) { ++taken; });
    }
    QCOMPARE(done, 50);
    QCoreApplication::processEvents();
    QCOMPARE(taken, 0);
}

void TestSideThread::dropsWhatHasNotBegun()
{
    bool isDone = false;
    std::promise<void> began, mayEnd;
    {
        SideThread aside;
        aside.run([&] {
            began.set_value();
            mayEnd.get_future().wait();
        });
        began.get_future().wait();
        aside.run([&] { isDone = true; });
        aside.drop();
        mayEnd.set_value();
    }
    QVERIFY(!isDone);
}

QTEST_GUILESS_MAIN(TestSideThread)
#include "tst_background_thread.moc"
