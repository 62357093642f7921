#include "vr/input/model_placement.h"

#include "core/geometry/rotation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vr
{
namespace
{
using core::Vec3;

constexpr double minModel = 1e-6; ///< a smaller model counts as this large, mm: the scale is divided by the size
constexpr double minSpan = 0.01;  ///< hands nearer to each other than this neither turn nor scale the model, metres

Eigen::Quaterniond aboutVertical(double angle)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitY()));
}

/// Returns the horizontal direction that a head faces. If the head looks far up or down, the line through its ears
/// determines it.
Vec3 facing(const Pose& head)
{
    /// The view direction (a unit vector) is used if its horizontal part is at least this long.
    constexpr double minLevel = 0.5;
    const Vec3 forward = head.forward();
    const bool isLevel = std::hypot(forward.x(), forward.z()) >= minLevel;
    const Vec3 ahead = isLevel ? forward : Vec3::UnitY().cross(head.rotation * Vec3::UnitX());
    return Vec3(ahead.x(), 0, ahead.z()).normalized();
}
} // namespace

ModelPlacement::ModelPlacement(const core::Box& model)
{
    setModel(model);
    m_scale = comfortableSize / m_size;
}

void ModelPlacement::setModel(const core::Box& model)
{
    const core::Box box = model.isEmpty() ? core::Box(Vec3::Constant(-50), Vec3::Constant(50)) : model;
    m_middle = box.center();
    m_size = std::max(box.sizes().maxCoeff(), minModel);
}

void ModelPlacement::place(const Pose& head, double heightOffset)
{
    const Vec3 ahead = facing(head);
    m_scale = comfortableSize / m_size;
    m_rotation = aboutVertical(std::atan2(-ahead.x(), -ahead.z()));
    const Vec3 middle = head.position + comfortableReach * ahead + (heightOffset - belowEyes) * Vec3::UnitY();
    m_origin += middle - toRoom(m_middle);
}

void ModelPlacement::turn(double angle)
{
    const Vec3 axis = m_rotation * Vec3::UnitY();
    const double seenFromAbove = axis.y() < 0 ? -angle : angle;
    rotateAbout(m_origin, Eigen::Quaterniond(Eigen::AngleAxisd(seenFromAbove, axis)));
}

void ModelPlacement::level()
{
    rotateAbout(middle(), core::rotationBetween(m_rotation * Vec3::UnitY(), Vec3::UnitY()));
}

void ModelPlacement::scale(double factor)
{
    scaleAbout(middle(), factor);
}

void ModelPlacement::move(const Pose& from, const Pose& to)
{
    rotateAbout(from.position, to.rotation * from.rotation.conjugate());
    m_origin += to.position - from.position;
}

void ModelPlacement::stretch(const Span& from, const Span& to)
{
    const Vec3 before = from.b - from.a, after = to.b - to.a;
    const Vec3 middleBefore = (from.a + from.b) / 2, middleAfter = (to.a + to.b) / 2;
    if (std::min(before.norm(), after.norm()) >= minSpan) {
        rotateAbout(middleBefore, core::rotationBetween(before, after));
        scaleAbout(middleBefore, after.norm() / before.norm());
    }
    m_origin += middleAfter - middleBefore;
}

Eigen::Affine3d ModelPlacement::matrix() const
{
    return Eigen::Translation3d(m_origin) * m_rotation * Eigen::Scaling(m_scale);
}

/// Returns the scale after a change by `factor`, within the bounds. A model that is outside the bounds already is not
/// forced into them, but it can only come nearer to them.
double ModelPlacement::clampedScale(double factor) const
{
    const double minScale = std::min(minSize / m_size, m_scale), maxScale = std::max(maxSize / m_size, m_scale);
    return std::clamp(m_scale * factor, minScale, maxScale);
}

void ModelPlacement::scaleAbout(const Vec3& point, double factor)
{
    assert(factor > 0);
    const double scale = clampedScale(factor);
    m_origin = point + scale / m_scale * (m_origin - point);
    m_scale = scale;
}

void ModelPlacement::rotateAbout(const Vec3& point, const Eigen::Quaterniond& rotation)
{
    m_rotation = (rotation * m_rotation).normalized();
    m_origin = point + rotation * (m_origin - point);
}
} // namespace vr
