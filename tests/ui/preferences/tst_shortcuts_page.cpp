#include "ui/actions/actions.h"
#include "ui/actions/command_list.h"
#include "ui/preferences/shortcuts_page.h"
#include "ui/widgets/shortcut_edit.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalSpy>

using ui::ShortcutMap;
using ui::ShortcutPreset;
using ui::ShortcutSettings;

namespace
{
/// The page in a window as in the dialog, and what its signal reported.
struct Fixture
{
    QMainWindow window;
    ui::Actions actions{&window};
    ui::ShortcutsPage page{actions};
    ShortcutSettings told;
    int times = 0;

    Fixture()
    {
        page.setShortcuts({});
        QObject::connect(&page, &ui::ShortcutsPage::changed, &page, [this](const ShortcutSettings& choice) {
            told = choice;
            ++times;
        });
        page.QWidget::show();
        page.activateWindow();
    }

    template <class Widget> Widget* child(const char* name) { return page.findChild<Widget*>(QLatin1StringView(name)); }
    ui::CommandList* list() { return child<ui::CommandList>("keyList"); }
    ui::ShortcutEdit* edit(const char* name) { return child<ui::ShortcutEdit>(name); }
    QString word() { return child<QLabel>("keyWord")->text(); }
    bool mayGo() { return child<QPushButton>("goToKey")->isVisible(); }
    void mark(const char* id) { list()->setCurrentItem(list()->itemOf(QLatin1StringView(id))); }
    QString marked() { return ui::CommandList::actionOf(list()->currentItem())->objectName(); }
    QString shown(const char* id) { return list()->itemOf(QLatin1StringView(id))->text(ui::CommandList::Key); }
    QKeySequence key(const char* id) { return ShortcutMap(told).keys(QLatin1StringView(id)).value(0); }
    QString name(const char* id) { return actions.get(QLatin1StringView(id))->iconText(); }
};
} // namespace

class TestShortcutsPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyCommandStandsThere()
    {
        Fixture fixture;
        for (const ui::ActionInfo& row : ui::actionTable()) {
            const QString keys = QKeySequence::listToString(
                ui::presetKeys(ShortcutPreset::Fettle, QLatin1StringView(row.id)), QKeySequence::NativeText);
            QCOMPARE(fixture.shown(row.id), keys);
        }
    }

    void aKeyIsChangedByPressingIt()
    {
        Fixture fixture;
        fixture.mark("tool.pull");
        QTest::keyClick(fixture.edit("key1"), Qt::Key_H);
        QCOMPARE(fixture.key("tool.pull"), QKeySequence(Qt::Key_H));
        QCOMPARE(fixture.shown("tool.pull"), QStringLiteral("H"));
        QTest::keyClick(fixture.edit("key2"), Qt::Key_4, Qt::KeypadModifier | Qt::ControlModifier);
        QCOMPARE(ShortcutMap(fixture.told).keys(QStringLiteral("tool.pull")).value(1),
                 QKeySequence(QStringLiteral("Ctrl+Num+4")));
        QTest::keyClick(fixture.edit("key1"), Qt::Key_Backspace);
        QCOMPARE(fixture.key("tool.pull"), QKeySequence(QStringLiteral("Ctrl+Num+4")));
        QVERIFY(fixture.edit("key2")->keySequence().isEmpty());
        QVERIFY(fixture.word().isEmpty());
    }

    void shiftThatOnlyChoosesTheSignIsNoPart()
    {
        Fixture fixture;
        fixture.mark("tool.pull");
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Question, Qt::ShiftModifier, QStringLiteral("?"));
        QCoreApplication::sendEvent(fixture.edit("key1"), &press);
        QCOMPARE(fixture.key("tool.pull"), QKeySequence(Qt::Key_Question));
        QTest::keyClick(fixture.edit("key1"), Qt::Key_J, Qt::ShiftModifier);
        QCOMPARE(fixture.key("tool.pull"), QKeySequence(QStringLiteral("Shift+J")));
    }

    void aTakenKeyIsRefusedWithItsOwner()
    {
        Fixture fixture;
        fixture.mark("tool.pull");
        QTest::keyClick(fixture.edit("key1"), Qt::Key_F);
        QCOMPARE(fixture.times, 0);
        QVERIFY(fixture.word().contains(fixture.name("brush.radius")));
        QCOMPARE(fixture.edit("key1")->keySequence(), QKeySequence(Qt::Key_1));
        QVERIFY(fixture.mayGo());
        QTest::keyClick(fixture.child<QPushButton>("goToKey"), Qt::Key_Space);
        QCOMPARE(fixture.marked(), QStringLiteral("brush.radius"));
        QVERIFY(!fixture.mayGo() && fixture.word().isEmpty());

        QTest::keyClick(fixture.edit("key1"), Qt::Key_H); // frees F
        fixture.mark("tool.pull");
        QTest::keyClick(fixture.edit("key1"), Qt::Key_F);
        QCOMPARE(fixture.key("tool.pull"), QKeySequence(Qt::Key_F));
        QCOMPARE(fixture.times, 2);
    }

    void itsOwnKeyIsNoConflict()
    {
        Fixture fixture;
        fixture.mark("edit.redo");
        QTest::keyClick(fixture.edit("key2"), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(ShortcutMap(fixture.told).keys(QStringLiteral("edit.redo")).size(), 1);
        QVERIFY(fixture.word().isEmpty());
    }

    void keysThatAreNeededAreRefused_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<Qt::KeyboardModifiers>("held");
        QTest::newRow("Ctrl") << int(Qt::Key_Control) << Qt::KeyboardModifiers(Qt::ControlModifier);
        QTest::newRow("Shift") << int(Qt::Key_Shift) << Qt::KeyboardModifiers(Qt::ShiftModifier);
        QTest::newRow("Alt") << int(Qt::Key_Alt) << Qt::KeyboardModifiers(Qt::AltModifier);
        QTest::newRow("Return") << int(Qt::Key_Return) << Qt::KeyboardModifiers();
        QTest::newRow("Space") << int(Qt::Key_Space) << Qt::KeyboardModifiers();
        QTest::newRow("Down") << int(Qt::Key_Down) << Qt::KeyboardModifiers();
        QTest::newRow("Alt+F") << int(Qt::Key_F) << Qt::KeyboardModifiers(Qt::AltModifier);
    }

    void keysThatAreNeededAreRefused()
    {
        QFETCH(int, key);
        QFETCH(Qt::KeyboardModifiers, held);
        Fixture fixture;
        fixture.mark("tool.pull");
        QTest::keyClick(fixture.edit("key1"), static_cast<Qt::Key>(key), held);
        QCOMPARE(fixture.times, 0);
        QVERIFY(!fixture.word().isEmpty() && !fixture.mayGo());
        QCOMPARE(fixture.edit("key1")->keySequence(), QKeySequence(Qt::Key_1));
    }

    void tabAndEscapeGoOn()
    {
        Fixture fixture;
        QVERIFY(QTest::qWaitForWindowActive(&fixture.page));
        fixture.mark("tool.pull");
        fixture.edit("key1")->setFocus();
        QTest::keyClick(fixture.edit("key1"), Qt::Key_Tab);
        QVERIFY(!fixture.edit("key1")->hasFocus() && fixture.edit("key2")->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(fixture.edit("key2"), Qt::Key_Escape);
        QCOMPARE(fixture.times, 0);
    }

    void escapeIsFixed()
    {
        Fixture fixture;
        fixture.mark("edit.stop");
        QVERIFY(!fixture.edit("key1")->isEnabled() && !fixture.word().isEmpty());
        fixture.mark("tool.pull");
        QVERIFY(fixture.edit("key1")->isEnabled() && fixture.word().isEmpty());
    }

    void presetsAreChosenAndOwnKeysStay()
    {
        Fixture fixture;
        fixture.mark("view.ground");
        QTest::keyClick(fixture.edit("key1"), Qt::Key_H);
        QTest::keyClick(fixture.child<QComboBox>("keyPreset"), Qt::Key_End);
        QCOMPARE(fixture.told.preset, ShortcutPreset::ZBrush);
        QCOMPARE(fixture.shown("brush.radius"), QStringLiteral("S"));
        QCOMPARE(fixture.shown("view.ground"), QStringLiteral("H"));
    }

    void oneAndAllAreReset()
    {
        Fixture fixture;
        auto* resetAll = fixture.child<QPushButton>("resetKeys");
        QVERIFY(!resetAll->isEnabled());
        for (const char* id : {"tool.pull", "tool.push"}) {
            fixture.mark(id);
            QTest::keyClick(fixture.edit("key1"), *id == 't' && fixture.times == 0 ? Qt::Key_H : Qt::Key_1);
        }
        QCOMPARE(fixture.key("tool.push"), QKeySequence(Qt::Key_1)); // the key that Pull had
        fixture.mark("tool.pull");
        fixture.child<QPushButton>("resetKey")->click();
        QVERIFY(fixture.key("tool.pull").isEmpty()); // Push keeps the key, and a message says so
        QVERIFY(fixture.word().contains(fixture.name("tool.push")) && fixture.mayGo());
        QVERIFY(!fixture.child<QPushButton>("resetKey")->isEnabled() && resetAll->isEnabled());
        resetAll->click();
        QCOMPARE(fixture.told, ShortcutSettings());
        QCOMPARE(fixture.key("tool.pull"), QKeySequence(Qt::Key_1));
    }

    void commandsAreFoundByWordAndByKey()
    {
        Fixture fixture;
        for (const QString& words : {fixture.name("view.wireframe"), QStringLiteral("Shift+W")}) {
            fixture.child<QLineEdit>("keyWords")->setText(words);
            QVERIFY(!fixture.list()->itemOf(QStringLiteral("view.wireframe"))->isHidden() || words.contains(u'+'));
            QVERIFY(fixture.list()->itemOf(QStringLiteral("file.open"))->isHidden());
        }
        QCOMPARE(fixture.marked(), QStringLiteral("view.flat"));
    }
};

FETTLE_TEST(TestShortcutsPage, ui::TestApplication)
#include "tst_shortcuts_page.moc"
