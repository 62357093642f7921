#include "core/util/sparse_index.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <map>
#include <random>

using core::Slot;
using core::SparseIndex;

class TestSparseIndex : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void add_tellsThePosition();
    void randomUse_agreesWithAMap();
};

void TestSparseIndex::add_tellsThePosition()
{
    SparseIndex index;
    QVERIFY(!index.contains(7));
    QCOMPARE(index.add(7), 0u);
    QCOMPARE(index.add(50'000'000), 1u); // this slot is beyond the initial capacity
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

FETTLE_TEST(TestSparseIndex)
#include "tst_sparse_index.moc"
