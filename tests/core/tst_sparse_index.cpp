#include "core/sparse_index.h"

#include <QTest>

#include <map>
#include <random>
#include <set>

using core::Slot;
using core::SparseIndex;

class TestSparseIndex : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void add_tellsThePosition();
    void randomUse_agreesWithAMap();
    void sort_movesPositions_data();
    void sort_movesPositions();
};

void TestSparseIndex::add_tellsThePosition()
{
    SparseIndex index;
    QVERIFY(!index.contains(7));
    QCOMPARE(index.add(7), 0u);
    QCOMPARE(index.add(50'000'000), 1u); // past the first capacity
    QCOMPARE(index.add(7), 0u);
    QCOMPARE(index.position(50'000'000), 1u);
    index.clear();
    QVERIFY(!index.contains(7));
}

void TestSparseIndex::randomUse_agreesWithAMap()
{
    std::mt19937 engine(20240812);
    SparseIndex index;
    std::map<Slot, Slot> known;
    for (int i = 0; i < 200'000; ++i) {
        if (engine() % 500 == 0) {
            index.clear();
            known.clear();
        }
        const Slot slot = static_cast<Slot>(engine() % 1000);
        QCOMPARE(index.contains(slot), known.contains(slot));
        if (engine() % 2 == 0) {
            const Slot position = known.try_emplace(slot, static_cast<Slot>(known.size())).first->second;
            QCOMPARE(index.add(slot), position);
            QCOMPARE(index.slots()[position], slot);
        }
    }
}

void TestSparseIndex::sort_movesPositions_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<Slot>("range");
    QTest::newRow("none") << 0 << 1u;
    QTest::newRow("few") << 20 << 1000u;
    QTest::newRow("many") << 3000 << 10'000u;
    QTest::newRow("many, far apart") << 3000 << 20'000'000u;
}

void TestSparseIndex::sort_movesPositions()
{
    QFETCH(int, count);
    QFETCH(Slot, range);
    std::mt19937 engine(20240812);
    SparseIndex index;
    std::set<Slot> known;
    for (int i = 0; i < count; ++i) {
        const Slot slot = static_cast<Slot>(engine()) % range;
        index.add(slot);
        known.insert(slot);
    }
    index.sort();
    QCOMPARE(index.slots(), std::vector<Slot>(known.begin(), known.end()));
    for (Slot i = 0; i < index.size(); ++i)
        QCOMPARE(index.position(index.slots()[i]), i);
}

QTEST_APPLESS_MAIN(TestSparseIndex)
#include "tst_sparse_index.moc"
