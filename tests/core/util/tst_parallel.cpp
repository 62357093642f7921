#include "core/util/parallel.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <atomic>
#include <chrono>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>

class TestParallel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void chunks_coverTheRangeOnce_data();
    void chunks_coverTheRangeOnce();
    void fewChunks_areDoneAtOnce();
    void joinedParts_standInOrder_data() { chunks_coverTheRangeOnce_data(); }
    void joinedParts_standInOrder();
    void chunksInsideOfChunks_areDone();
    void exception_isPassedOn();
    void helpersAsleepOrAwake_doAll();
};

/// Uses more threads than most test machines have cores.
void TestParallel::init()
{
    core::WorkerPool::shared().setThreads(8);
}

void TestParallel::cleanup()
{
    core::WorkerPool::shared().setThreads(0);
}

void TestParallel::chunks_coverTheRangeOnce_data()
{
    QTest::addColumn<std::size_t>("count");
    for (const std::size_t count : {0, 1, 7, 29, 30, 31, 1000})
        QTest::addRow("%zu", count) << count;
}

void TestParallel::chunks_coverTheRangeOnce()
{
    QFETCH(std::size_t, count);
    std::vector<int> visits(count, 0);
    core::forEachChunk(count, 10, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            ++visits[10 * chunk + (i - begin)];
    });
    QVERIFY(std::ranges::all_of(visits, [](int n) { return n == 1; }));
}

void TestParallel::fewChunks_areDoneAtOnce()
{
    int calls = 0;
    core::forEachChunk(10 * core::minChunks - 10, 10, [&](std::size_t, std::size_t, std::size_t) { ++calls; });
    QCOMPARE(calls, 1);
}

void TestParallel::joinedParts_standInOrder()
{
    QFETCH(std::size_t, count);
    const auto odd =
        core::joinChunks<std::vector<std::size_t>>(count, 10, [](std::size_t begin, std::size_t end, auto& part) {
            for (std::size_t i = begin; i < end; ++i) {
                if (i % 2 == 1)
                    part.push_back(i);
            }
        });
    QCOMPARE(odd.size(), count / 2);
    for (std::size_t i = 0; i < odd.size(); ++i)
        QCOMPARE(odd[i], 2 * i + 1);
}

void TestParallel::chunksInsideOfChunks_areDone()
{
    std::vector<std::size_t> sums(100, 0);
    core::forEachChunk(sums.size(), 1, [&](std::size_t chunk, std::size_t, std::size_t) {
        core::forEachChunk(50, 1, [&](std::size_t, std::size_t begin, std::size_t end) { sums[chunk] += end - begin; });
    });
    QCOMPARE(std::accumulate(sums.begin(), sums.end(), std::size_t(0)), std::size_t(5000));
}

void TestParallel::exception_isPassedOn()
{
    const auto fails = [] {
        core::forEachChunk(100, 1, [](std::size_t chunk, std::size_t, std::size_t) {
            if (chunk == 57)
                throw std::runtime_error("57");
        });
    };
    QVERIFY_EXCEPTION_THROWN(fails(), std::runtime_error);
}

/// Some pauses are longer than idle helper threads stay awake.
void TestParallel::helpersAsleepOrAwake_doAll()
{
    std::mt19937 engine(20240812);
    for (int round = 0; round < 3000; ++round) {
        std::atomic<int> chunks = 0;
        core::forEachChunk(20, 1, [&](std::size_t, std::size_t, std::size_t) { ++chunks; });
        QCOMPARE(chunks.load(), 20);
        if (engine() % 16 == 0)
            std::this_thread::sleep_for(std::chrono::microseconds(engine() % 1000));
    }
}

FETTLE_TEST(TestParallel)
#include "tst_parallel.moc"
