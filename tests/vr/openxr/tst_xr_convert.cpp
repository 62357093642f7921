#include "vr/openxr/xr_convert.h"

#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using core::Vec3;
using vr::Pose;

namespace
{
constexpr double pi = 3.14159265358979323846;

Eigen::Quaterniond turn(double angle, const Vec3& axis)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// Returns a vertex in OpenGL's normalised device coordinates.
Eigen::Vector3f projected(const Eigen::Matrix4f& projection, const Eigen::Vector3f& at)
{
    return (projection * at.homogeneous()).hnormalized();
}
} // namespace

class TestXrConvert : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void posesComeBack();
    void projectionFitsTheFieldOfView();
    void validAndTracked();
    void whatIsNoPose_isNotValid();
    void levelBelowHasYawAndPlaceOnly();
    void levelBelowOfSteepHeads();
};

void TestXrConvert::posesComeBack()
{
    const Pose pose{turn(1.2, {1, 2, 3}), {0.25, -1.5, 3}};
    const Pose back = vr::fromXr(vr::toXr(pose));
    QVERIFY(back.rotation.isApprox(pose.rotation, 1e-6));
    QVERIFY(back.position.isApprox(pose.position, 1e-6));
    QVERIFY(std::abs(back.rotation.norm() - 1) < 1e-12);

    // half a turn about Y: +Z is ahead
    const XrPosef behind{{0, 1, 0, 0}, {1, 2, 3}};
    QVERIFY(vr::fromXr(behind).forward().isApprox(Vec3::UnitZ(), 1e-6));
}

void TestXrConvert::projectionFitsTheFieldOfView()
{
    const XrFovf fov{-0.9F, 0.7F, 0.8F, -0.6F};
    constexpr float nearPlane = 0.1F, farPlane = 20;
    const Eigen::Matrix4f projection = vr::projectionOf(fov, nearPlane, farPlane);
    for (const float depth : {nearPlane, farPlane}) {
        const Eigen::Vector3f low(depth * std::tan(fov.angleLeft), depth * std::tan(fov.angleDown), -depth);
        const Eigen::Vector3f high(depth * std::tan(fov.angleRight), depth * std::tan(fov.angleUp), -depth);
        const float z = depth == nearPlane ? -1.0F : 1.0F;
        QVERIFY(projected(projection, low).isApprox(Eigen::Vector3f(-1, -1, z), 1e-4F));
        QVERIFY(projected(projection, high).isApprox(Eigen::Vector3f(1, 1, z), 1e-4F));
    }
}

void TestXrConvert::validAndTracked()
{
    const XrSpaceLocationFlags valid = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    const XrSpaceLocationFlags tracked =
        valid | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    const auto located = [](XrSpaceLocationFlags flags) {
        return XrSpaceLocation{XR_TYPE_SPACE_LOCATION, nullptr, flags, {{0, 0, 0, 1}, {1, 2, 3}}};
    };
    QVERIFY(vr::isValid(located(valid)) && vr::isValid(located(tracked)));
    QVERIFY(vr::isTracked(located(tracked)) && !vr::isTracked(located(valid)));
    for (const XrSpaceLocationFlags bit : {1, 2, 4, 8})
        QVERIFY(!vr::isTracked(located(tracked & ~bit)));
    QVERIFY(!vr::isValid(located(XR_SPACE_LOCATION_ORIENTATION_VALID_BIT)));
    QVERIFY(!vr::isValid(located(XR_SPACE_LOCATION_POSITION_VALID_BIT)));
}

/// Checks that invalid numbers are not accepted as a pose, even if the runtime marks the pose as valid.
void TestXrConvert::whatIsNoPose_isNotValid()
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
    const auto isKnown = [](const XrPosef& pose) {
        const XrSpaceLocation location{XR_TYPE_SPACE_LOCATION, nullptr, 0xF, pose};
        return vr::isValid(location) && vr::isTracked(location);
    };
    QVERIFY(isKnown({{0.5F, 0.5F, 0.5F, 0.5F}, {1, 2, 3}}));
    QVERIFY(isKnown({{0, 0, 0, 0.995F}, {0, 0, 0}}));
    for (const XrQuaternionf& rotation :
         {XrQuaternionf{0, 0, 0, 0}, {nan, 0, 0, 1}, {0, 0, 0, nan}, {endless, 0, 0, 0}})
        QVERIFY(!isKnown({rotation, {0, 0, 0}}));
    for (const XrVector3f& place : {XrVector3f{nan, 0, 0}, {0, -endless, 0}, {0, 0, nan}})
        QVERIFY(!isKnown({{0, 0, 0, 1}, place}));
}

/// Checks that seen from the level pose, the head is above the origin at its own height and looks towards -Z
/// horizontally.
void TestXrConvert::levelBelowHasYawAndPlaceOnly()
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(-pi, pi), tilt(-1, 1), place(-3, 3);
    for (int i = 0; i < 200; ++i) {
        const Pose head{turn(angle(random), Vec3::UnitY()) * turn(tilt(random), Vec3::UnitX()) *
                            turn(tilt(random), Vec3::UnitZ()),
                        {place(random), place(random), place(random)}};
        const Pose level = vr::levelBelow(head);
        QVERIFY((level.rotation * Vec3::UnitY()).isApprox(Vec3::UnitY(), 1e-9));
        const Pose seen = level.inverse() * head;
        QVERIFY((seen.position - Vec3(0, head.position.y(), 0)).norm() < 1e-9);
        QVERIFY(std::abs(seen.forward().x()) < 1e-9);
        QVERIFY(seen.forward().z() < 0);
    }
}

void TestXrConvert::levelBelowOfSteepHeads()
{
    for (const double pitch : {-pi / 2, pi / 2}) {
        for (double yaw = -3; yaw < 3; yaw += 0.5) {
            const Pose head{turn(yaw, Vec3::UnitY()) * turn(pitch, Vec3::UnitX()), {1, 1.7, 2}};
            QVERIFY(vr::levelBelow(head).rotation.angularDistance(turn(yaw, Vec3::UnitY())) < 1e-6);
        }
    }
}

FETTLE_TEST(TestXrConvert, QCoreApplication)
#include "tst_xr_convert.moc"
