#include "ui/preferences/pressure_test.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QTabletEvent>

using ui::PressureTest;

namespace
{
void drawAcross(PressureTest& field, double pressure,
                QPointingDevice::PointerType type = QPointingDevice::PointerType::Pen)
{
    const QPointingDevice pen(QStringLiteral("pen"), 1, QInputDevice::DeviceType::Stylus, type,
                              QInputDevice::Capability::Pressure, 1, 1);
    const auto send = [&](QEvent::Type kind, const QPointF& at) {
        QTabletEvent event(kind, &pen, at, field.mapToGlobal(at), pressure, 0, 0, 0, 0, 0, Qt::NoModifier,
                           Qt::LeftButton, Qt::LeftButton);
        QCoreApplication::sendEvent(&field, &event);
        QVERIFY(event.isAccepted());
    };
    send(QEvent::TabletPress, {20, 80});
    send(QEvent::TabletMove, {180, 80});
}

/// Returns the width of the line in the middle of the field, pixels.
int width(PressureTest& field)
{
    const QImage picture = field.grab().toImage();
    const QRgb base = field.palette().base().color().rgb();
    int count = 0;
    for (int y = 50; y < 110; ++y)
        count += picture.pixel(100, y) != base;
    return count;
}
} // namespace

class TestPressureTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhichDeviceDraws()
    {
        PressureTest field;
        const QString invitation = field.words();
        drawAcross(field, 0.5);
        QCOMPARE(field.words(), QStringLiteral("Pen: 0.50"));
        drawAcross(field, 0.25, QPointingDevice::PointerType::Eraser);
        QCOMPARE(field.words(), QStringLiteral("Eraser: 0.25"));
        sendMouse(&field, QEvent::MouseButtonPress, {20, 20}, Qt::LeftButton);
        QCOMPARE(field.words(), QStringLiteral("Mouse: no pressure"));
        QVERIFY(!invitation.isEmpty() && invitation != field.words());
        QCOMPARE(field.accessibleDescription(), field.words());
    }

    void theLineIsAsWideAsWhatThePressureCounts()
    {
        const auto widthOf = [](double pressure, double exponent) {
            PressureTest field;
            field.resize(200, 140);
            field.setExponent(exponent);
            drawAcross(field, pressure);
            return width(field);
        };
        QVERIFY(widthOf(0.2, 1) > 0);
        QVERIFY(widthOf(0.8, 1) > widthOf(0.2, 1));
        QVERIFY(widthOf(0.5, 0.5) > widthOf(0.5, 1));
        QVERIFY(widthOf(0.5, 1) > widthOf(0.5, 2));
        QCOMPARE(widthOf(1, 0.5), widthOf(1, 2));
    }
};

FETTLE_TEST(TestPressureTest, ui::TestApplication)
#include "tst_pressure_test.moc"
