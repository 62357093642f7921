#include "ui/viewport/turntable.h"

#include "tests/support/test_main.h"

#include <QSignalSpy>
#include <QTest>

#include <numbers>

using ui::Turntable;

class TestTurntable : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itTurnsWhileItIsOn()
    {
        Turntable turntable;
        QSignalSpy turned(&turntable, &Turntable::turned);
        turntable.setSpeed(90);
        for (const bool clockwise : {false, true}) {
            turntable.setClockwise(clockwise);
            turntable.setOn(true);
            turned.clear();
            QTRY_VERIFY(turned.size() >= 3);
            turntable.setOn(false);
            for (const QList<QVariant>& step : turned) {
                const double angle = step[0].toDouble(), seconds = step[1].toDouble();
                QVERIFY(seconds > 0);
                QVERIFY(std::abs(angle - (clockwise ? -1 : 1) * seconds * std::numbers::pi / 2) < 1e-12);
            }
            const auto steps = turned.size();
            QTest::qWait(60);
            QCOMPARE(turned.size(), steps);
        }
    }

    /// After the window was blocked for a second, the turntable does not catch up with a jump.
    void aStallIsNoJump()
    {
        Turntable turntable;
        QSignalSpy turned(&turntable, &Turntable::turned);
        turntable.setSpeed(90);
        turntable.setOn(true);
        QTest::qSleep(1000);
        QTRY_VERIFY(!turned.isEmpty());
        QVERIFY(turned[0][0].toDouble() < std::numbers::pi / 8);
    }

    void whatItIsToldStaysSensible()
    {
        Turntable turntable;
        QSignalSpy changed(&turntable, &Turntable::changed);
        turntable.setSpeed(-5);
        QCOMPARE(turntable.speed(), ui::minTurn);
        turntable.setSpeed(1e9);
        QCOMPARE(turntable.speed(), ui::maxTurn);
        QCOMPARE(changed.size(), 2);
        turntable.setSpeed(1e9);
        turntable.setOn(false);
        QCOMPARE(changed.size(), 2);
    }
};

FETTLE_TEST(TestTurntable, QCoreApplication)
#include "tst_turntable.moc"
