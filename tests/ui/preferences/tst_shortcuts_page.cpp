#include "ui/actions/actions.h"
#include "ui/actions/command_list.h"
#include "ui/preferences/shortcuts_page.h"
#include "ui/widgets/shortcut_edit.h"

#include "tests/ui/ui_test.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalSpy>

using ui::KeyChoice;
using ui::KeyMap;
using ui::KeyPreset;

namespace
{
/// The page as it lies in the dialog, and what it has told.
struct Desk
{
    QMainWindow window;
    ui::Actions actions{&window};
    ui::KeysPage page{actions};
    KeyChoice told;
    int times = 0;

    Desk()
    {
        page.setChoice({});
        QObject::connect(&page, &ui::KeysPage::changed, &page, [this](const KeyChoice& choice) {
            told = choice;
            ++times;
        });
        page.QWidget::show();
        page.activateWindow();
    }

    template <class Widget> Widget* child(const char* name) { return page.findChild<Widget*>(QLatin1StringView(name)); }
    ui::CommandList* list() { return child<ui::CommandList>("keyList"); }
    ui::KeyEdit* edit(const char* name) { return child<ui::KeyEdit>(name); }
    QString word() { return child<QLabel>("keyWord")->text(); }
    bool mayGo() { return child<QPushButton>("goToKey")->isVisible(); }
    void mark(const char* id) { list()->setCurrentItem(list()->itemOf(QLatin1StringView(id))); }
    QString marked() { return ui::CommandList::actionOf(list()->currentItem())->objectName(); }
    QString shown(const char* id) { return list()->itemOf(QLatin1StringView(id))->text(ui::CommandList::Key); }
    QKeySequence key(const char* id) { return KeyMap(told).keys(QLatin1StringView(id)).value(0); }
    QString name(const char* id) { return actions.get(QLatin1StringView(id))->iconText(); }
};
} // namespace

class TestKeysPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyCommandStandsThere()
    {
        Desk desk;
        for (const ui::ActionInfo& row : ui::actionTable()) {
            const QString keys = QKeySequence::listToString(
                ui::presetKeys(KeyPreset::Fettle, QLatin1StringView(row.id)), QKeySequence::NativeText);
            QCOMPARE(desk.shown(row.id), keys);
        }
    }

    void aKeyIsChangedByPressingIt()
    {
        Desk desk;
        desk.mark("tool.pull");
        QTest::keyClick(desk.edit("key1"), Qt::Key_H);
        QCOMPARE(desk.key("tool.pull"), QKeySequence(Qt::Key_H));
        QCOMPARE(desk.shown("tool.pull"), QStringLiteral("H"));
        QTest::keyClick(desk.edit("key2"), Qt::Key_4, Qt::KeypadModifier | Qt::ControlModifier);
        QCOMPARE(KeyMap(desk.told).keys(QStringLiteral("tool.pull")).value(1),
                 QKeySequence(QStringLiteral("Ctrl+Num+4")));
        QTest::keyClick(desk.edit("key1"), Qt::Key_Backspace);
        QCOMPARE(desk.key("tool.pull"), QKeySequence(QStringLiteral("Ctrl+Num+4")));
        QVERIFY(desk.edit("key2")->keySequence().isEmpty());
        QVERIFY(desk.word().isEmpty());
    }

    void shiftThatOnlyChoosesTheSignIsNoPart()
    {
        Desk desk;
        desk.mark("tool.pull");
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Question, Qt::ShiftModifier, QStringLiteral("?"));
        QCoreApplication::sendEvent(desk.edit("key1"), &press);
        QCOMPARE(desk.key("tool.pull"), QKeySequence(Qt::Key_Question));
        QTest::keyClick(desk.edit("key1"), Qt::Key_H, Qt::ShiftModifier);
        QCOMPARE(desk.key("tool.pull"), QKeySequence(QStringLiteral("Shift+H")));
    }

    void aTakenKeyIsRefusedWithItsOwner()
    {
        Desk desk;
        desk.mark("tool.pull");
        QTest::keyClick(desk.edit("key1"), Qt::Key_F);
        QCOMPARE(desk.times, 0);
        QVERIFY(desk.word().contains(desk.name("brush.radius")));
        QCOMPARE(desk.edit("key1")->keySequence(), QKeySequence(Qt::Key_1));
        QVERIFY(desk.mayGo());
        QTest::keyClick(desk.child<QPushButton>("goToKey"), Qt::Key_Space);
        QCOMPARE(desk.marked(), QStringLiteral("brush.radius"));
        QVERIFY(!desk.mayGo() && desk.word().isEmpty());

        QTest::keyClick(desk.edit("key1"), Qt::Key_H); // and now F is free
        desk.mark("tool.pull");
        QTest::keyClick(desk.edit("key1"), Qt::Key_F);
        QCOMPARE(desk.key("tool.pull"), QKeySequence(Qt::Key_F));
        QCOMPARE(desk.times, 2);
    }

    void itsOwnKeyIsNoConflict()
    {
        Desk desk;
        desk.mark("edit.redo");
        QTest::keyClick(desk.edit("key2"), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(KeyMap(desk.told).keys(QStringLiteral("edit.redo")).size(), 1);
        QVERIFY(desk.word().isEmpty());
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
        Desk desk;
        desk.mark("tool.pull");
        QTest::keyClick(desk.edit("key1"), static_cast<Qt::Key>(key), held);
        QCOMPARE(desk.times, 0);
        QVERIFY(!desk.word().isEmpty() && !desk.mayGo());
        QCOMPARE(desk.edit("key1")->keySequence(), QKeySequence(Qt::Key_1));
    }

    void tabAndEscapeGoOn()
    {
        Desk desk;
        QVERIFY(QTest::qWaitForWindowActive(&desk.page));
        desk.mark("tool.pull");
        desk.edit("key1")->setFocus();
        QTest::keyClick(desk.edit("key1"), Qt::Key_Tab);
        QVERIFY(!desk.edit("key1")->hasFocus() && desk.edit("key2")->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(desk.edit("key2"), Qt::Key_Escape);
        QCOMPARE(desk.times, 0);
    }

    void escapeIsFixed()
    {
        Desk desk;
        desk.mark("edit.stop");
        QVERIFY(!desk.edit("key1")->isEnabled() && !desk.word().isEmpty());
        desk.mark("tool.pull");
        QVERIFY(desk.edit("key1")->isEnabled() && desk.word().isEmpty());
    }

    void presetsAreChosenAndOwnKeysStay()
    {
        Desk desk;
        desk.mark("view.ground");
        QTest::keyClick(desk.edit("key1"), Qt::Key_H);
        QTest::keyClick(desk.child<QComboBox>("keyPreset"), Qt::Key_End);
        QCOMPARE(desk.told.preset, KeyPreset::ZBrush);
        QCOMPARE(desk.shown("brush.radius"), QStringLiteral("S"));
        QCOMPARE(desk.shown("view.ground"), QStringLiteral("H"));
    }

    void oneAndAllAreReset()
    {
        Desk desk;
        auto* resetAll = desk.child<QPushButton>("resetKeys");
        QVERIFY(!resetAll->isEnabled());
        for (const char* id : {"tool.pull", "tool.push"}) {
            desk.mark(id);
            QTest::keyClick(desk.edit("key1"), *id == 't' && desk.times == 0 ? Qt::Key_H : Qt::Key_1);
        }
        QCOMPARE(desk.key("tool.push"), QKeySequence(Qt::Key_1)); // which Pull had
        desk.mark("tool.pull");
        desk.child<QPushButton>("resetKey")->click();
        QVERIFY(desk.key("tool.pull").isEmpty()); // Push keeps it, and that is said
        QVERIFY(desk.word().contains(desk.name("tool.push")) && desk.mayGo());
        QVERIFY(!desk.child<QPushButton>("resetKey")->isEnabled() && resetAll->isEnabled());
        resetAll->click();
        QCOMPARE(desk.told, KeyChoice());
        QCOMPARE(desk.key("tool.pull"), QKeySequence(Qt::Key_1));
    }

    void commandsAreFoundByWordAndByKey()
    {
        Desk desk;
        for (const QString& words : {desk.name("view.wireframe"), QStringLiteral("Shift+W")}) {
            desk.child<QLineEdit>("keyWords")->setText(words);
            QVERIFY(!desk.list()->itemOf(QStringLiteral("view.wireframe"))->isHidden() || words.contains(u'+'));
            QVERIFY(desk.list()->itemOf(QStringLiteral("file.open"))->isHidden());
        }
        QCOMPARE(desk.marked(), QStringLiteral("view.flat"));
    }
};

UI_TEST_MAIN(TestKeysPage)
#include "tst_shortcuts_page.moc"
