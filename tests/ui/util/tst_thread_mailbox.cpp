#include "ui/util/thread_mailbox.h"

#include "tests/support/test_main.h"

#include <QEventLoop>
#include <QTest>
#include <QThread>

#include <algorithm>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

using ui::ThreadMailbox;

class TestThreadMailbox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void runsHereInOrder();
    void keepsOrderAmongOtherMail();
    void losesNothingOfManyPosters();
    void runsOthersWhileOneWaits();
    void dropsWhatWaitsWhenItGoes();
};

void TestThreadMailbox::runsHereInOrder()
{
    ThreadMailbox mailbox;
    std::vector<int> opened; // used on this thread only; otherwise ThreadSanitizer would report it
    std::thread poster([&] {
        for (int i = 0; i < 1000; ++i)
            mailbox.post([&opened, page = std::make_shared<int>(i)] {
                opened.push_back(QThread::currentThread() == qApp->thread() ? *page : -1);
            });
    });
    QTRY_COMPARE(opened.size(), std::size_t(1000));
    poster.join();
    std::vector<int> expected(1000);
    std::iota(expected.begin(), expected.end(), 0);
    QCOMPARE(opened, expected);
}

void TestThreadMailbox::keepsOrderAmongOtherMail()
{
    ThreadMailbox one, other;
    QString opened;
    one.post([&] { opened += QLatin1Char('a'); });
    other.post([&] { opened += QLatin1Char('b'); });
    QMetaObject::invokeMethod(
        this, [&] { opened += QLatin1Char('c'); }, Qt::QueuedConnection);
    one.post([&] { opened += QLatin1Char('d'); });
    QVERIFY(opened.isEmpty());
    QTRY_COMPARE(opened, QStringLiteral("abcd"));
}

void TestThreadMailbox::losesNothingOfManyPosters()
{
    constexpr int posters = 4, tasks = 500;
    ThreadMailbox mailbox;
    std::vector<std::vector<int>> opened(posters);
    std::vector<std::thread> threads;
    for (int p = 0; p < posters; ++p)
        threads.emplace_back([&, p] {
            for (int i = 0; i < tasks; ++i)
                mailbox.post([&opened, p, pages = std::vector<int>(3, i)] {
                    opened[p].insert(opened[p].end(), pages.begin(), pages.end());
                });
        });
    const auto isComplete = [&] {
        return std::all_of(opened.begin(), opened.end(), [](const auto& each) { return each.size() == 3 * tasks; });
    };
    QTRY_VERIFY(isComplete());
    for (auto& thread : threads)
        thread.join();
    for (const auto& each : opened)
        QVERIFY(std::is_sorted(each.begin(), each.end()));
}

/// A task runs a nested event loop, as a dialog does, and later tasks run in it.
void TestThreadMailbox::runsOthersWhileOneWaits()
{
    ThreadMailbox mailbox;
    QEventLoop question;
    bool isAnswered = false, isOver = false;
    mailbox.post([&] {
        mailbox.post([&] {
            isAnswered = true;
            question.quit();
        });
        question.exec();
        isOver = isAnswered;
    });
    QTRY_VERIFY(isOver);
}

void TestThreadMailbox::dropsWhatWaitsWhenItGoes()
{
    const auto page = std::make_shared<int>();
    bool isOpened = false;
    {
        ThreadMailbox mailbox;
        mailbox.post([&isOpened, page] { isOpened = true; });
        QCOMPARE(page.use_count(), 2L);
    }
    QCOMPARE(page.use_count(), 1L);
    QCoreApplication::processEvents();
    QVERIFY(!isOpened);
}

FETTLE_TEST(TestThreadMailbox, QCoreApplication)
#include "tst_thread_mailbox.moc"
