#include "ui/history/recovery_bar.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QLabel>
#include <QMainWindow>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>

using ui::RecoveryBar;

class TestRecoveryBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void offer_saysWhatWhenAndHowMuch();
    void longNames_leaveRoomForTheButtons();
    void buttons_areReachedByKeys();
    void later_takesTheBarAway();
    void discarding_isAskedOnce_data();
    void discarding_isAskedOnce();

private:
    QPushButton* button(const char* name) const { return m_bar->findChild<QPushButton*>(QLatin1StringView(name)); }

    std::unique_ptr<QMainWindow> m_window;
    QPointer<RecoveryBar> m_bar;
};

void TestRecoveryBar::init()
{
    m_window = std::make_unique<QMainWindow>();
    m_window->resize(1280, 720);
    m_bar = new RecoveryBar({QStringLiteral("vase.glb"), QDateTime({2026, 11, 22}, {14, 3}), 12}, m_window.get());
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
}

void TestRecoveryBar::offer_saysWhatWhenAndHowMuch()
{
    const QString words = m_bar->findChild<QLabel*>(QStringLiteral("recoveryText"))->text();
    QVERIFY(m_bar->isVisible());
    for (const char* part : {"vase.glb", "12", "14:03"})
        QVERIFY2(words.contains(QLatin1StringView(part)), qPrintable(words));
}

void TestRecoveryBar::longNames_leaveRoomForTheButtons()
{
    m_bar->dismiss();
    m_bar = new RecoveryBar({QString(300, QLatin1Char('m')), QDateTime::currentDateTime(), 1}, m_window.get());
    QTRY_VERIFY(m_bar->isVisible());
    QCOMPARE(m_window->width(), 1280);
    for (const char* name : {"recover", "discardRecovery", "recoverLater"})
        QTRY_VERIFY2(m_bar->rect().contains(QRect(button(name)->mapTo(m_bar, QPoint()), button(name)->size())), name);
}

void TestRecoveryBar::buttons_areReachedByKeys()
{
    QSignalSpy wanted(m_bar, &RecoveryBar::recoverRequested);
    for (const char* name : {"recover", "discardRecovery", "recoverLater"}) {
        QVERIFY(!button(name)->toolTip().isEmpty() && !button(name)->accessibleName().isEmpty());
        QVERIFY(button(name)->focusPolicy() & Qt::TabFocus);
    }
    QTest::keyClick(button("recover"), Qt::Key_Space);
    QCOMPARE(wanted.size(), 1);
    QVERIFY(m_bar->isVisible()); // stays until the recovery is finished
}

void TestRecoveryBar::later_takesTheBarAway()
{
    QSignalSpy discarded(m_bar, &RecoveryBar::discardRequested);
    QTest::mouseClick(button("recoverLater"), Qt::LeftButton);
    QTRY_VERIFY(!m_bar);
    QCOMPARE(discarded.size(), 0);
}

void TestRecoveryBar::discarding_isAskedOnce_data()
{
    QTest::addColumn<bool>("yes");
    QTest::newRow("removed") << true;
    QTest::newRow("kept after all") << false;
}

void TestRecoveryBar::discarding_isAskedOnce()
{
    QFETCH(bool, yes);
    QSignalSpy discarded(m_bar, &RecoveryBar::discardRequested);
    QTest::mouseClick(button("discardRecovery"), Qt::LeftButton);
    QMessageBox* question = nullptr;
    QTRY_VERIFY((question = m_bar->findChild<QMessageBox*>(QStringLiteral("discardRecoveryQuestion"))) &&
                question->isVisible());
    QVERIFY(question->text().contains(QStringLiteral("vase.glb")));
    QCOMPARE(question->defaultButton(), question->button(QMessageBox::Cancel));
    for (QAbstractButton* each : question->buttons())
        if ((question->buttonRole(each) == QMessageBox::DestructiveRole) == yes) {
            QTest::mouseClick(each, Qt::LeftButton);
            break;
        }
    QTRY_COMPARE(discarded.size(), yes ? 1 : 0);
    QVERIFY(m_bar->isVisible());
}

FETTLE_TEST(TestRecoveryBar, ui::TestApplication)
#include "tst_recovery_bar.moc"
