// How thick walls are, by two methods that speak of the same thing: the ball inside that touches the surface at p with
// the normal n, and touches it again at q, has the diameter |q - p|^2 / ((p - q) . n).
//   1. rays    from the centre of each face inward, one along the normal and, unless that says it is thick, four around
//   it; each hit
//              on an opposite face is a q
//              (after Shapira, Shamir and Cohen-Or 2008, whose cone it is)
//   2. ball    the least of these balls shrinks: the point nearest to its centre, of the opposite faces, is the next q,
//   until none
//              lies inside (after Ma, Bae and Choi 2012, with the faces themselves in the place of sampled points)

#include "core/analysis/wall_thickness.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/point_triangle.h"

#include <cmath>
#include <optional>

namespace core
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Faces are opposite if the cosine between their normals is less: they look 120 degrees away from each other.
constexpr double maxCosine = -0.5;
/// The rays around the normal: 30 degrees from it, their tangent.
constexpr double coneTangent = 0.57735026918962576;
/// A ball is as good as empty if what lies in it is so near to its surface, in radii. Much less, and a ball in round
/// matter, whose whole surface it all but touches, would look at all faces there are.
constexpr double shallow = 0.1;
constexpr int maxShrinkings = 24;

constexpr std::size_t facesAtOnce = 256, facesPerPart = 1 << 14;

/// A face at its place in the tree.
struct Wall
{
    std::array<Vec3f, 3> corners;
    Vec3f normal; ///< unit length, or zero
    Slot face;
};

struct Hit
{
    Slot position = noSlot;
    double distance = infinity; ///< in the direction's length
};

class Walls
{
public:
    Walls(const TriangleMesh& mesh, double largestBall)
        : m_tree(faceBoxes(mesh.points, mesh.triangles))
        , m_walls(mesh.triangles.size())
        , m_largestBall(largestBall)
    {
        forEachChunk(m_walls.size(), facesAtOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                m_walls[i] = wallOf(mesh, m_tree.at(static_cast<Slot>(i)));
        });
    }

    /// At a position of the tree, so that neighbours ask about the same boxes.
    void measure(Slot position, WallThickness& result) const
    {
        const Wall& wall = m_walls[position];
        double rays = infinity, ball = infinity;
        if (!wall.normal.isZero()) {
            rays = byRays(position);
            ball = byBall(position, rays);
        }
        result.byRays[wall.face] = static_cast<float>(rays);
        result.byBalls[wall.face] = static_cast<float>(ball);
    }

private:
    static Wall wallOf(const TriangleMesh& mesh, Slot face)
    {
        Wall wall;
        for (std::size_t i = 0; i < 3; ++i)
            wall.corners[i] = mesh.points[mesh.triangles[face][i]];
        const Vec3 a = wall.corners[0].cast<double>();
        const Vec3 normal = (wall.corners[1].cast<double>() - a).cross(wall.corners[2].cast<double>() - a);
        const double length = std::sqrt(normal.squaredNorm());
        wall.normal = length > 0 ? Vec3f((normal / length).cast<float>()) : Vec3f::Zero();
        wall.face = face;
        return wall;
    }

    static Vec3 centreOf(const Wall& wall)
    {
        return (wall.corners[0].cast<double>() + wall.corners[1].cast<double>() + wall.corners[2].cast<double>()) / 3;
    }
    std::array<Vec3, 3> cornersOf(Slot position) const
    {
        const auto& [a, b, c] = m_walls[position].corners;
        return {a.cast<double>(), b.cast<double>(), c.cast<double>()};
    }
    bool areOpposite(const Wall& a, const Wall& b) const
    {
        return static_cast<double>(a.normal.dot(b.normal)) < maxCosine;
    }

    /// The first face that the ray leaves the matter by. Slab test by Kay and Kajiya 1986.
    Hit firstHit(Slot from, const Vec3& origin, const Vec3& direction, double farthest) const
    {
        const Eigen::Array3d inverse = (direction.array() + 0.0).inverse(); // no -0
        const auto reach = [&](const FaceBox& box) {
            double enter = 0, leave = infinity;
            for (int i = 0; i < 3; ++i) { // a ray that runs in a box's side gives NaN, which changes nothing
                const bool isBackward = direction[i] < 0;
                enter = std::max(enter,
                                 (static_cast<double>(isBackward ? box.max[i] : box.min[i]) - origin[i]) * inverse[i]);
                leave = std::min(leave,
                                 (static_cast<double>(isBackward ? box.min[i] : box.max[i]) - origin[i]) * inverse[i]);
            }
            return enter <= leave ? enter : infinity;
        };
        Hit hit{noSlot, farthest};
        m_tree.forEachNear(reach, farthest, [&](Slot position) {
            const double distance = position == from ? -1 : hitFromWithin(position, origin, direction);
            if (distance >= 0 && distance < hit.distance)
                hit = {position, distance};
            return hit.distance;
        });
        return hit;
    }

    /// Negative for a miss, and for a face that the ray enters by.
    double hitFromWithin(Slot position, const Vec3& origin, const Vec3& direction) const
    {
        const auto [a, c, b] = cornersOf(position); // seen from within
        return hitTriangle({origin, direction}, {a, b, c});
    }

    /// Each ray goes one unit inward, so that the ball that its hit at t makes has the diameter t (1 + tan^2).
    double byRays(Slot position) const
    {
        static constexpr std::array<std::array<double, 2>, 4> around = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const Wall& wall = m_walls[position];
        const Vec3 origin = centreOf(wall), inward = -wall.normal.cast<double>();
        double diameter = ballOfRay(position, origin, inward, infinity);
        if (diameter > m_largestBall && diameter < infinity)
            return diameter;
        const Vec3 x = inward.unitOrthogonal(), y = inward.cross(x);
        for (const auto& [along, across] : around) {
            const Vec3 direction = inward + coneTangent * (along * x + across * y);
            diameter = std::min(diameter, ballOfRay(position, origin, direction, std::min(diameter, m_largestBall)));
        }
        return diameter;
    }

    double ballOfRay(Slot position, const Vec3& origin, const Vec3& direction, double largest) const
    {
        const double perDistance = direction.squaredNorm();
        const Hit hit = firstHit(position, origin, direction, largest / perDistance);
        const bool isWall = hit.position != noSlot && areOpposite(m_walls[position], m_walls[hit.position]);
        return isWall ? hit.distance * perDistance : infinity;
    }

    /// From the rays' ball on, or from one as deep as the matter, but from no larger one than is asked for; a q that
    /// matter does not join to p ends it, and what was found until then counts.
    double byBall(Slot position, double found) const
    {
        const Wall& wall = m_walls[position];
        const Vec3 p = centreOf(wall), inward = -wall.normal.cast<double>();
        double diameter = std::min(m_largestBall, found < infinity ? found : depthBehind(position, p, inward));
        for (int i = 0; i < maxShrinkings; ++i) {
            const double radius = diameter / 2;
            const std::optional<Vec3> q = nearestOpposite(wall, p + radius * inward, (1 - shallow) * radius);
            if (!q || !isInSight(position, p, *q))
                break;
            found = diameter = (*q - p).squaredNorm() / (*q - p).dot(inward);
        }
        return found;
    }

    double depthBehind(Slot position, const Vec3& origin, const Vec3& inward) const
    {
        const Hit hit = firstHit(position, origin, inward, infinity);
        return hit.position == noSlot ? 0 : hit.distance;
    }

    std::optional<Vec3> nearestOpposite(const Wall& wall, const Vec3& centre, double radius) const
    {
        const auto reach = [&](const FaceBox& box) {
            const Eigen::Array3d c = centre.array();
            return (box.min.cast<double>() - c).max(c - box.max.cast<double>()).max(0.0).matrix().squaredNorm();
        };
        std::optional<Vec3> nearest;
        double min = radius * radius;
        m_tree.forEachNear(reach, min, [&](Slot position) {
            if (!areOpposite(wall, m_walls[position]))
                return min;
            const Vec3 q = nearestInTriangle(centre, cornersOf(position));
            const double distance = (q - centre).squaredNorm();
            if (distance < min) {
                min = distance;
                nearest = q;
            }
            return min;
        });
        return nearest;
    }

    bool isInSight(Slot position, const Vec3& p, const Vec3& q) const
    {
        constexpr double beforeIt = 1 - 1e-6;
        return firstHit(position, p, q - p, beforeIt).position == noSlot;
    }

    BoxTree m_tree;
    std::vector<Wall> m_walls; ///< by position
    double m_largestBall;
};
} // namespace

/// A part at a time: others get the cores in between.
WallThickness wallThickness(const TriangleMesh& mesh, double largestBall, const JobControl& control)
{
    WallThickness result;
    const std::size_t faces = mesh.triangles.size();
    result.byRays.resize(faces);
    result.byBalls.resize(faces);
    const Walls walls(mesh, largestBall);
    for (std::size_t first = 0; first < faces && !control.isCancelled(); first += facesPerPart) {
        const std::size_t count = std::min(facesPerPart, faces - first);
        forEachChunk(count, facesAtOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                walls.measure(static_cast<Slot>(first + i), result);
        });
        control.reportProgress(static_cast<double>(first + count) / static_cast<double>(faces));
    }
    return result;
}
} // namespace core
