#include "core/util/slot_map.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <random>
#include <set>

using core::Slot;
using core::SlotMap;

namespace
{
constexpr unsigned seed = 20240812;
}

class TestSlotMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void newSlots_areFree();
    void take_prefersTheHintsWord();
    void take_growsWhileFewSlotsAreFree();
    void take_searchesFarWhenAnEighthIsFree();
    void shrinking_forgetsFreeSlots();
    void randomUse_agreesWithASet();
    void take_dependsOnFreeSlotsAndHintOnly();
};

void TestSlotMap::newSlots_areFree()
{
    SlotMap map;
    map.resize(100);
    QCOMPARE(map.size(), 100u);
    QCOMPARE(map.free(), 100u);
    for (Slot i = 0; i < 100; ++i)
        QVERIFY(map.isFree(i));
}

void TestSlotMap::take_prefersTheHintsWord()
{
    SlotMap map;
    map.resize(10'000);
    const Slot taken = map.take(5'000);
    QCOMPARE(taken / 64, 5'000u / 64);
    QVERIFY(!map.isFree(taken));
    QCOMPARE(map.live(), 1u);
}

void TestSlotMap::take_growsWhileFewSlotsAreFree()
{
    SlotMap map;
    map.resize(100'000);
    for (Slot i = 0; i < map.size(); ++i)
        map.setFree(i, false);
    map.setFree(99'999, true); // far from the hint, and far fewer than an eighth of the slots
    QCOMPARE(map.take(0), 100'000u);
    QCOMPARE(map.size(), 100'001u);
    QCOMPARE(map.take(99'990), 99'999u);
}

void TestSlotMap::take_searchesFarWhenAnEighthIsFree()
{
    SlotMap map;
    map.resize(80'000);
    for (Slot i = 0; i < 70'000; ++i)
        map.setFree(i, false);
    QCOMPARE(map.take(0), 70'000u);
}

void TestSlotMap::shrinking_forgetsFreeSlots()
{
    SlotMap map;
    map.resize(200);
    map.resize(70);
    QCOMPARE(map.free(), 70u);
    map.resize(200);
    QCOMPARE(map.free(), 200u);
}

void TestSlotMap::randomUse_agreesWithASet()
{
    std::mt19937 engine(seed);
    SlotMap map;
    std::set<Slot> free;
    for (int i = 0; i < 200'000; ++i) {
        const Slot slot = map.size() > 0 ? static_cast<Slot>(engine() % map.size()) : 0;
        const auto choice = static_cast<unsigned>(engine() % 1000);
        if (choice == 0) {
            const Slot size = static_cast<Slot>(engine() % 3000);
            for (Slot s = map.size(); s < size; ++s)
                free.insert(s);
            free.erase(free.lower_bound(size), free.end());
            map.resize(size);
        } else if (choice < 500) {
            const Slot before = map.size();
            const Slot taken = map.take(slot);
            QVERIFY(taken == before ? map.size() == before + 1 : free.erase(taken) == 1);
        } else if (map.size() > 0) {
            const bool isFree = engine() % 2 == 0;
            map.setFree(slot, isFree);
            if (isFree)
                free.insert(slot);
            else
                free.erase(slot);
        }
        QCOMPARE(map.free(), static_cast<Slot>(free.size()));
        if (map.size() > 0)
            QCOMPARE(map.isFree(slot < map.size() ? slot : 0), free.contains(slot < map.size() ? slot : 0));
    }
}

/// One map has a long history. The other has only the same free slots.
void TestSlotMap::take_dependsOnFreeSlotsAndHintOnly()
{
    std::mt19937 engine(seed);
    for (int round = 0; round < 100; ++round) {
        SlotMap old;
        old.resize(static_cast<Slot>(engine() % 5000));
        for (int i = 0; i < 3000; ++i) {
            if (engine() % 3 == 0 && old.size() > 0)
                old.setFree(static_cast<Slot>(engine() % old.size()), true);
            else
                old.take(static_cast<Slot>(engine() % (old.size() + 1)));
        }
        old.resize(old.size() - static_cast<Slot>(engine() % (old.size() / 2)));
        SlotMap fresh;
        fresh.resize(old.size());
        for (Slot i = 0; i < old.size(); ++i)
            fresh.setFree(i, old.isFree(i));
        for (int i = 0; i < 500; ++i) {
            const Slot hint = static_cast<Slot>(engine() % old.size());
            QCOMPARE(old.take(hint), fresh.take(hint));
        }
    }
}

FETTLE_TEST(TestSlotMap)
#include "tst_slot_map.moc"
