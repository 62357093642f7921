#include "ui/preferences/pressure_curve.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QSignalSpy>

using ui::PressureCurve;

class TestPressureCurve : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void passesWhereItIsDragged()
    {
        PressureCurve curve;
        curve.resize(216, 116); // 200 x 100 pixels inside its margin
        for (const double x : {0.25, 0.5, 0.75})
            for (const double y : {0.3, 0.5, 0.7}) {
                if (const double wanted = std::log(y) / std::log(x);
                    wanted < ui::minPenExponent || wanted > ui::maxPenExponent)
                    continue;
                const QPoint at(8 + qRound(200 * x), 108 - qRound(100 * y));
                sendMouse(&curve, QEvent::MouseButtonPress, at, Qt::LeftButton);
                QVERIFY(std::abs(ui::penPressure(x, curve.exponent()) - y) < 0.01);
            }
    }

    void staysInItsRangeWhereverTheHandGoes()
    {
        PressureCurve curve;
        curve.resize(216, 116);
        QSignalSpy bent(&curve, &PressureCurve::bent);
        for (const QPoint at :
             {QPoint(0, 0), QPoint(215, 0), QPoint(0, 115), QPoint(215, 115), QPoint(-500, 60), QPoint(100, 900)}) {
            sendMouse(&curve, QEvent::MouseMove, at, Qt::LeftButton);
            QVERIFY(curve.exponent() >= ui::minPenExponent && curve.exponent() <= ui::maxPenExponent);
            QCOMPARE(bent.last()[0].toDouble(), curve.exponent());
        }
        curve.setExponent(-1);
        QCOMPARE(curve.exponent(), ui::minPenExponent);
    }

    void keysMakeItSofterAndFirmer()
    {
        PressureCurve curve;
        curve.show();
        QTest::keyClick(&curve, Qt::Key_Up);
        QVERIFY(ui::penPressure(0.5, curve.exponent()) > 0.5);
        QTest::keyClick(&curve, Qt::Key_Down);
        QTest::keyClick(&curve, Qt::Key_Down);
        QVERIFY(ui::penPressure(0.5, curve.exponent()) < 0.5);
    }
};

FETTLE_TEST(TestPressureCurve, ui::TestApplication)
#include "tst_pressure_curve.moc"
