// Shows the hint, the banner and a card over a view, and looks at what covers what.

#include "tests/support/test_main.h"
#include "ui/widgets/notification_banner.h"
#include "ui/widgets/view_card.h"
#include "ui/widgets/view_hint.h"

#include <QApplication>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>

class TestViewOverlays : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void banner_staysAboveACard();
    void hint_leavesTheCornersFree();
};

void TestViewOverlays::banner_staysAboveACard()
{
    QWidget window;
    window.resize(500, 400);
    auto* view = new QWidget(&window);
    view->setGeometry(window.rect());
    auto* card = new ui::ViewCard(view, "card");
    auto* rows = new QVBoxLayout(card);
    for (int i = 0; i < 4; ++i)
        rows->addWidget(new QPushButton(QStringLiteral("A button with a long text")));
    ui::NotificationBanner banner(&window);
    window.show();
    banner.showMessage(QStringLiteral("A sentence that is wide enough to reach the card in the corner."));
    const QRect alone = banner.geometry();
    QVERIFY(alone.bottom() > window.height() - 30);
    card->show();
    QVERIFY(card->geometry().intersects(alone));
    banner.showMessage(banner.text());
    QVERIFY(!card->geometry().intersects(banner.geometry()));
    QVERIFY(window.rect().contains(banner.geometry()));
    card->hide();
    banner.showMessage(banner.text());
    QCOMPARE(banner.geometry(), alone);
}

/// The cube that turns the view is 88 pixels wide, 4 from the corner.
void TestViewOverlays::hint_leavesTheCornersFree()
{
    QWidget view;
    view.resize(480, 300);
    view.show();
    ui::ViewHint hint("hint", &view);
    hint.showText(QStringLiteral("Short."), view.width());
    const QRect inOneLine = hint.geometry();
    hint.showText(QStringLiteral("This hint says so much that it does not fit into one line between the corners."),
                  view.width());
    QVERIFY(hint.geometry().right() < view.width() - 92 && hint.x() > 92);
    QVERIFY(hint.height() > inOneLine.height());
    QVERIFY(hint.height() >= hint.heightForWidth(hint.width()));
}

FETTLE_TEST(TestViewOverlays, QApplication)

#include "tst_view_overlays.moc"
