#include "ui/actions.h"
#include "ui/main_window.h"
#include "ui/settings.h"
#include "ui/start_page.h"

#include "ui_test.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryFile>
#include <QToolButton>

using ui::MainWindow;
using ui::StartPage;

class TestStartPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QSettings().clear(); }

    void itComesWhenAskedAndGoes()
    {
        MainWindow window;
        StartPage* page = shownIn(window, false);
        QVERIFY(!page->isVisible());
        window.action(QStringLiteral("help.start"))->trigger();
        QVERIFY(page->isVisible() && window.centralWidget()->rect().contains(page->geometry()));
        QVERIFY(page->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!page->isVisible());
        window.action(QStringLiteral("help.start"))->trigger();
        page->findChild<QToolButton*>(QStringLiteral("startClose"))->click();
        QVERIFY(!page->isVisible());
        window.action(QStringLiteral("help.start"))->trigger();
        sendMouse(window.centralWidget(), QEvent::MouseButtonPress, {3, 3}, Qt::LeftButton);
        QVERIFY(!page->isVisible());
    }

    void everyStarterIsThere()
    {
        MainWindow window;
        StartPage* page = shownIn(window, true);
        const QSignalSpy requested(&window, &MainWindow::starterRequested);
        for (const ui::ActionInfo& row : ui::actionTable()) {
            if (row.menu != ui::MenuId::New)
                continue;
            page->open();
            auto* button = page->findChild<QToolButton*>(QStringLiteral("start.") + QLatin1StringView(row.id));
            QVERIFY2(button, row.id);
            const auto before = requested.size();
            QTest::keyClick(button, Qt::Key_Space);
            QCOMPARE(requested.size(), before + 1);
            QVERIFY(!page->isVisible());
        }
        QCOMPARE(requested.size(), 7);
    }

    void recentFilesAreOpened()
    {
        QTemporaryFile file;
        QVERIFY(file.open());
        ui::Settings().setRecentFiles({QStringLiteral("/no/such.stl"), file.fileName()});
        MainWindow window;
        StartPage* page = shownIn(window, true);
        auto* list = page->findChild<QListWidget*>(QStringLiteral("startRecent"));
        QCOMPARE(list->count(), 1);
        const QSignalSpy requested(&window, &MainWindow::openRequested);
        Q_EMIT list->itemActivated(list->item(0));
        QCOMPARE(requested.size(), 1);
        QCOMPARE(requested[0][0].toString(), file.fileName());
        QVERIFY(!page->isVisible());
    }

    void withoutRecentFilesNothingCanBeChosen()
    {
        MainWindow window;
        auto* list = shownIn(window, true)->findChild<QListWidget*>(QStringLiteral("startRecent"));
        QCOMPARE(list->count(), 1);
        QVERIFY(!(list->item(0)->flags() & Qt::ItemIsEnabled));
    }

    void lessonsOpenInTheGuide()
    {
        MainWindow window;
        StartPage* page = shownIn(window, true);
        for (const char* id : {"lesson-vase", "lesson-head", "lesson-tablet"}) {
            page->open();
            auto* button = page->findChild<QToolButton*>(QStringLiteral("start.") + QLatin1StringView(id));
            QVERIFY2(button && !button->icon().isNull(), id);
            button->click();
            auto* guide = window.findChild<QDialog*>(QStringLiteral("guide"));
            QVERIFY(guide && guide->isVisible() && !page->isVisible());
            QVERIFY(guide->findChild<QListWidget*>()->currentItem()->text().contains(button->text()));
        }
    }

    void whetherItIsShownIsRemembered()
    {
        QVERIFY(ui::Settings().showsStartPage());
        MainWindow window;
        auto* box = shownIn(window, true)->findChild<QCheckBox*>(QStringLiteral("startAlways"));
        QVERIFY(box->isChecked());
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(!ui::Settings().showsStartPage());
    }

    void everyControlHasANameAndATip()
    {
        MainWindow window;
        int controls = 0;
        for (const QWidget* widget : shownIn(window, true)->findChildren<QWidget*>()) {
            if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().isEmpty() || widget->objectName().startsWith(QLatin1StringView("qt_")))
                continue;
            ++controls;
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()), qPrintable(widget->objectName()));
            QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
        }
        QVERIFY(controls >= 14);
    }

private:
    static StartPage* shownIn(MainWindow& window, bool isOpen)
    {
        window.resize(1280, 690);
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window))
            qWarning("the window is not active");
        auto* page = window.findChild<StartPage*>();
        if (isOpen)
            page->open();
        return page;
    }
};

UI_TEST_MAIN(TestStartPage)
#include "tst_start_page.moc"
