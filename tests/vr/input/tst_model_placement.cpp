#include "vr/input/model_placement.h"

#include <QTest>

#include <numbers>
#include <random>

using core::Vec3;
using vr::Pose;
using vr::Room;

namespace
{
constexpr double tolerance = 1e-9;
constexpr double pi = std::numbers::pi;
constexpr unsigned seed = 20261122;
const core::Box someBox(Vec3(-30, -10, -50), Vec3(40, 60, 20));
const std::vector<Vec3> somePoints{{0, 0, 0}, {40, 60, 20}, {-30, 0, -50}, {7, -3, 11}};

/// A head that looks along that direction from there.
Pose looking(const Vec3& from, double yaw, double pitch)
{
    return {Eigen::AngleAxisd(yaw, Vec3::UnitY()) * Eigen::AngleAxisd(pitch, Vec3::UnitX()), from};
}

/// In front of somebody who stands at the origin and looks along -Z.
Room placed(const core::Box& box = someBox)
{
    Room room(box);
    room.place(looking({0, 1.7, 0}, 0, 0));
    return room;
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
    /// A little way from another.
    Pose near(const Pose& pose)
    {
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(between(-0.3, 0.3), point(1).normalized()));
        return {turn * pose.rotation, pose.position + point(0.1)};
    }

private:
    std::mt19937 m_engine{seed};
};

double shownSize(const Room& room, const core::Box& box = someBox)
{
    return room.lengthToRoom(box.sizes().maxCoeff());
}

bool isSound(const Room& room)
{
    const double size = shownSize(room);
    return std::abs(room.rotation().norm() - 1) < 1e-12 && size >= Room::minSize * (1 - tolerance) &&
           size <= Room::mostSize * (1 + tolerance) && room.toRoom(someBox.center()).allFinite();
}
} // namespace

class TestRoom : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Wherever the head is, a person sees the model's front upright before them.
    void aModelIsPlacedBeforeTheEyes()
    {
        for (const double height : {1.75, 1.15, 0.0})
            for (const double yaw : {0.0, 1.0, 2.5, -2.0, pi})
                for (const double pitch : {0.0, -0.7, 0.7, -pi / 2, pi / 2, -1.8}) {
                    const Vec3 eyes(1.5, height, -0.5);
                    Room room(someBox);
                    room.turn(0.3);
                    room.place(looking(eyes, yaw, pitch));
                    const Vec3 ahead = Eigen::AngleAxisd(yaw, Vec3::UnitY()) * -Vec3::UnitZ();
                    QVERIFY(areClose(room.middle(),
                                     eyes + Room::comfortableReach * ahead - Room::belowEyes * Vec3::UnitY()));
                    QVERIFY(areClose(room.directionToRoom(Vec3::UnitY()), Vec3::UnitY()));
                    QVERIFY(areClose(room.directionToRoom(Vec3::UnitZ()), -ahead));
                    QVERIFY(std::abs(shownSize(room) - Room::comfortableSize) < tolerance);
                }
    }

    void itIsPlacedAsMuchHigherAsPeopleWant()
    {
        Room room = placed();
        const Vec3 before = room.middle();
        room.place(looking({0, 1.7, 0}, 0, 0), 0.15);
        QVERIFY(areClose(room.middle(), before + 0.15 * Vec3::UnitY()));
    }

    void everyModelHasAComfortableSize()
    {
        for (const double size : {0.5, 20.0, 3000.0}) {
            const core::Box box(Vec3(0, 0, 0), Vec3(size, size / 3, size / 2));
            QVERIFY(std::abs(shownSize(placed(box), box) - Room::comfortableSize) < tolerance);
        }
        for (const core::Box& box : {core::Box(), core::Box(Vec3(1, 2, 3))}) {
            const Room room = placed(box);
            QVERIFY(room.metresPerMm() > 0 && std::isfinite(room.metresPerMm()) && room.middle().allFinite());
        }
    }

    void thereAndBackIsWhereOneWas()
    {
        Random random;
        Room room = placed();
        for (int i = 0; i < 100; ++i) {
            const Pose from = random.pose();
            room.move(from, random.near(from));
            room.scale(random.between(0.8, 1.25));
            for (const Vec3& p : somePoints) {
                QVERIFY(areClose(room.toModel(room.toRoom(p)), p));
                QVERIFY(areClose(room.matrix() * p, room.toRoom(p)));
                QVERIFY(areClose(room.directionToModel(room.directionToRoom(p)), p));
            }
            // a similarity: lengths between points scale as lengths do
            const Vec3 &a = somePoints[1], &b = somePoints[2];
            QVERIFY(std::abs((room.toRoom(a) - room.toRoom(b)).norm() - room.lengthToRoom((a - b).norm())) < tolerance);
            QVERIFY(std::abs(room.lengthToModel(room.lengthToRoom(7)) - 7) < tolerance);
        }
    }

    /// The paper's clockwise: seen from above. What faces the person goes to the left.
    void turningIsAboutTheVerticalThroughTheMiddle()
    {
        Room room = placed();
        Room turned = room;
        turned.turn(-pi / 6);
        QVERIFY(areClose(turned.middle(), room.middle()));
        const Vec3 nearest = room.toModel(room.middle() + Vec3(0, 0, 0.2));
        QVERIFY(areClose(turned.toRoom(nearest), room.middle() + 0.2 * Vec3(-0.5, 0, std::sqrt(0.75))));
        const Vec3 above = room.toModel(room.middle() + Vec3(0, 0.3, 0));
        QVERIFY(areClose(turned.toRoom(above), room.middle() + Vec3(0, 0.3, 0)));

        for (int i = 0; i < 12; ++i)
            room.turn(pi / 6);
        for (const Vec3& p : somePoints)
            QVERIFY(areClose(room.toRoom(p), placed().toRoom(p)));
    }

    /// However it stands: the room's vertical, not the model's.
    void aTiltedModelTurnsUpright()
    {
        Room room = placed();
        const Pose hand{Eigen::Quaterniond::Identity(), room.middle()};
        room.move(hand, {Eigen::Quaterniond(Eigen::AngleAxisd(1, Vec3::UnitX())), room.middle()});
        const Room before = room;
        room.turn(0.4);
        for (const Vec3& p : somePoints)
            QVERIFY(std::abs(room.toRoom(p).y() - before.toRoom(p).y()) < tolerance);
    }

    void scalingIsAboutTheMiddleAndStopsAtTheBounds()
    {
        Room room = placed();
        const Vec3 middle = room.middle();
        room.scale(1.5);
        QVERIFY(areClose(room.middle(), middle));
        QVERIFY(std::abs(shownSize(room) - 1.5 * Room::comfortableSize) < tolerance);
        room.scale(1e9);
        QVERIFY(std::abs(shownSize(room) - Room::mostSize) < tolerance);
        QVERIFY(areClose(room.middle(), middle));
        room.scale(1e-9);
        QVERIFY(std::abs(shownSize(room) - Room::minSize) < tolerance);
        QVERIFY(areClose(room.middle(), middle));
    }

    /// A hand holds it: what is at the hand stays there, and is turned as the hand is.
    void oneHandCarriesTheModel()
    {
        Random random;
        Room room = placed();
        Pose hand{Eigen::Quaterniond::Identity(), room.middle() + Vec3(0.1, 0, 0.2)};
        for (int i = 0; i < 200; ++i) {
            const Pose next = random.near(hand);
            const Room before = room;
            room.move(hand, next);
            for (const Vec3& p : somePoints)
                QVERIFY(areClose(next.inverse() * room.toRoom(p), hand.inverse() * before.toRoom(p)));
            QCOMPARE(room.metresPerMm(), before.metresPerMm());
            hand = next;
        }
    }

    /// Two hands hold it: each stays where it took hold.
    void twoHandsCarryAndStretchTheModel()
    {
        Random random;
        Room room = placed();
        Room::Span hands{room.middle() - Vec3(0.2, 0, 0), room.middle() + Vec3(0.2, 0.05, 0)};
        const Vec3 atA = room.toModel(hands.a), atB = room.toModel(hands.b);
        for (int i = 0; i < 200; ++i) {
            const Room::Span next{Vec3(0, 1.4, -0.6) + random.point(0.3) - Vec3(0.4, 0, 0),
                                  Vec3(0.4, 1.4, -0.6) + random.point(0.3)};
            room.stretch(hands, next);
            QVERIFY(areClose(room.toRoom(atA), next.a) && areClose(room.toRoom(atB), next.b));
            hands = next;
        }
        QVERIFY(shownSize(room) != Room::comfortableSize);
    }

    /// Out of bounds the middle between the hands still holds; hands that come together, or change places, break nothing.
    void stretchingStopsAtTheBounds()
    {
        Room room = placed();
        const Vec3 middle = room.middle();
        const auto apart = [&](double half) {
            return Room::Span{middle - Vec3(half, 0, 0), middle + Vec3(half, 0, 0)};
        };
        room.stretch(apart(0.01), apart(2));
        QVERIFY(std::abs(shownSize(room) - Room::mostSize) < tolerance);
        QVERIFY(areClose(room.middle(), middle));
        for (const double half : {0.004, 0.0, -0.004, -0.5, 0.5})
            room.stretch(apart(0.3), apart(half));
        QVERIFY(isSound(room));
        const double before = shownSize(room);
        room.stretch(apart(0), apart(1));
        QCOMPARE(shownSize(room), before);
    }

    /// Sculpting makes it larger, or an object is added: what is seen stays, the next turn is about its new middle.
    void aModelThatGrowsStaysInView()
    {
        Room room = placed();
        const Room before = room;
        const core::Box grown(Vec3(-30, -10, -50), Vec3(4000, 60, 200));
        room.setModel(grown);
        for (const Vec3& p : somePoints)
            QCOMPARE(room.toRoom(p), before.toRoom(p));
        QVERIFY(shownSize(room, grown) > Room::mostSize);
        room.scale(1.1); // no larger, and no jump back into the bounds either
        QCOMPARE(room.metresPerMm(), before.metresPerMm());
        room.scale(0.9);
        QVERIFY(std::abs(room.metresPerMm() - 0.9 * before.metresPerMm()) < tolerance);
        const Vec3 middle = room.toRoom(grown.center());
        room.turn(1);
        QVERIFY(areClose(room.toRoom(grown.center()), middle));
    }

    void aHundredThousandStepsLeaveItSound()
    {
        Random random;
        Room room = placed();
        Pose hand = random.pose();
        for (int i = 0; i < 100000; ++i) {
            const Pose next = random.near(hand);
            switch (i % 4) {
            case 0:
                room.turn(random.between(-1, 1));
                break;
            case 1:
                room.scale(std::exp(random.between(-0.5, 0.5)));
                break;
            case 2:
                room.move(hand, next);
                break;
            default:
                room.stretch({random.point(1), random.point(1)}, {random.point(1), random.point(1)});
            }
            if (i % 1000 == 999)
                room.place(hand);
            QVERIFY2(isSound(room), qPrintable(QStringLiteral("seed %1, step %2").arg(seed).arg(i)));
            hand = i % 100 == 0 ? random.pose() : next;
        }
    }
};

QTEST_GUILESS_MAIN(TestRoom)
#include "tst_model_placement.moc"
