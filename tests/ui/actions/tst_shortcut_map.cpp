#include "tests/support/test_main.h"
#include "ui/actions/actions.h"
#include "ui/actions/shortcut_map.h"

#include <QTest>

using ui::Keys;
using ui::ShortcutMap;
using ui::ShortcutPreset;
using ui::ShortcutProblem;
using ui::ShortcutSettings;

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

/// Returns true if no key belongs to two commands, and keys() and owner() agree.
bool isSound(const ShortcutMap& map)
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

class TestShortcutMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachPresetIsWhole_data()
    {
        QTest::addColumn<ShortcutPreset>("preset");
        for (const auto& row : ui::shortcutPresets)
            QTest::newRow(row.key) << row.value;
    }

    /// Checks that every action has, without custom keys, exactly the keys of its preset: at most maxKeys, and none
    /// that is not allowed. An action with a key in the table has at least one.
    void eachPresetIsWhole()
    {
        QFETCH(ShortcutPreset, preset);
        const ShortcutMap map({preset, {}});
        QVERIFY(isSound(map));
        for (const ui::ActionInfo& row : ui::actionTable()) {
            QVERIFY2(map.keys(id(row)) == ui::presetKeys(preset, id(row)), row.id);
            QVERIFY2(!*row.keys || !map.keys(id(row)).isEmpty(), row.id);
            QVERIFY2(map.keys(id(row)).size() <= ui::maxKeys, row.id);
            for (const QKeySequence& key : map.keys(id(row)))
                QVERIFY2(ui::problemOf(key, id(row)) == ShortcutProblem::None || ui::isFixed(id(row)), row.id);
        }
    }

    void presetsDepartFromEachOther()
    {
        const QString radius = QStringLiteral("brush.radius"), frame = QStringLiteral("view.frame"),
                      pull = QStringLiteral("tool.pull");
        QCOMPARE(ui::presetKeys(ShortcutPreset::Fettle, radius), keys("F"));
        QCOMPARE(ui::presetKeys(ShortcutPreset::ZBrush, radius), keys("S"));
        QVERIFY(ui::presetKeys(ShortcutPreset::ZBrush, frame).contains(QKeySequence(Qt::Key_F)));
        QVERIFY(ui::presetKeys(ShortcutPreset::Blender, pull).contains(QKeySequence(Qt::Key_V)));
        QVERIFY(ui::presetKeys(ShortcutPreset::Fettle, QStringLiteral("no.such")).isEmpty());
        QCOMPARE(ui::mouseModifiers(ShortcutPreset::Fettle).invert, Qt::ControlModifier);
        QCOMPARE(ui::mouseModifiers(ShortcutPreset::Blender).invert, Qt::ControlModifier);
        QCOMPARE(ui::mouseModifiers(ShortcutPreset::ZBrush).invert, Qt::AltModifier);
    }

    void aPersonsKeysGoFirst()
    {
        const ShortcutMap map({ShortcutPreset::Fettle, {{QStringLiteral("view.ground"), QStringLiteral("F; Q")}}});
        QVERIFY(isSound(map));
        QCOMPARE(map.keys(QStringLiteral("view.ground")), keys("F; Q"));
        QVERIFY(map.keys(QStringLiteral("brush.radius")).isEmpty());
    }

    void theTableDecidesAmongEquals()
    {
        const ShortcutMap map({ShortcutPreset::Fettle,
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
        const ShortcutMap map({ShortcutPreset::Fettle, {{id, text}}});
        QVERIFY(isSound(map));
        for (const ui::ActionInfo& row : ui::actionTable())
            QVERIFY2(map.keys(::id(row)) == ui::presetKeys(ShortcutPreset::Fettle, ::id(row)), row.id);
        QVERIFY(map.keys(QStringLiteral("tool.teleport")).isEmpty());
    }

    void anEmptyEntryIsNoKey()
    {
        const ShortcutMap map({ShortcutPreset::Fettle, {{QStringLiteral("tool.pull"), QString()}}});
        QVERIFY(map.keys(QStringLiteral("tool.pull")).isEmpty());
        QVERIFY(map.owner(QKeySequence(Qt::Key_1)).isEmpty());
    }

    void onlyDifferencesAreKept()
    {
        const QString pull = QStringLiteral("tool.pull");
        ShortcutSettings choice = ui::withKeys({}, pull, keys("Q; Num+4"));
        QCOMPARE(choice.custom.size(), 1);
        QCOMPARE(ShortcutMap(choice).keys(pull), keys("Q; Num+4"));
        choice = ui::withKeys(choice, pull, keys("1"));
        QVERIFY(choice.custom.isEmpty());
        QVERIFY(ui::withKeys({}, pull, {}).custom.contains(pull));
    }

    void someKeysAreNobodys()
    {
        const auto problem = [](const char* key) { return ui::problemOf(QKeySequence(QLatin1StringView(key))); };
        for (const char* key : {"Esc", "Tab", "Shift+Tab", "Ctrl+Tab", "Return", "Space", "Up", "Shift+Left",
                                "Backspace", "F10", "0", "Num+0"})
            QVERIFY2(problem(key) == ShortcutProblem::Widgets, key);
        for (const int key :
             {Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt, Qt::Key_Meta, Qt::Key_AltGr, Qt::Key_CapsLock})
            QVERIFY(ui::problemOf(QKeySequence(key)) == ShortcutProblem::Modifier);
        for (const char* key : {"Alt+F", "Alt+Z", "Alt+\xc3\x84"})
            QVERIFY2(ui::problemOf(QKeySequence(QString::fromUtf8(key))) == ShortcutProblem::Menus, key);
        for (const char* key :
             {"F", "1", "Num+1", "Alt+1", "Ctrl+Return", "Ctrl+Up", "Ctrl+0", "F5", "Home", "Ctrl+Alt+F", "."})
            QVERIFY2(problem(key) == ShortcutProblem::None, key);
    }
};

FETTLE_TEST(TestShortcutMap, QCoreApplication)
#include "tst_shortcut_map.moc"
