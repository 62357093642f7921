#include "ui/actions/actions.h"
#include "ui/actions/shortcut_map.h"

#include <QTest>

using ui::KeyChoice;
using ui::KeyMap;
using ui::KeyPreset;
using ui::KeyProblem;
using ui::Keys;

namespace
{
Keys keys(const char* portable)
{
    return QKeySequence::listFromString(QLatin1StringView(portable));
}

QString id(const ui::ActionInfo& row)
{
    return QLatin1StringView(row.id);
}

/// Whatever was asked for, no key has two commands, and the map's two ways agree.
bool isSound(const KeyMap& map)
{
    QHash<QKeySequence, QString> owners;
    for (const ui::ActionInfo& row : ui::actionTable())
        for (const QKeySequence& key : map.keys(id(row))) {
            if (key.isEmpty() || owners.contains(key) || map.owner(key) != id(row))
                return false;
            owners.insert(key, id(row));
        }
    return !owners.isEmpty();
}
} // namespace

class TestKeyMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachPresetIsWhole_data()
    {
        QTest::addColumn<KeyPreset>("preset");
        for (const auto& row : ui::keyPresets)
            QTest::newRow(row.key) << row.value;
    }

    /// Nothing that the preset gives is lost to another command, and every action that has a key somewhere has one
    /// here.
    void eachPresetIsWhole()
    {
        QFETCH(KeyPreset, preset);
        const KeyMap map({preset, {}});
        QVERIFY(isSound(map));
        for (const ui::ActionInfo& row : ui::actionTable()) {
            QVERIFY2(map.keys(id(row)) == ui::presetKeys(preset, id(row)), row.id);
            QVERIFY2(!*row.keys || !map.keys(id(row)).isEmpty(), row.id);
            QVERIFY2(map.keys(id(row)).size() <= ui::mostKeys, row.id);
            for (const QKeySequence& key : map.keys(id(row)))
                QVERIFY2(ui::problemOf(key, id(row)) == KeyProblem::None || ui::isFixed(id(row)), row.id);
        }
    }

    void presetsDepartFromEachOther()
    {
        const QString radius = QStringLiteral("brush.radius"), frame = QStringLiteral("view.frame"),
                      pull = QStringLiteral("tool.pull");
        QCOMPARE(ui::presetKeys(KeyPreset::Fettle, radius), keys("F"));
        QCOMPARE(ui::presetKeys(KeyPreset::ZBrush, radius), keys("S"));
        QVERIFY(ui::presetKeys(KeyPreset::ZBrush, frame).contains(QKeySequence(Qt::Key_F)));
        QVERIFY(ui::presetKeys(KeyPreset::Blender, pull).contains(QKeySequence(Qt::Key_V)));
        QVERIFY(ui::presetKeys(KeyPreset::Fettle, QStringLiteral("no.such")).isEmpty());
        QCOMPARE(ui::heldKeys(KeyPreset::Fettle).invert, Qt::ControlModifier);
        QCOMPARE(ui::heldKeys(KeyPreset::Blender).invert, Qt::ControlModifier);
        QCOMPARE(ui::heldKeys(KeyPreset::ZBrush).invert, Qt::AltModifier);
    }

    void aPersonsKeysGoFirst()
    {
        const KeyMap map({KeyPreset::Fettle, {{QStringLiteral("view.ground"), QStringLiteral("F; Q")}}});
        QVERIFY(isSound(map));
        QCOMPARE(map.keys(QStringLiteral("view.ground")), keys("F; Q"));
        QVERIFY(map.keys(QStringLiteral("brush.radius")).isEmpty());
    }

    void theTableDecidesAmongEquals()
    {
        const KeyMap map({KeyPreset::Fettle,
                          {{QStringLiteral("view.ground"), QStringLiteral("Q")},
                           {QStringLiteral("tool.push"), QStringLiteral("Q; Q")}}});
        QVERIFY(isSound(map));
        QCOMPARE(map.owner(QKeySequence(Qt::Key_Q)), QStringLiteral("tool.push"));
        QVERIFY(map.keys(QStringLiteral("view.ground")).isEmpty());
    }

    void whatCannotBeIsAsIfItWereNotThere_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const char* id, const QString& text) {
            QTest::newRow(name) << QString::fromLatin1(id) << text;
        };
        row("no such action", "tool.teleport", QStringLiteral("Q"));
        row("no key", "tool.pull", QStringLiteral("grmpf"));
        row("one of two is no key", "tool.pull", QStringLiteral("Q; grmpf"));
        row("noise", "tool.pull", QString::fromLatin1("\x01\xff;;\x07 ; "));
        row("chord", "tool.pull", QStringLiteral("Ctrl+K, Ctrl+L"));
        row("three", "tool.pull", QStringLiteral("Q; Y; O"));
        row("held", "tool.pull", QStringLiteral("Shift"));
        row("needed by widgets", "tool.pull", QStringLiteral("Tab"));
        row("opens a menu", "tool.pull", QStringLiteral("Alt+F"));
        row("fixed", "edit.stop", QStringLiteral("Q"));
        row("very long", "tool.pull", QString(100000, u'Q'));
    }

    void whatCannotBeIsAsIfItWereNotThere()
    {
        QFETCH(QString, id);
        QFETCH(QString, text);
        const KeyMap map({KeyPreset::Fettle, {{id, text}}});
        QVERIFY(isSound(map));
        for (const ui::ActionInfo& row : ui::actionTable())
            QVERIFY2(map.keys(::id(row)) == ui::presetKeys(KeyPreset::Fettle, ::id(row)), row.id);
        QVERIFY(map.keys(QStringLiteral("tool.teleport")).isEmpty());
    }

    void anEmptyEntryIsNoKey()
    {
        const KeyMap map({KeyPreset::Fettle, {{QStringLiteral("tool.pull"), QString()}}});
        QVERIFY(map.keys(QStringLiteral("tool.pull")).isEmpty());
        QVERIFY(map.owner(QKeySequence(Qt::Key_1)).isEmpty());
    }

    void onlyDifferencesAreKept()
    {
        const QString pull = QStringLiteral("tool.pull");
        KeyChoice choice = ui::withKeys({}, pull, keys("Q; Num+4"));
        QCOMPARE(choice.own.size(), 1);
        QCOMPARE(KeyMap(choice).keys(pull), keys("Q; Num+4"));
        choice = ui::withKeys(choice, pull, keys("1"));
        QVERIFY(choice.own.isEmpty());
        QVERIFY(ui::withKeys({}, pull, {}).own.contains(pull));
    }

    void someKeysAreNobodys()
    {
        const auto problem = [](const char* key) { return ui::problemOf(QKeySequence(QLatin1StringView(key))); };
        for (const char* key : {"Esc", "Tab", "Shift+Tab", "Ctrl+Tab", "Return", "Space", "Up", "Shift+Left",
                                "Backspace", "F10", "0", "Num+0"})
            QVERIFY2(problem(key) == KeyProblem::Widgets, key);
        for (const int key :
             {Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt, Qt::Key_Meta, Qt::Key_AltGr, Qt::Key_CapsLock})
            QVERIFY(ui::problemOf(QKeySequence(key)) == KeyProblem::Held);
        for (const char* key : {"Alt+F", "Alt+Z", "Alt+\xc3\x84"})
            QVERIFY2(ui::problemOf(QKeySequence(QString::fromUtf8(key))) == KeyProblem::Menus, key);
        for (const char* key :
             {"F", "1", "Num+1", "Alt+1", "Ctrl+Return", "Ctrl+Up", "Ctrl+0", "F5", "Home", "Ctrl+Alt+F", "."})
            QVERIFY2(problem(key) == KeyProblem::None, key);
    }
};

QTEST_GUILESS_MAIN(TestKeyMap)
#include "tst_shortcut_map.moc"
