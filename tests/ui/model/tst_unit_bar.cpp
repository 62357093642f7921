#include "ui/model/unit_bar.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolBar>

using core::UnitDoubt;
using ui::UnitBar;

class TestUnitBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void guess_hasItsReasonAndIsTheDefault_data();
    void guess_hasItsReasonAndIsTheDefault();
    void buttons_giveTheirUnit_data();
    void buttons_giveTheirUnit();
    void millimetres_takeTheBarAway();
    void leaving_givesTheFocusBack();
    void longNames_leaveRoomForTheButtons();
    void theView_staysWhereItIs();
    void narrowViews_getTwoLines();

private:
    void show(const QString& name, UnitDoubt guess)
    {
        m_bar = new UnitBar({name, 1.5, guess}, m_window.get());
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }
    QPushButton* button(const char* name) const { return m_bar->findChild<QPushButton*>(QLatin1StringView(name)); }

    std::unique_ptr<QMainWindow> m_window;
    QPointer<UnitBar> m_bar;
};

void TestUnitBar::init()
{
    m_window = std::make_unique<QMainWindow>();
    m_window->resize(1280, 720);
    auto* centre = new QWidget;
    centre->setFocusPolicy(Qt::StrongFocus);
    m_window->setCentralWidget(centre);
}

void TestUnitBar::guess_hasItsReasonAndIsTheDefault_data()
{
    QTest::addColumn<UnitDoubt>("guess");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("reason");
    QTest::newRow("inches") << UnitDoubt::Inches << QStringLiteral("asInches")
                            << QStringList{QStringLiteral("inches"), QStringLiteral("(38.1 mm)?")};
    QTest::newRow("metres") << UnitDoubt::Metres << QStringLiteral("asMetres")
                            << QStringList{QStringLiteral("metres"), QStringLiteral("(1,500 mm)?")};
}

void TestUnitBar::guess_hasItsReasonAndIsTheDefault()
{
    QFETCH(UnitDoubt, guess);
    QFETCH(QString, name);
    QFETCH(QStringList, reason);
    show(QStringLiteral("part.stl"), guess);
    const QString words = m_bar->findChild<QLabel*>(QStringLiteral("unitText"))->text();
    reason << QStringLiteral("part.stl") << QStringLiteral("1.5 units");
    for (const QString& part : std::as_const(reason))
        QVERIFY2(words.contains(part), qPrintable(words));
    for (const QPushButton* each : m_bar->findChildren<QPushButton*>())
        QCOMPARE(each->isDefault(), each->objectName() == name);
}

void TestUnitBar::buttons_giveTheirUnit_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("key");
    QTest::addColumn<double>("millimetres");
    QTest::newRow("metres") << QStringLiteral("asMetres") << int(Qt::Key_Return) << 1000.0;
    QTest::newRow("inches") << QStringLiteral("asInches") << int(Qt::Key_Space) << 25.4;
    QTest::newRow("centimetres") << QStringLiteral("asCentimetres") << int(Qt::Key_Return) << 10.0;
}

/// The buttons can be reached by Tab from the view.
void TestUnitBar::buttons_giveTheirUnit()
{
    QFETCH(QString, name);
    QFETCH(int, key);
    QFETCH(double, millimetres);
    show(QStringLiteral("part.stl"), UnitDoubt::Inches);
    QSignalSpy chosen(m_bar, &UnitBar::unitChosen);
    m_window->centralWidget()->setFocus();
    QPushButton* wanted = button(qPrintable(name));
    QVERIFY(!wanted->toolTip().isEmpty() && !wanted->accessibleName().isEmpty());
    for (int i = 0; i < 5 && !wanted->hasFocus(); ++i)
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QVERIFY(wanted->hasFocus());
    QTest::keyClick(wanted, static_cast<Qt::Key>(key));
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen[0][0].toDouble(), millimetres);
    QVERIFY(m_bar->isVisible()); // stays until the model has been scaled
}

void TestUnitBar::millimetres_takeTheBarAway()
{
    show(QStringLiteral("part.stl"), UnitDoubt::Inches);
    QSignalSpy chosen(m_bar, &UnitBar::unitChosen);
    QTest::mouseClick(button("asMillimetres"), Qt::LeftButton);
    QTRY_VERIFY(!m_bar);
    QCOMPARE(chosen.size(), 0);
}

void TestUnitBar::leaving_givesTheFocusBack()
{
    show(QStringLiteral("part.stl"), UnitDoubt::Inches);
    button("asMillimetres")->setFocus();
    QTest::keyClick(button("asMillimetres"), Qt::Key_Return);
    QTRY_VERIFY(!m_bar);
    QVERIFY(m_window->centralWidget()->hasFocus());
}

void TestUnitBar::longNames_leaveRoomForTheButtons()
{
    show(QString(300, QLatin1Char('m')), UnitDoubt::Metres);
    QCOMPARE(m_window->width(), 1280);
    for (const char* name : {"asMetres", "asInches", "asCentimetres", "asMillimetres"})
        QTRY_VERIFY2(m_bar->rect().contains(QRect(button(name)->mapTo(m_bar, QPoint()), button(name)->size())), name);
}

/// Two bars are shown one below the other, over the top of the view, whose size does not change.
void TestUnitBar::theView_staysWhereItIs()
{
    m_window->addToolBar(QStringLiteral("Tools"))->addAction(QStringLiteral("A tool"));
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    const QRect view = m_window->centralWidget()->geometry();
    show(QStringLiteral("part.stl"), UnitDoubt::Inches);
    const QPointer<UnitBar> first = m_bar;
    show(QStringLiteral("other.stl"), UnitDoubt::Metres);
    QTRY_VERIFY(first->isVisible() && m_bar->isVisible());
    QCOMPARE(m_window->centralWidget()->geometry(), view);
    QCOMPARE(first->geometry().topLeft(), view.topLeft());
    QCOMPARE(first->width(), view.width());
    QTRY_VERIFY(first->height() >= first->sizeHint().height());
    QCOMPARE(m_bar->y(), first->y() + first->height());
    m_window->resize(1000, 700);
    QTRY_COMPARE(m_bar->width(), m_window->centralWidget()->width());
    first->dismiss();
    QCOMPARE(m_bar->y(), m_window->centralWidget()->y());
}

/// The bar does not cover a panel beside the view. If the view is narrow, the buttons move below the text, and back
/// when it widens.
void TestUnitBar::narrowViews_getTwoLines()
{
    auto* column = new QDockWidget;
    column->setWidget(new QLabel(QStringLiteral("A panel of some width")));
    m_window->addDockWidget(Qt::RightDockWidgetArea, column);
    show(QString(300, QLatin1Char('m')), UnitDoubt::Inches);
    const auto* words = m_bar->findChild<QLabel*>(QStringLiteral("unitText"));
    const auto isWithin = [&](const QWidget* part) {
        return m_bar->rect().contains(QRect(part->mapTo(m_bar, QPoint()), part->size()));
    };
    for (const int width : {1280, 700, 1280}) {
        m_window->resize(width, 500);
        QTRY_COMPARE(m_window->width(), width);
        QTRY_COMPARE(m_bar->geometry().right(), m_window->centralWidget()->geometry().right());
        for (const QPushButton* each : m_bar->findChildren<QPushButton*>()) {
            QTRY_VERIFY2(isWithin(each), qPrintable(each->objectName()));
            QTRY_COMPARE(each->y() >= words->geometry().bottom(), width == 700);
        }
        QTRY_VERIFY(isWithin(words) && words->height() >= words->heightForWidth(words->width()));
    }
}

FETTLE_TEST(TestUnitBar, ui::TestApplication)
#include "tst_unit_bar.moc"
