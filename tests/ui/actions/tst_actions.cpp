#include "ui/actions/actions.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include "core/stroke/tool.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QSet>

class TestActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void idsAreUnique()
    {
        QSet<QByteArray> ids;
        for (const ui::ActionInfo& row : ui::actionTable()) {
            QVERIFY2(!ids.contains(row.id), row.id);
            ids << row.id;
        }
    }

    void everyRowIsComplete()
    {
        for (const ui::ActionInfo& row : ui::actionTable()) {
            QVERIFY2(*row.text && *row.tip && *row.icon, row.id);
            QVERIFY2(QByteArray(row.tip).endsWith('.'), row.id);
        }
    }

    void shortcutsAreValidAndUnique()
    {
        QMainWindow window;
        const ui::Actions actions(&window);
        QSet<QKeySequence> keys;
        for (const ui::ActionInfo& row : ui::actionTable()) {
            const QList<QKeySequence> own = actions.get(QLatin1StringView(row.id))->shortcuts();
            QCOMPARE(own.size(), *row.keys ? QByteArray(row.keys).count("; ") + 1 : 0);
            for (const QKeySequence& key : own) {
                QVERIFY2(!key.isEmpty() && key[0].key() != Qt::Key_unknown, row.id);
                QVERIFY2(!keys.contains(key), row.id);
                keys << key;
            }
        }
    }

    void theFieldsHabitsOfKeysAreKept()
    {
        QMainWindow window;
        const ui::Actions actions(&window);
        const auto has = [&](const char* id, const char* key) {
            return actions.get(QLatin1StringView(id))->shortcuts().contains(QKeySequence(QLatin1StringView(key)));
        };
        QVERIFY(has("edit.undo", "Ctrl+Z") && has("edit.redo", "Ctrl+Shift+Z") && has("edit.redo", "Ctrl+Y"));
        QVERIFY(has("tool.pull", "1") && has("tool.push", "2") && has("tool.flatten", "3") && has("tool.smooth", "4") &&
                has("tool.paint", "5") && has("symmetry.on", "X"));
        QVERIFY(has("brush.smaller", "[") && has("brush.larger", "]"));
        QVERIFY(has("help.keys", "F1") && has("help.keys", "F3"));
        QVERIFY(has("view.frame", "Home") && has("view.frame", "."));
        QVERIFY(has("view.front", "Num+1") && has("view.right", "Num+3") && has("view.top", "Num+7"));
        QVERIFY(has("view.back", "Ctrl+Num+1") && has("view.left", "Ctrl+Num+3") && has("view.bottom", "Ctrl+Num+7"));
        QVERIFY(has("view.orthographic", "Num+5"));
        QVERIFY(has("vr.enter", "Ctrl+Shift+V"));
    }

    /// The tools have actions in palette order, each with its own icon. A tool's tip mentions the inverting key if the
    /// tool can be inverted.
    void everyToolHasItsAction()
    {
        QList<ui::ActionInfo> rows;
        for (const ui::ActionInfo& row : ui::actionTable())
            if (row.menu == ui::MenuId::Tool)
                rows << row;
        QCOMPARE(static_cast<std::size_t>(rows.size()), core::toolNames().size());
        for (qsizetype i = 0; i < rows.size(); ++i) {
            const auto tool = static_cast<core::Tool>(i);
            const std::string_view name = core::name(tool);
            const auto word = QByteArray(name.data(), static_cast<qsizetype>(name.size()));
            QCOMPARE(QByteArray(rows[i].id), "tool." + word);
            QCOMPARE(QByteArray(rows[i].icon), word);
            QVERIFY2(rows[i].bar == ui::Bar::Tools && rows[i].checkable && *rows[i].keys, rows[i].id);
            const bool turnsRound = core::hasInverse(tool) || tool == core::Tool::Pull || tool == core::Tool::Push;
            QCOMPARE(QByteArray(rows[i].tip).contains("%1"), turnsRound);
        }
    }

    void aRenamedActionIsCalledSoEverywhere()
    {
        QMainWindow window;
        ui::Actions actions(&window);
        const QAction* action = actions.get(QStringLiteral("vr.enter"));
        const QString tip = action->statusTip();
        actions.rename(action->objectName(), QStringLiteral("L&eave"));
        QCOMPARE(action->text(), QStringLiteral("L&eave"));
        QCOMPARE(action->iconText(), QStringLiteral("Leave"));
        QVERIFY(action->toolTip().startsWith(QStringLiteral("Leave (")) && action->toolTip().endsWith(tip));
    }

    void theTableIsWhatTheActionsAre()
    {
        QMainWindow window;
        const ui::Actions actions(&window);
        for (const ui::ActionInfo& row : ui::actionTable()) {
            const QAction* action = actions.get(QLatin1StringView(row.id));
            QCOMPARE(action->objectName(), QLatin1StringView(row.id));
            QVERIFY(!action->text().isEmpty() && !action->toolTip().isEmpty());
            QCOMPARE(action->isCheckable(), row.checkable);
            QMenu menu;
            actions.fill(&menu, row.menu);
            QVERIFY(menu.actions().contains(action));
            QVERIFY(!actions.menuTitle(row.menu).isEmpty());
        }
    }

    void plainWordsHaveNoMarks()
    {
        QCOMPARE(ui::Actions::plain(QStringLiteral("&Open…")), QStringLiteral("Open"));
        QCOMPARE(ui::Actions::plain(QStringLiteral("Ö&ffnen …")), QStringLiteral("Öffnen"));
        QCOMPARE(ui::Actions::plain(QStringLiteral("打开(&O)…")), QStringLiteral("打开"));
    }

    void iconsLoadAndFollowThePalette()
    {
        QMainWindow window;
        const ui::Actions actions(&window);
        const QPalette before = QApplication::palette();
        for (const ui::ActionInfo& row : ui::actionTable()) {
            const QIcon icon = actions.get(QLatin1StringView(row.id))->icon();
            QVERIFY2(!icon.isNull(), row.id);
            QPalette palette = before;
            palette.setColor(QPalette::ButtonText, QColor(10, 200, 30));
            QApplication::setPalette(palette);
            const QImage image = icon.pixmap(QSize(48, 48)).toImage();
            QApplication::setPalette(before);
            int ofPalette = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    ofPalette += image.pixelColor(x, y) == QColor(10, 200, 30);
            QVERIFY2(row.menu == ui::MenuId::New ? inked(image) > 100 && ofPalette == 0 : ofPalette > 20,
                     row.id); // a starter's picture has the clay's colours
        }
    }
};

FETTLE_TEST(TestActions, ui::TestApplication)
#include "tst_actions.moc"
