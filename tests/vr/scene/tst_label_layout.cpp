#include "core/geometry/rotation.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"
#include "vr/scene/label_layout.h"

#include <QTest>

using vr::LabelPlace;

namespace
{

struct Case
{
    vr::Pose grip, head;
    vr::LabelAspects aspects;
};

/// Returns random poses of a wand within reach and of a head that looks roughly at it.
Case randomCase(StrokeFuzzer& random)
{
    Case made;
    const auto turn = [&] { return Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(0, 3), random.direction())); };
    made.grip = {turn(), core::Vec3(random.uniform(-0.5, 0.5), random.uniform(0.5, 1.7), random.uniform(-0.5, 0.5))};
    const core::Vec3 middle = made.grip * vr::placeOf(vr::WandSpot::PadMiddle), back = random.direction();
    made.head.position = middle + random.uniform(0.2, 1.2) * back;
    made.head.rotation =
        core::rotationBetween(core::Vec3::UnitZ(), back) * Eigen::AngleAxisd(random.uniform(-1, 1), random.direction());
    for (auto& aspect : made.aspects)
        if (random.below(4) != 0)
            aspect = random.uniform(2, 10);
    return made;
}

bool overlap(const LabelPlace& a, const LabelPlace& b)
{
    const core::Vec3 between = b.center - a.center;
    const auto apart = [&](const core::Vec3& halfA, const core::Vec3& halfB) {
        return std::abs(between.dot(halfA.normalized())) >= halfA.norm() + halfB.norm();
    };
    return !apart(a.halfX, b.halfX) && !apart(a.halfY, b.halfY);
}
} // namespace

class TestLabelLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void labels_faceTheHeadAndDoNotOverlap();
    void labels_areReadableAtAnyDistance();
    void labels_standBeforeTheWand();
    void axes_areFiniteAnywhere();
};

void TestLabelLayout::labels_faceTheHeadAndDoNotOverlap()
{
    StrokeFuzzer random(20240812);
    for (int i = 0; i < 2000; ++i) {
        const Case made = randomCase(random);
        const vr::LabelPlaces places = vr::labelPlaces(made.grip, made.head, made.aspects);
        const core::Vec3 middle = made.grip * vr::placeOf(vr::WandSpot::PadMiddle);
        const core::Vec3 back = (made.head.position - middle).normalized();
        for (std::size_t a = 0; a < places.size(); ++a) {
            QCOMPARE(places[a].has_value(), made.aspects[a].has_value());
            if (!places[a])
                continue;
            const LabelPlace& label = *places[a];
            QVERIFY(label.halfX.normalized().cross(label.halfY.normalized()).dot(back) > 0.999);
            QVERIFY(label.halfX.dot(made.head.rotation * core::Vec3::UnitX()) > 0); // not upside down
            QVERIFY(std::abs(label.halfX.norm() / label.halfY.norm() - *made.aspects[a]) < 1e-9);
            QVERIFY(std::abs((label.edge - label.center).norm() - label.halfX.norm()) < 1e-9);
            QVERIFY((label.button - made.grip * vr::placeOf(static_cast<vr::WandSpot>(a))).isZero(1e-12));
            for (std::size_t b = 0; b < a; ++b)
                QVERIFY(!places[b] || !overlap(label, *places[b]));
        }
    }
}

/// Checks that a label always appears at least 2.3 degrees high, of which letters take some 45 %.
void TestLabelLayout::labels_areReadableAtAnyDistance()
{
    StrokeFuzzer random(7);
    for (int i = 0; i < 500; ++i) {
        const Case made = randomCase(random);
        for (const auto& place : vr::labelPlaces(made.grip, made.head, made.aspects))
            if (place) {
                const core::Vec3 middle = made.grip * vr::placeOf(vr::WandSpot::PadMiddle);
                const core::Vec3 back = (made.head.position - middle).normalized();
                QVERIFY(2 * std::atan(place->halfY.norm() / (made.head.position - place->center).dot(back)) >
                        2.3 * std::numbers::pi / 180);
            }
    }
}

/// Checks that labels are in front of the wand, clear of clay that the wand has dipped into, and equally
/// readable.
void TestLabelLayout::labels_standBeforeTheWand()
{
    StrokeFuzzer random(11);
    for (int i = 0; i < 500; ++i) {
        const Case made = randomCase(random);
        const core::Vec3 middle = made.grip * vr::placeOf(vr::WandSpot::PadMiddle), way = made.head.position - middle;
        for (const auto& place : vr::labelPlaces(made.grip, made.head, made.aspects))
            if (place) {
                const double before = (place->center - middle).dot(way.normalized());
                QVERIFY(before > std::min(0.09, 0.3 * way.norm()) && before < 0.4 * way.norm());
            }
    }
}

/// Checks that the axes are orthonormal and right-handed even if the head is at the same place or looks straight up.
void TestLabelLayout::axes_areFiniteAnywhere()
{
    const Eigen::Quaterniond up(Eigen::AngleAxisd(std::numbers::pi / 2, core::Vec3::UnitX()));
    for (const core::Vec3& from :
         {core::Vec3(0, 0, 0), core::Vec3(0, 1, 0), core::Vec3(0, 0, -2), core::Vec3(3, 1, 2)}) {
        for (const Eigen::Quaterniond& rotation : {Eigen::Quaterniond::Identity(), up}) {
            const Eigen::Matrix3d axes = vr::axesFacing({rotation, core::Vec3::Zero()}, from);
            QVERIFY((axes.transpose() * axes).isIdentity(1e-12));
            QVERIFY(axes.determinant() > 0);
            QVERIFY(from.isZero() || axes.col(2).isApprox(-from.normalized()));
        }
    }
}

FETTLE_TEST(TestLabelLayout, QCoreApplication)
#include "tst_label_layout.moc"
