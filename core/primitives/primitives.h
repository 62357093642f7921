#pragma once

#include "core/primitives/revolved_surface.h"
#include "core/primitives/tube.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace core
{
/// A solid given by its measures, in the document's unit. The centre of its box is the origin; a solid of revolution
/// has the y axis. A tube lies where its path is. A value type.
struct Primitive
{
    enum class Kind { Cuboid, Ball, Cylinder, Cone, Capsule, Torus, Lathe, Tube };
    enum class Measure {
        Width,     ///< of a box, along x
        Height,    ///< along y; a capsule's with its round ends
        Depth,     ///< of a box, along z
        Radius,    ///< a cone's at the bottom; a torus's to the middle of its tube
        TopRadius, ///< of a cone; 0: it has a point
        TubeRadius ///< of a torus
    };
    static constexpr std::size_t kinds = 8, measures = 6;

    Kind kind = Kind::Cuboid;
    std::array<double, measures> lengths = {10, 10, 10, 5, 0, 2}; ///< in the order of Measure
    /// Profile of a lathe, from one end to the other. Ends off the axis are closed by flat discs.
    std::vector<ProfilePoint> profile;
    std::vector<TubePoint> path; ///< of a tube
    double edge = 0;             ///< length that edges have approximately; 0: so that there are about 20,000 triangles
    /// Direction in the document that the primitive's y axis gets, any length above 0. For the x or z axis the others
    /// follow cyclically; another level direction leaves its z axis level; else the primitive is turned as little as
    /// possible, after half a turn about x if the direction is steeply downwards. Ignored if the kind has no axis.
    Vec3 axis = Vec3::UnitY();

    double& length(Measure measure) { return lengths[static_cast<std::size_t>(measure)]; }
    double length(Measure measure) const { return lengths[static_cast<std::size_t>(measure)]; }
};

/// Returns the name used in files and on the command line, for example "box".
std::string_view name(Primitive::Kind kind);
std::optional<Primitive::Kind> primitiveNamed(std::string_view name);
/// Returns the key used in files and on the command line, for example "tube_radius".
std::string_view name(Primitive::Measure measure);
/// Returns the measures that a kind has; a lathe has only its profile, a tube its path.
std::span<const Primitive::Measure> measuresOf(Primitive::Kind kind);
/// Returns whether a kind can be turned to another axis: all but a tube.
bool hasAxis(Primitive::Kind kind);

/// Reasons why a primitive cannot be made.
enum class PrimitiveFault {
    None,
    Measure,       ///< `measure` is not between ModelLimits::minExtent and maxExtent (the top radius may be 0)
    TubeTooThick,  ///< the radius of a torus is not larger than that of its tube
    CapsuleTooLow, ///< the height of a capsule is not larger than twice its radius
    Profile,       ///< not 2 to maxProfile points, a radius below 0, or one of 0 between the ends, or points coincide
    Path,          ///< not 2 to maxProfile points, neighbours coincide, or a radius is too small for its place
    PathMeets,     ///< the tube crosses itself so often that its pieces cannot be united
    ProfileMeets,  ///< the profile crosses or touches itself, or has walls too thin for the edges
    EdgeTooLong,   ///< edges longer than `limit` would not follow the shape
    TooManyFaces   ///< about `faces` would be needed
};

struct PrimitiveResult
{
    std::optional<TriangleMesh> mesh; ///< print-ready; missing if there is a fault
    PrimitiveFault fault = PrimitiveFault::None;
    Primitive::Measure measure = Primitive::Measure::Radius; ///< for PrimitiveFault::Measure
    double limit = 0;                                        ///< mm, for EdgeTooLong
    double faces = 0;                                        ///< for TooManyFaces
};

struct PrimitiveLimits
{
    static constexpr std::size_t maxProfile = 1000; ///< number of points, also of a path
    static constexpr double maxFaces = 2'000'000;
};

/// Returns the rotation of the primitive's own coordinates, in which its axis is y, to the document's; see
/// Primitive::axis. Not for a tube. Thread: any.
Eigen::Matrix3d rotationOf(const Primitive& primitive);

/// Returns the axis of the document, forwards or backwards, that is nearest to a direction.
Vec3 nearestAxis(const Vec3& direction);

/// Returns whether the measures are possible, without the mesh. Only makePrimitive() finds ProfileMeets and PathMeets.
/// Thread: any.
PrimitiveResult judgePrimitive(const Primitive& primitive);

/// Makes the solid's surface. Edges are between half as long as requested and 1.8 times as long, but shorter around the
/// point of a slim cone. Sharp edges of the solid are edges of the mesh. Vertices are on the exact surface, and enclose
/// at least 98 % of its volume. Symmetric bit for bit about the three planes through the origin, as far as the solid
/// is and its axis is the document's. Not so a tube: where it bends, edges are longer on the outside and shorter on the
/// inside, and where it crosses itself, pieces of it are united (mesh_boolean.h), without voids smaller than an edge.
/// Only a tube can be cancelled; it then has the fault PathMeets. The same bits on every machine. Thread: any. Cost:
/// O(mesh).
PrimitiveResult makePrimitive(const Primitive& primitive, const JobControl& control = {});
} // namespace core
