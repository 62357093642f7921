#include "vr/input/model_placement.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <numbers>
#include <random>

using core::Vec3;
using vr::ModelPlacement;
using vr::Pose;

namespace
{
constexpr double tolerance = 1e-9;
constexpr double pi = std::numbers::pi;
constexpr unsigned placementSeed = 20261122;
const core::Box someBox(Vec3(-30, -10, -50), Vec3(40, 60, 20));
const std::vector<Vec3> somePoints{{0, 0, 0}, {40, 60, 20}, {-30, 0, -50}, {7, -3, 11}};

/// Returns the pose of a head at `from`, with yaw and pitch in radians.
Pose looking(const Vec3& from, double yaw, double pitch)
{
    return {Eigen::AngleAxisd(yaw, Vec3::UnitY()) * Eigen::AngleAxisd(pitch, Vec3::UnitX()), from};
}

/// Returns a placement in front of a person who stands at the origin and looks along -Z.
ModelPlacement placed(const core::Box& box = someBox)
{
    ModelPlacement placement(box);
    placement.place(looking({0, 1.7, 0}, 0, 0));
    return placement;
}

bool areClose(const Vec3& a, const Vec3& b)
{
    return (a - b).norm() <= tolerance * (1 + a.norm());
}

class Random
{
public:
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(m_engine); }
    Vec3 point(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
    Pose pose() { return {Eigen::Quaterniond(Eigen::AngleAxisd(between(0, pi), point(1).normalized())), point(2)}; }
    /// Returns a random pose near another.
    Pose near(const Pose& pose)
    {
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(between(-0.3, 0.3), point(1).normalized()));
        return {turn * pose.rotation, pose.position + point(0.1)};
    }

private:
    std::mt19937 m_engine{placementSeed};
};

double shownSize(const ModelPlacement& placement, const core::Box& box = someBox)
{
    return placement.lengthToRoom(box.sizes().maxCoeff());
}

bool isSound(const ModelPlacement& placement)
{
    const double size = shownSize(placement);
    return std::abs(placement.rotation().norm() - 1) < 1e-12 && size >= ModelPlacement::minSize * (1 - tolerance) &&
           size <= ModelPlacement::maxSize * (1 + tolerance) && placement.toRoom(someBox.center()).allFinite();
}
} // namespace

class TestModelPlacement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Checks that the model's front is upright before the user's eyes, for many head poses.
    void aModelIsPlacedBeforeTheEyes()
    {
        for (const double height : {1.75, 1.15, 0.0})
            for (const double yaw : {0.0, 1.0, 2.5, -2.0, pi})
                for (const double pitch : {0.0, -0.7, 0.7, -pi / 2, pi / 2, -1.8}) {
                    const Vec3 eyes(1.5, height, -0.5);
                    ModelPlacement placement(someBox);
                    placement.turn(0.3);
                    placement.place(looking(eyes, yaw, pitch));
                    const Vec3 ahead = Eigen::AngleAxisd(yaw, Vec3::UnitY()) * -Vec3::UnitZ();
                    QVERIFY(areClose(placement.middle(), eyes + ModelPlacement::comfortableReach * ahead -
                                                             ModelPlacement::belowEyes * Vec3::UnitY()));
                    QVERIFY(areClose(placement.directionToRoom(Vec3::UnitY()), Vec3::UnitY()));
                    QVERIFY(areClose(placement.directionToRoom(Vec3::UnitZ()), -ahead));
                    QVERIFY(std::abs(shownSize(placement) - ModelPlacement::comfortableSize) < tolerance);
                }
    }

    void itIsPlacedAsMuchHigherAsPeopleWant()
    {
        ModelPlacement placement = placed();
        const Vec3 before = placement.middle();
        placement.place(looking({0, 1.7, 0}, 0, 0), 0.15);
        QVERIFY(areClose(placement.middle(), before + 0.15 * Vec3::UnitY()));
    }

    void everyModelHasAComfortableSize()
    {
        for (const double size : {0.5, 20.0, 3000.0}) {
            const core::Box box(Vec3(0, 0, 0), Vec3(size, size / 3, size / 2));
            QVERIFY(std::abs(shownSize(placed(box), box) - ModelPlacement::comfortableSize) < tolerance);
        }
        for (const core::Box& box : {core::Box(), core::Box(Vec3(1, 2, 3))}) {
            const ModelPlacement placement = placed(box);
            QVERIFY(placement.lengthToRoom(1) > 0 && std::isfinite(placement.lengthToRoom(1)) &&
                    placement.middle().allFinite());
        }
    }

    void thereAndBackIsWhereOneWas()
    {
        Random random;
        ModelPlacement placement = placed();
        for (int i = 0; i < 100; ++i) {
            const Pose from = random.pose();
            placement.move(from, random.near(from));
            placement.scale(random.between(0.8, 1.25));
            for (const Vec3& p : somePoints) {
                QVERIFY(areClose(placement.toModel(placement.toRoom(p)), p));
                QVERIFY(areClose(placement.matrix() * p, placement.toRoom(p)));
                QVERIFY(areClose(placement.directionToModel(placement.directionToRoom(p)), p));
            }
            // the mapping is a similarity: it scales all lengths equally
            const Vec3 &a = somePoints[1], &b = somePoints[2];
            QVERIFY(std::abs((placement.toRoom(a) - placement.toRoom(b)).norm() -
                             placement.lengthToRoom((a - b).norm())) < tolerance);
            QVERIFY(std::abs(placement.lengthToModel(placement.lengthToRoom(7)) - 7) < tolerance);
        }
    }

    /// Checks the sense of clockwise turns, seen from above as in the paper: points facing the user move to the left.
    void turningIsAboutTheVertical()
    {
        ModelPlacement placement = placed();
        ModelPlacement turned = placement;
        turned.turn(-pi / 6);
        const Vec3 origin = placement.toRoom(Vec3::Zero());
        QVERIFY(areClose(turned.toRoom(Vec3::Zero()), origin));
        const Vec3 nearest = placement.toModel(origin + Vec3(0, 0, 0.2));
        QVERIFY(areClose(turned.toRoom(nearest), origin + 0.2 * Vec3(-0.5, 0, std::sqrt(0.75))));
        const Vec3 above = placement.toModel(origin + Vec3(0, 0.3, 0));
        QVERIFY(areClose(turned.toRoom(above), origin + Vec3(0, 0.3, 0)));

        for (int i = 0; i < 12; ++i)
            placement.turn(pi / 6);
        for (const Vec3& p : somePoints)
            QVERIFY(areClose(placement.toRoom(p), placed().toRoom(p)));
    }

    /// Checks that turning is about the document's Y axis, however the model is tilted and has grown. The sense is as
    /// seen from above in the room.
    void aTiltedModelTurnsAboutItsOwnAxis()
    {
        for (const double tilt : {0.35, 1.0, 2.5}) {
            ModelPlacement placement = placed();
            const Pose hand{Eigen::Quaterniond::Identity(), placement.middle()};
            placement.move(hand, {Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Vec3::UnitX())), placement.middle()});
            placement.setModel(core::Box(Vec3(-50, -50, -50), Vec3(90, 50, 50))); // a protrusion at one side
            const ModelPlacement before = placement;
            placement.turn(0.4);
            for (const double y : {-40.0, 0.0, 70.0})
                QVERIFY(areClose(placement.toRoom({0, y, 0}), before.toRoom({0, y, 0})));
            const double sense = tilt < pi / 2 ? 1 : -1; // an upside-down model turns the other way about its own axis
            const Vec3 turned = placement.toModel(before.toRoom({10, 20, 0}));
            QVERIFY(areClose(turned, 10 * Vec3(std::cos(0.4), 2, sense * std::sin(0.4))));
        }
    }

    void aLevelledModelStandsUpright()
    {
        Random random;
        for (int i = 0; i < 50; ++i) {
            ModelPlacement placement = placed();
            placement.move(random.pose(), random.pose());
            const Vec3 middle = placement.middle();
            const double scale = placement.lengthToRoom(1);
            placement.level();
            QVERIFY(areClose(placement.directionToRoom(Vec3::UnitY()), Vec3::UnitY()));
            QVERIFY(areClose(placement.middle(), middle));
            QCOMPARE(placement.lengthToRoom(1), scale);
            const Eigen::Quaterniond upright = placement.rotation();
            placement.level(); // no effect on an upright model
            QVERIFY(upright.angularDistance(placement.rotation()) < tolerance);
        }
    }

    void scalingIsAboutTheMiddleAndStopsAtTheBounds()
    {
        ModelPlacement placement = placed();
        const Vec3 middle = placement.middle();
        placement.scale(1.5);
        QVERIFY(areClose(placement.middle(), middle));
        QVERIFY(std::abs(shownSize(placement) - 1.5 * ModelPlacement::comfortableSize) < tolerance);
        placement.scale(1e9);
        QVERIFY(std::abs(shownSize(placement) - ModelPlacement::maxSize) < tolerance);
        QVERIFY(areClose(placement.middle(), middle));
        placement.scale(1e-9);
        QVERIFY(std::abs(shownSize(placement) - ModelPlacement::minSize) < tolerance);
        QVERIFY(areClose(placement.middle(), middle));
    }

    /// Checks that a point of the model at the hand stays there and turns with the hand.
    void oneHandCarriesTheModel()
    {
        Random random;
        ModelPlacement placement = placed();
        Pose hand{Eigen::Quaterniond::Identity(), placement.middle() + Vec3(0.1, 0, 0.2)};
        for (int i = 0; i < 200; ++i) {
            const Pose next = random.near(hand);
            const ModelPlacement before = placement;
            placement.move(hand, next);
            for (const Vec3& p : somePoints)
                QVERIFY(areClose(next.inverse() * placement.toRoom(p), hand.inverse() * before.toRoom(p)));
            QCOMPARE(placement.lengthToRoom(1), before.lengthToRoom(1));
            hand = next;
        }
    }

    /// Checks that each hand stays at the point of the model that it grabbed.
    void twoHandsCarryAndStretchTheModel()
    {
        Random random;
        ModelPlacement placement = placed();
        ModelPlacement::Span hands{placement.middle() - Vec3(0.2, 0, 0), placement.middle() + Vec3(0.2, 0.05, 0)};
        const Vec3 atA = placement.toModel(hands.a), atB = placement.toModel(hands.b);
        for (int i = 0; i < 200; ++i) {
            const ModelPlacement::Span next{Vec3(0, 1.4, -0.6) + random.point(0.3) - Vec3(0.4, 0, 0),
                                            Vec3(0.4, 1.4, -0.6) + random.point(0.3)};
            placement.stretch(hands, next);
            QVERIFY(areClose(placement.toRoom(atA), next.a) && areClose(placement.toRoom(atB), next.b));
            hands = next;
        }
        QVERIFY(shownSize(placement) != ModelPlacement::comfortableSize);
    }

    /// Checks that at the limits of size the middle between the hands still stays fixed, and that hands which meet or
    /// swap sides do no harm.
    void stretchingStopsAtTheBounds()
    {
        ModelPlacement placement = placed();
        const Vec3 middle = placement.middle();
        const auto apart = [&](double half) {
            return ModelPlacement::Span{middle - Vec3(half, 0, 0), middle + Vec3(half, 0, 0)};
        };
        placement.stretch(apart(0.01), apart(2));
        QVERIFY(std::abs(shownSize(placement) - ModelPlacement::maxSize) < tolerance);
        QVERIFY(areClose(placement.middle(), middle));
        for (const double half : {0.004, 0.0, -0.004, -0.5, 0.5})
            placement.stretch(apart(0.3), apart(half));
        QVERIFY(isSound(placement));
        const double before = shownSize(placement);
        placement.stretch(apart(0), apart(1));
        QCOMPARE(shownSize(placement), before);
    }

    /// Checks that a model that grows by sculpting or an added object keeps its place and axis in the room.
    void aModelThatGrowsStaysInView()
    {
        ModelPlacement placement = placed();
        const ModelPlacement before = placement;
        const core::Box grown(Vec3(-30, -10, -50), Vec3(4000, 60, 200));
        placement.setModel(grown);
        for (const Vec3& p : somePoints)
            QCOMPARE(placement.toRoom(p), before.toRoom(p));
        QVERIFY(shownSize(placement, grown) > ModelPlacement::maxSize);
        placement.scale(1.1); // cannot grow further, but does not jump back into the limits either
        QCOMPARE(placement.lengthToRoom(1), before.lengthToRoom(1));
        placement.scale(0.9);
        QVERIFY(std::abs(placement.lengthToRoom(1) - 0.9 * before.lengthToRoom(1)) < tolerance);
        const Vec3 origin = placement.toRoom(Vec3::Zero());
        placement.turn(1);
        QVERIFY(areClose(placement.toRoom(Vec3::Zero()), origin));
    }

    void aHundredThousandStepsLeaveItSound()
    {
        Random random;
        ModelPlacement placement = placed();
        Pose hand = random.pose();
        for (int i = 0; i < 100000; ++i) {
            const Pose next = random.near(hand);
            switch (i % 4) {
            case 0:
                placement.turn(random.between(-1, 1));
                break;
            case 1:
                placement.scale(std::exp(random.between(-0.5, 0.5)));
                break;
            case 2:
                placement.move(hand, next);
                break;
            default:
                placement.stretch({random.point(1), random.point(1)}, {random.point(1), random.point(1)});
            }
            if (i % 1000 == 999)
                placement.place(hand);
            QVERIFY2(isSound(placement), qPrintable(QStringLiteral("seed %1, step %2").arg(placementSeed).arg(i)));
            hand = i % 100 == 0 ? random.pose() : next;
        }
    }
};

FETTLE_TEST(TestModelPlacement, QCoreApplication)
#include "tst_model_placement.moc"
