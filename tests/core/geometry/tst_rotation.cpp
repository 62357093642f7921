#include "core/geometry/rotation.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;

class TestRotation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rotationBetween_takesOneDirectionToTheOther();
    void rotationBetween_opposite_isAHalfTurn();
};

void TestRotation::rotationBetween_takesOneDirectionToTheOther()
{
    StrokeFuzzer random(7);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = random.direction(), b = random.direction();
        const Eigen::Quaterniond turn = rotationBetween(random.uniform(0.1, 9) * a, random.uniform(0.1, 9) * b);
        QVERIFY(std::abs(turn.norm() - 1) < 1e-14);
        QVERIFY((turn * a - b).norm() < 1e-7);
        // No smaller rotation does it: its angle is the one between the vectors.
        QVERIFY(std::abs(Eigen::AngleAxisd(turn).angle() - std::acos(std::clamp(a.dot(b), -1.0, 1.0))) < 1e-7);
    }
}

void TestRotation::rotationBetween_opposite_isAHalfTurn()
{
    StrokeFuzzer random(8);
    for (const double aside : {0.0, 1e-15, 1e-13, 1e-11, 1e-8}) {
        for (int i = 0; i < 100; ++i) {
            const Vec3 a = random.direction(), b = (-a + aside * a.unitOrthogonal()).normalized();
            const Eigen::Quaterniond turn = rotationBetween(a, b);
            QVERIFY(std::abs(turn.norm() - 1) < 1e-14);
            QVERIFY2((turn * a - b).norm() < 1e-7, qPrintable(QString::number(aside)));
        }
    }
}

FETTLE_TEST(TestRotation)
#include "tst_rotation.moc"
