// Tests a resting hand that sculpts while the model turns under it (paper, section 3.5.4).
#include "vr/sculpt/brush_state.h"

#include "tests/support/clay.h"
#include "tests/support/test_main.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/mesh/mesh_builder.h"

#include <QTest>

#include <numbers>

using core::Vec3;
using vr::ModelPlacement;
using vr::Pose;

namespace
{
constexpr double pi = std::numbers::pi;
constexpr double ringHeight = 0.4; ///< height of the ring on a ball of radius 1
const double ringRadius = std::sqrt(1 - ringHeight * ringHeight);
constexpr int frames = 540; ///< frames of one turn: 6 seconds at 90 frames per second
/// Number of turns. One is too few, because the place where the stroke begins gets only half as many dabs in it.
constexpr int turns = 2;

/// Returns a ball with a protrusion at one side, below the ring.
std::unique_ptr<core::Sculptor> ballWithALug()
{
    auto sculptor = clay::unitBall();
    core::StrokeSettings lug;
    lug.radius = 0.4;
    lug.add = lug.join = true;
    clay::dabOnce(*sculptor, lug, {1.1, -0.5, 0});
    return sculptor;
}

Pose tilted(double degrees)
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(degrees * pi / 180, Vec3(1, 0, 1).normalized())), Vec3::Zero()};
}
} // namespace

class TestTurnedModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aRestingHand_makesAnEvenRing_data();
    void aRestingHand_makesAnEvenRing();
};

void TestTurnedModel::aRestingHand_makesAnEvenRing_data()
{
    QTest::addColumn<double>("tilt");
    QTest::addColumn<double>("radius");
    for (const double tilt : {0.0, 20.0, 60.0})
        for (const double radius : {0.15, 0.3})
            QTest::addRow("tilted by %g degrees, radius %g", tilt, radius) << tilt << radius;
}

/// Checks that a resting brush cuts an even ring, because the model turns about the document's Y axis even if its
/// middle has moved and it is tilted.
void TestTurnedModel::aRestingHand_makesAnEvenRing()
{
    QFETCH(double, tilt);
    QFETCH(double, radius);
    const auto sculptor = ballWithALug();
    ModelPlacement placement(core::boxOf(core::extractMesh(sculptor->mesh())));
    placement.place({Eigen::Quaterniond::Identity(), {0, 1.7, 0}});
    placement.move({}, tilted(tilt));
    vr::BrushState brush;
    brush.radius = placement.lengthToRoom(radius);
    const core::StrokeSettings settings = vr::strokeSettings(brush, {}, placement);
    vr::StrokePoint hand;
    hand.tip.position = placement.toRoom({ringRadius, ringHeight, 0});

    sculptor->beginStroke(settings);
    for (int i = 0; i < turns * frames; ++i, placement.turn(2 * pi / frames)) {
        hand.time = i / 90.0;
        for (const core::DabReport& dab : sculptor->addSample(vr::strokeSample(brush, hand, placement)))
            QVERIFY2(dab.outcome == core::DabOutcome::Committed && dab.isWhole(), qPrintable(QString::number(i)));
    }
    sculptor->endStroke();
    QVERIFY(core::checkMesh(core::extractMesh(sculptor->mesh())).printReady());

    double least = std::numeric_limits<double>::max(), most = 0;
    for (int i = 0; i < frames; ++i) {
        const Vec3 out = Eigen::AngleAxisd(2 * pi * i / frames, Vec3::UnitY()) * Vec3::UnitX();
        const Vec3 from = 4 * out + ringHeight * Vec3::UnitY();
        const std::optional<core::SurfaceHit> hit = sculptor->hit({from, -out});
        QVERIFY(hit);
        least = std::min(least, 4 - hit->distance);
        most = std::max(most, 4 - hit->distance);
    }
    QVERIFY(least > ringRadius + 0.05 * radius);
    QVERIFY2(most - least < 0.01 * most, qPrintable(QStringLiteral("%1 to %2").arg(least).arg(most)));
}

FETTLE_TEST(TestTurnedModel, QCoreApplication)
#include "tst_turned_model.moc"
