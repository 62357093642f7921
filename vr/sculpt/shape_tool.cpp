#include "vr/sculpt/shape_tool.h"

#include "core/operations/mirror_image.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vr
{
namespace
{
using core::Primitive;
using core::Vec3;
using Measure = core::Primitive::Measure;

constexpr double capsuleSlimness = 0.25, tubeShare = 0.15; ///< radii as fractions of the greatest measure
constexpr double alongAxis = 0.99; ///< cosine of 8 degrees, within which a shape is along an axis of the document
constexpr double atPlane = 0.25;   ///< radii from the plane of symmetry, within which a shape is on it
constexpr int ringEdges = 24, arcEdges = 6;

/// Collects the edges of a shape whose axis is y and whose centre is the origin, in mm.
class Outline
{
public:
    Outline(const core::Insert& shape, const ModelPlacement& placement, std::vector<Segment>& edges)
        : m_shape(shape)
        , m_rotation(core::rotationOf(*shape.primitive))
        , m_placement(placement)
        , m_edges(edges)
    {}

    void line(const Vec3& from, const Vec3& to) { m_edges.push_back({inRoom(from), inRoom(to)}); }
    /// Adds an arc of a circle about `middle` through `middle + first`, towards `middle + second`, by this angle.
    void arc(const Vec3& middle, const Vec3& first, const Vec3& second, double angle)
    {
        const int count = std::max(arcEdges, static_cast<int>(std::ceil(ringEdges * angle / fullTurn)));
        const auto at = [&](int i) -> Vec3 {
            return middle + std::cos(angle * i / count) * first + std::sin(angle * i / count) * second;
        };
        for (int i = 0; i < count; ++i)
            line(at(i), at(i + 1));
    }
    /// Adds a level circle at a height.
    void ring(double radius, double height) { arc({0, height, 0}, {radius, 0, 0}, {0, 0, radius}, fullTurn); }

    static constexpr double fullTurn = 2 * std::numbers::pi;

private:
    /// Returns a point of the shape, given in its own coordinates, in the room.
    Vec3 inRoom(const Vec3& own) const { return m_placement.toRoom(m_shape.centre + m_rotation * own); }

    const core::Insert& m_shape;
    Eigen::Matrix3d m_rotation; ///< of the shape in the document
    const ModelPlacement& m_placement;
    std::vector<Segment>& m_edges;
};

void addBox(const Primitive& shape, Outline& outline)
{
    const Vec3 half =
        Vec3(shape.length(Measure::Width), shape.length(Measure::Height), shape.length(Measure::Depth)) / 2;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {-1.0, 1.0})
            for (const double b : {-1.0, 1.0}) {
                Vec3 from = half;
                from[(axis + 1) % 3] *= a;
                from[(axis + 2) % 3] *= b;
                Vec3 to = from;
                to[axis] = -from[axis];
                outline.line(from, to);
            }
}

/// Adds a frustum: a cylinder if both radii are equal, a cone if the upper one is 0.
void addFrustum(double lower, double upper, double height, Outline& outline)
{
    outline.ring(lower, -height / 2);
    if (upper > 0)
        outline.ring(upper, height / 2);
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        outline.line(lower * side - Vec3(0, height / 2, 0), upper * side + Vec3(0, height / 2, 0));
}

/// Adds half circles over both ends of a capsule; for a ball both ends are at its middle.
void addCaps(double radius, double halfHeight, Outline& outline)
{
    for (const Vec3& side : {Vec3(radius, 0, 0), Vec3(0, 0, radius)})
        for (const double sign : {-1.0, 1.0})
            outline.arc({0, sign * halfHeight, 0}, side, {0, sign * radius, 0}, Outline::fullTurn / 2);
}

void addTorus(double radius, double tube, Outline& outline)
{
    outline.ring(radius + tube, 0);
    outline.ring(radius - tube, 0);
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        outline.arc(radius * side, tube * side, {0, tube, 0}, Outline::fullTurn);
}

bool isAtPlane(const Vec3& place, const BrushState& brush, double radius)
{
    const core::Symmetry plane = brush.stroke.symmetry;
    return plane != core::Symmetry::None && std::abs(place[core::axisOf(plane)]) < atPlane * radius;
}
} // namespace

core::Primitive shapeOfSize(Primitive::Kind kind, double diameter)
{
    Primitive shape;
    shape.kind = kind;
    for (const Measure measure : {Measure::Width, Measure::Height, Measure::Depth})
        shape.length(measure) = diameter;
    shape.length(Measure::Radius) = diameter / 2;
    shape.length(Measure::TopRadius) = 0;
    shape.length(Measure::TubeRadius) = tubeShare * diameter;
    if (kind == Primitive::Kind::Capsule)
        shape.length(Measure::Radius) = capsuleSlimness * diameter;
    if (kind == Primitive::Kind::Torus)
        shape.length(Measure::Radius) = (0.5 - tubeShare) * diameter;
    return shape;
}

core::Insert shapeAt(Primitive::Kind kind, const Pose& tip, const BrushState& brush, const ModelPlacement& placement)
{
    core::Insert insert;
    insert.place = core::Insert::Place::Centre;
    insert.centre = placement.toModel(tip.position);
    const double radius = strokeSettings(brush, {}, placement).radius;
    insert.primitive = shapeOfSize(kind, 2 * radius);
    insert.symmetry = brush.stroke.symmetry;
    const Vec3 up = placement.directionToModel(tip.rotation * Vec3::UnitY()).normalized(), axis = core::nearestAxis(up);
    if (kind != Primitive::Kind::Ball)
        insert.primitive->axis = axis.dot(up) > alongAxis ? axis : up;
    if (isAtPlane(insert.centre, brush, radius))
        core::putOnPlane(insert.centre, insert.primitive->axis, insert.symmetry);
    return insert;
}

core::TubePoint tubePointAt(const Pose& tip, const BrushState& brush, const ModelPlacement& placement)
{
    core::TubePoint point{placement.toModel(tip.position), strokeSettings(brush, {}, placement).radius};
    if (isAtPlane(point.position, brush, point.radius))
        point.position[core::axisOf(brush.stroke.symmetry)] = 0;
    return point;
}

void addMirrorImage(std::vector<Segment>& outline, core::Symmetry plane, const ModelPlacement& placement)
{
    const auto imageOf = [&](const Vec3& p) { return placement.toRoom(core::mirrored(placement.toModel(p), plane)); };
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i)
        outline.push_back({imageOf(outline[i].from), imageOf(outline[i].to)});
}

void outlineOf(const core::Insert& shape, const ModelPlacement& placement, std::vector<Segment>& outline)
{
    outline.clear();
    Outline edges(shape, placement, outline);
    const Primitive& primitive = *shape.primitive;
    const double radius = primitive.length(Measure::Radius), height = primitive.length(Measure::Height);
    switch (primitive.kind) {
    case Primitive::Kind::Cuboid:
        return addBox(primitive, edges);
    case Primitive::Kind::Ball:
        edges.ring(radius, 0);
        return addCaps(radius, 0, edges);
    case Primitive::Kind::Cylinder:
        return addFrustum(radius, radius, height, edges);
    case Primitive::Kind::Cone:
        return addFrustum(radius, primitive.length(Measure::TopRadius), height, edges);
    case Primitive::Kind::Capsule:
        addFrustum(radius, radius, height - 2 * radius, edges);
        return addCaps(radius, height / 2 - radius, edges);
    case Primitive::Kind::Torus:
        return addTorus(radius, primitive.length(Measure::TubeRadius), edges);
    case Primitive::Kind::Lathe:
    case Primitive::Kind::Tube:
        return;
    }
}
} // namespace vr
