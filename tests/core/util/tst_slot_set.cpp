#include "core/util/slot_set.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <random>
#include <set>

using core::Slot;
using core::SlotSet;

class TestSlotSet : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void largeSlots_comeAndGo();
    void randomUse_agreesWithASet();
    void sort_ascends_data();
    void sort_ascends();
};

void TestSlotSet::largeSlots_comeAndGo()
{
    SlotSet set;
    QVERIFY(!set.contains(7));
    QVERIFY(set.add(7));
    QVERIFY(set.add(2'000'000'000)); // this slot is beyond the initial capacity
    QVERIFY(!set.add(7));
    QVERIFY(set.contains(2'000'000'000));
    set.clear();
    QVERIFY(!set.contains(7));
    QVERIFY(!set.contains(2'000'000'000));
}

void TestSlotSet::randomUse_agreesWithASet()
{
    std::mt19937 engine(20240812);
    SlotSet set;
    std::set<Slot> known;
    for (int i = 0; i < 200'000; ++i) {
        if (engine() % 500 == 0) {
            set.clear();
            known.clear();
        }
        const Slot slot = static_cast<Slot>(engine() % 1000);
        QCOMPARE(set.contains(slot), known.contains(slot));
        if (engine() % 2 == 0)
            QCOMPARE(set.add(slot), known.insert(slot).second);
        QCOMPARE(set.size(), known.size());
    }
}

void TestSlotSet::sort_ascends_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<Slot>("range");
    QTest::newRow("none") << 0 << 1u;
    QTest::newRow("few") << 20 << 1000u;
    QTest::newRow("many") << 3000 << 10'000u;
    QTest::newRow("many, far apart") << 3000 << 20'000'000u;
}

void TestSlotSet::sort_ascends()
{
    QFETCH(int, count);
    QFETCH(Slot, range);
    std::mt19937 engine(20240812);
    SlotSet set;
    std::set<Slot> known;
    for (int i = 0; i < count; ++i) {
        const Slot slot = static_cast<Slot>(engine()) % range;
        set.add(slot);
        known.insert(slot);
    }
    set.sort();
    QCOMPARE(set.slots(), std::vector<Slot>(known.begin(), known.end()));
}

FETTLE_TEST(TestSlotSet)
#include "tst_slot_set.moc"
