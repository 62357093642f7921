#include "vr/input/model_placement.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vr
{
namespace
{
using core::Vec3;

constexpr double leastModel = 1e-6; ///< mm; a model of one point has a size
constexpr double leastSpan = 0.01;  ///< metres; hands that touch neither turn nor scale

Eigen::Quaterniond aboutVertical(double angle)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitY()));
}

/// The level direction a head faces. Where it looks far up or down, its ears tell.
Vec3 facing(const Pose& head)
{
    constexpr double leastLevel = 0.5; ///< of a unit vector
    const Vec3 forward = head.forward();
    const bool isLevel = std::hypot(forward.x(), forward.z()) >= leastLevel;
    const Vec3 ahead = isLevel ? forward : Vec3::UnitY().cross(head.rotation * Vec3::UnitX());
    return Vec3(ahead.x(), 0, ahead.z()).normalized();
}
} // namespace

Room::Room(const core::Box& model)
{
    setModel(model);
    m_scale = comfortableSize / m_size;
}

void Room::setModel(const core::Box& model)
{
    const core::Box box = model.isEmpty() ? core::Box(Vec3::Constant(-50), Vec3::Constant(50)) : model;
    m_middle = box.center();
    m_size = std::max(box.sizes().maxCoeff(), leastModel);
}

void Room::place(const Pose& head, double raised)
{
    const Vec3 ahead = facing(head);
    m_scale = comfortableSize / m_size;
    m_rotation = aboutVertical(std::atan2(-ahead.x(), -ahead.z()));
    const Vec3 middle = head.position + comfortableReach * ahead + (raised - belowEyes) * Vec3::UnitY();
    m_origin += middle - toRoom(m_middle);
}

void Room::turn(double angle)
{
    rotateAbout(middle(), aboutVertical(angle));
}

void Room::scale(double factor)
{
    scaleAbout(middle(), factor);
}

void Room::move(const Pose& from, const Pose& to)
{
    rotateAbout(from.position, to.rotation * from.rotation.conjugate());
    m_origin += to.position - from.position;
}

void Room::stretch(const Span& from, const Span& to)
{
    const Vec3 before = from.b - from.a, after = to.b - to.a;
    const Vec3 middleBefore = (from.a + from.b) / 2, middleAfter = (to.a + to.b) / 2;
    if (std::min(before.norm(), after.norm()) >= leastSpan) {
        rotateAbout(middleBefore, Eigen::Quaterniond::FromTwoVectors(before, after));
        scaleAbout(middleBefore, after.norm() / before.norm());
    }
    m_origin += middleAfter - middleBefore;
}

Eigen::Affine3d Room::matrix() const
{
    return Eigen::Translation3d(m_origin) * m_rotation * Eigen::Scaling(m_scale);
}

/// A model that has outgrown the bounds is not forced back into them by a touch: it may only come nearer.
double Room::allowed(double factor) const
{
    const double least = std::min(minSize / m_size, m_scale), most = std::max(mostSize / m_size, m_scale);
    return std::clamp(m_scale * factor, least, most);
}

void Room::scaleAbout(const Vec3& point, double factor)
{
    assert(factor > 0);
    const double scale = allowed(factor);
    m_origin = point + scale / m_scale * (m_origin - point);
    m_scale = scale;
}

void Room::rotateAbout(const Vec3& point, const Eigen::Quaterniond& rotation)
{
    m_rotation = (rotation * m_rotation).normalized();
    m_origin = point + rotation * (m_origin - point);
}
} // namespace vr
