#include "ui/viewport/drawn_curve.h"

#include "tests/support/test_main.h"

#include <QLineF>
#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using ui::CurveShape;

namespace
{
constexpr QSizeF view{800, 600};

double distanceTo(const QPolygonF& curve, const QPointF& p)
{
    double least = 1e300;
    for (qsizetype i = 0; i + 1 < curve.size(); ++i) {
        const QPointF way = curve[i + 1] - curve[i];
        const double squared = QPointF::dotProduct(way, way);
        const double share = squared > 0 ? std::clamp(QPointF::dotProduct(p - curve[i], way) / squared, 0.0, 1.0) : 0.0;
        least = std::min(least, QLineF(curve[i] + share * way, p).length());
    }
    return least;
}
} // namespace

class TestDrawnCurve : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void box_hasItsCorners()
    {
        const QPolygonF box = curveBetween(CurveShape::Box, {300, 50}, {100, 200}, view);
        QCOMPARE(box.size(), 4);
        QCOMPARE(box.boundingRect(), QRectF(100, 50, 200, 150));
        QVERIFY(curveBetween(CurveShape::Box, {10, 20}, {10, 90}, view).isEmpty());
    }

    /// Seen along the line, the tinted side is on the right.
    void line_takesTheRightSide()
    {
        std::mt19937 engine(3);
        std::uniform_real_distribution<double> x(0, view.width()), y(0, view.height());
        for (int i = 0; i < 200; ++i) {
            const QPointF from(x(engine), y(engine)), to(x(engine), y(engine)), p(x(engine), y(engine));
            const QPolygonF side = curveBetween(CurveShape::Line, from, to, view);
            const QPointF way = to - from, off = p - from;
            const double right = way.x() * off.y() - way.y() * off.x(); // y is down
            if (std::abs(right) > 1)
                QCOMPARE(side.containsPoint(p, Qt::WindingFill), right > 0);
        }
        QVERIFY(curveBetween(CurveShape::Line, {10, 20}, {10, 20}, view).isEmpty());
    }

    void simplified_staysWithinAPixel()
    {
        QPolygonF lasso;
        for (int i = 0; i < 1000; ++i) {
            const double angle = 2 * std::numbers::pi * i / 1000;
            lasso << QPointF(400 + 200 * std::cos(angle), 300 + 150 * std::sin(3 * angle));
        }
        const QPolygonF fewer = ui::simplified(lasso);
        QVERIFY2(fewer.size() < 200, qPrintable(QString::number(fewer.size())));
        QCOMPARE(fewer.front(), lasso.front());
        QCOMPARE(fewer.back(), lasso.back());
        for (const QPointF& p : lasso)
            QVERIFY(distanceTo(fewer, p) <= 1.0000001);
    }

    /// A mouse tells whole pixels.
    void simplified_hasNoSteps()
    {
        for (const double slope : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0}) {
            QPolygonF line;
            for (int x = 0; x < 300; ++x)
                line << QPointF(x, std::round(slope * x));
            QCOMPARE(ui::simplified(line).size(), 2);
        }
    }

    void simplified_keepsCorners()
    {
        QPolygonF square;
        for (int side = 0; side < 4; ++side)
            for (int i = 0; i < 50; ++i)
                square << QPointF(side == 0   ? i
                                  : side == 1 ? 50
                                  : side == 2 ? 50 - i
                                              : 0,
                                  side == 0   ? 0
                                  : side == 1 ? i
                                  : side == 2 ? 50
                                              : 50 - i);
        QCOMPARE(ui::simplified(square).size(), 5); // the last point is one pixel before the first
        QCOMPARE(ui::simplified(QPolygonF({{0, 0}, {1, 1}})).size(), 2);
        QCOMPARE(ui::simplified({}).size(), 0);
    }
};

FETTLE_TEST(TestDrawnCurve)
#include "tst_drawn_curve.moc"
