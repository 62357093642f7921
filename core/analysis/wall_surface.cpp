// Measures thickness by balls: the ball inside that touches the surface at p with the normal n, and touches it again at
// q, has the diameter |q - p|^2 / ((p - q) . n).
//   1. rays     from p inward; each hit on an opposite face is a q
//               (after Shapira, Shamir and Cohen-Or 2008, whose cone it is)
//   2. ball     a ball shrinks: the point nearest to its centre, of the opposite faces, is the next q, until none lies
//               inside (after Ma, Bae and Choi 2012, with the faces themselves in the place of sampled points)
//   3. cell     the same for all points p of a flat triangle at once. The diameter is convex in p and q together, so
//               that for each opposite face the shrinking ends at the least ball of all.

#include "core/analysis/wall_surface.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/point_triangle.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Faces are opposite if the cosine between their normals is less: they look more than 120 degrees away from each
/// other, by more than what floats are off by, so that 60 degree edges are the same whichever way they are turned.
constexpr double maxCosine = -0.5 - 1e-4;
/// The rays around the normal: 30 degrees from it, their tangent.
constexpr double coneTangent = 0.57735026918962576;
/// A ball is as good as empty if what lies in it is so near to its surface, in radii. Much less, and a ball in round
/// matter, whose whole surface it all but touches, would look at all faces there are.
constexpr double shallow = 0.04, shallowOfMany = 0.1;
constexpr int maxShrinkings = 48;
/// The number of faces out of sight that are passed over for one ball.
constexpr std::size_t maxHidden = 6;
/// Lines of sight begin and end so far within the faces, as a share of the line's length: on an edge rounding decides.
constexpr double inset = 1e-3;

constexpr std::size_t facesAtOnce = 256;

/// A ridge is bent more, as the cosine between the faces' normals.
constexpr double minBend = 0.94;

/// Returns, by face and side, the corner of the other face across from it, if the edge juts into the matter as that at
/// the ground of a groove does; else noSlot. Sides are named by the corner across. Cost: a sort of the sides.
std::vector<std::array<Slot, 3>> ridgesOf(const TriangleMesh& mesh)
{
    struct Side
    {
        std::uint64_t edge;
        Slot face, across;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (Slot f = 0; f < mesh.triangles.size(); ++f)
        for (Slot i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax({mesh.triangles[f][(i + 1) % 3], mesh.triangles[f][(i + 2) % 3]});
            sides.push_back({std::uint64_t(low) << 32 | high, f, i});
        }
    std::ranges::sort(sides, {}, [](const Side& side) { return std::tie(side.edge, side.face); });
    std::vector<std::array<Slot, 3>> ridges(mesh.triangles.size(), {noSlot, noSlot, noSlot});
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const Side &one = sides[i], &other = sides[i + 1];
        if (one.edge != other.edge)
            continue;
        const auto [a, b, c] = cornersOf(mesh, one.face);
        const auto [d, e, f] = cornersOf(mesh, other.face);
        const Vec3 normal = (b - a).cross(c - a), otherNormal = (e - d).cross(f - d);
        const Slot across = mesh.triangles[other.face][other.across];
        if (normal.dot(mesh.points[across].cast<double>() - a) > 0 &&
            normal.dot(otherNormal) < minBend * normal.norm() * otherNormal.norm()) {
            ridges[one.face][one.across] = across;
            ridges[other.face][other.across] = mesh.triangles[one.face][one.across];
        }
    }
    return ridges;
}

/// Moves a point towards another, by no more than a length.
Vec3 towards(const Vec3& p, const Vec3& goal, double length)
{
    const Vec3 way = goal - p;
    const double distance = way.norm();
    return distance > length ? Vec3(p + length / distance * way) : goal;
}

/// Returns whether a ball that touches the surface at p and at p + way touches it there from 120 degrees away or more.
bool isSteep(const Vec3& way, const Vec3& inward)
{
    constexpr double least = (1 - maxCosine) / 2; // the squared cosine of half the angle between the normals
    const double height = way.dot(inward);
    return height > 0 && height * height >= least * way.squaredNorm();
}

/// The faces that were found to be out of sight, of one ball.
class HiddenFaces
{
public:
    bool isFull() const { return m_count == m_faces.size(); }
    void add(Slot position) { m_faces[m_count++] = position; }
    std::span<const Slot> all() const { return {m_faces.data(), m_count}; }

private:
    std::array<Slot, maxHidden> m_faces;
    std::size_t m_count = 0;
};
} // namespace

/// A cell in a frame of its face: x along the face's longest side, z inward. Long thin cells that lie across the axes
/// have wide boxes in space, but not here.
class WallSurface::LiftedCell
{
public:
    LiftedCell(const std::array<Vec3, 3>& face, const std::array<Vec3, 3>& cell, const Vec3& inward) : m_origin(cell[0])
    {
        Vec3 longest = face[1] - face[0];
        for (std::size_t i = 1; i < 3; ++i)
            if (const Vec3 side = face[(i + 1) % 3] - face[i]; side.squaredNorm() > longest.squaredNorm())
                longest = side;
        m_axes.row(2) = inward;
        m_axes.row(0) = (longest - longest.dot(inward) * inward).normalized();
        m_axes.row(1) = inward.cross(Vec3(m_axes.row(0)));
        m_extents = m_axes.cwiseAbs();
        for (std::size_t i = 0; i < 3; ++i) {
            m_cell[i] = toFrame(cell[i]);
            m_cell[i].z() = 0;
            m_space.extend(cell[i]);
        }
        m_min = m_cell[0].cwiseMin(m_cell[1]).cwiseMin(m_cell[2]);
        m_max = m_cell[0].cwiseMax(m_cell[1]).cwiseMax(m_cell[2]);
    }

    void lift(double height)
    {
        for (Vec3& p : m_cell)
            p.z() = height;
        m_min.z() = m_max.z() = height;
        m_lift = height * Vec3(m_axes.row(2));
        m_isWide = m_space.sizes().maxCoeff() > height;
    }
    const std::array<Vec3, 3>& corners() const { return m_cell; }
    Vec3 toFrame(const Vec3& p) const { return m_axes * (p - m_origin); }
    Vec3 toSpace(const Vec3& p) const { return m_axes.transpose() * p + m_origin; }

    /// Returns a bound from below of the squared distance; infinity for what is not behind the face.
    double reach(const FaceBox& box) const
    {
        const Vec3 min = box.min.cast<double>(), max = box.max.cast<double>();
        const Vec3 gap = (min - (m_space.max() + m_lift)).cwiseMax((m_space.min() + m_lift) - max).cwiseMax(0.0);
        if (!m_isWide)
            return gap.squaredNorm();
        const Vec3 centre = toFrame((min + max) / 2), half = m_extents * ((max - min) / 2);
        return centre.z() + half.z() <= 0 ? infinity : std::max(gapTo(centre - half, centre + half), gap.squaredNorm());
    }
    double gapTo(const std::array<Vec3, 3>& triangle) const
    {
        const Vec3 max = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
        return max.z() <= 0 ? infinity : gapTo(triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]), max);
    }

private:
    double gapTo(const Vec3& min, const Vec3& max) const
    {
        return (min - m_max).cwiseMax(m_min - max).cwiseMax(0.0).squaredNorm();
    }

    Vec3 m_origin, m_min, m_max, m_lift = Vec3::Zero();
    Eigen::Matrix3d m_axes, m_extents;
    std::array<Vec3, 3> m_cell;
    Box m_space;           ///< of the cell on its face
    bool m_isWide = false; ///< against how high it is lifted: the frame tells more than the space
};

WallSurface::WallSurface(const TriangleMesh& mesh)
    : m_mesh(mesh)
    , m_tree(faceBoxes(mesh.points, mesh.triangles))
    , m_walls(mesh.triangles.size())
    , m_shallow(hasMany() ? shallowOfMany : shallow)
{
    const std::vector<std::array<Slot, 3>> ridges = ridgesOf(mesh);
    forEachChunk(m_walls.size(), facesAtOnce, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            m_walls[i] = wallOf(mesh, m_tree.at(static_cast<Slot>(i)));
            m_walls[i].ridges = ridges[m_walls[i].face];
            m_walls[i].hasRidge = m_walls[i].ridges != std::array<Slot, 3>{noSlot, noSlot, noSlot};
        }
    });
}

WallSurface::Wall WallSurface::wallOf(const TriangleMesh& mesh, Slot face)
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

std::array<Vec3, 3> WallSurface::cornersOf(Slot position) const
{
    const auto& [a, b, c] = m_walls[position].corners;
    return {a.cast<double>(), b.cast<double>(), c.cast<double>()};
}

Vec3 WallSurface::pointOf(Slot position, const Vec3& weights) const
{
    const auto [a, b, c] = cornersOf(position);
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

double WallSurface::radiusOf(Slot position) const
{
    const std::array<Vec3, 3> corners = cornersOf(position);
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3;
    double radius2 = 0;
    for (const Vec3& corner : corners)
        radius2 = std::max(radius2, (corner - centre).squaredNorm());
    return std::sqrt(radius2);
}

double WallSurface::areaOf(Slot position) const
{
    const auto [a, b, c] = cornersOf(position);
    return (b - a).cross(c - a).norm() / 2;
}

bool WallSurface::areOpposite(Slot a, Slot b) const
{
    return static_cast<double>(m_walls[a].normal.dot(m_walls[b].normal)) < maxCosine;
}

bool WallSurface::mayTouch(Slot position, Slot other) const
{
    return areOpposite(position, other) || m_walls[other].hasRidge;
}

/// Returns whether some direction between the two faces at a ridge is opposite.
bool WallSurface::isOppositeRidge(Slot position, std::size_t side, const Vec3& inward) const
{
    const Slot across = m_walls[position].ridges[side];
    if (across == noSlot)
        return false;
    const std::array<Vec3, 3> corners = cornersOf(position);
    const Vec3 start = corners[(side + 1) % 3], edge = (corners[(side + 2) % 3] - start).normalized();
    const Vec3 direction = inward - inward.dot(edge) * edge;
    return direction.squaredNorm() > maxCosine * maxCosine && direction.dot(corners[side] - start) >= 0 &&
           direction.dot(m_mesh.points[across].cast<double>() - start) >= 0;
}

/// Returns whether the cell has a corner, or a point of an edge, that both faces have.
bool WallSurface::doTouch(Slot position, const WallCell& cell, Slot other) const
{
    const Triangle &own = m_mesh.triangles[m_walls[position].face], &others = m_mesh.triangles[m_walls[other].face];
    std::array<bool, 3> isShared;
    for (std::size_t i = 0; i < 3; ++i)
        isShared[i] = std::ranges::find(others, own[i]) != others.end();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto next = static_cast<std::size_t>((i + 1) % 3), last = static_cast<std::size_t>((i + 2) % 3);
        for (const Vec3& weight : cell.weights)
            if ((isShared[static_cast<std::size_t>(i)] && weight[i] == 1) ||
                (isShared[next] && isShared[last] && weight[i] == 0))
                return true;
    }
    return false;
}

/// The first face that the ray leaves the matter by. Slab test by Kay and Kajiya 1986.
WallSurface::Hit WallSurface::firstHit(Slot from, const Vec3& origin, const Vec3& direction, double farthest) const
{
    const Eigen::Array3d inverse = (direction.array() + 0.0).inverse(); // no -0
    const auto reach = [&](const FaceBox& box) {
        double enter = 0, leave = infinity;
        for (int i = 0; i < 3; ++i) { // a ray that runs in a box's side gives NaN, which changes nothing
            const bool isBackward = direction[i] < 0;
            enter =
                std::max(enter, (static_cast<double>(isBackward ? box.max[i] : box.min[i]) - origin[i]) * inverse[i]);
            leave =
                std::min(leave, (static_cast<double>(isBackward ? box.min[i] : box.max[i]) - origin[i]) * inverse[i]);
        }
        return enter <= leave ? enter : infinity;
    };
    Hit hit{noSlot, farthest};
    m_tree.forEachNear(reach, farthest, [&](Slot position) {
        const auto [a, c, b] = cornersOf(position); // seen from within; a face that the ray enters by is a miss
        const double distance = position == from ? -1 : hitTriangle({origin, direction}, {a, b, c});
        if (distance >= 0 && distance < hit.distance)
            hit = {position, distance};
        return hit.distance;
    });
    return hit;
}

/// Casts rays that go one unit inward: the ball that a hit at t makes has the diameter t (1 + tan^2).
double WallSurface::byRays(Slot position, const Vec3& p, double largest) const
{
    static constexpr std::array<std::array<double, 2>, 4> around = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const Vec3 inward = inwardOf(position);
    double diameter = ballOfRay(position, p, inward, infinity);
    if (diameter > largest && diameter < infinity)
        return diameter;
    const Vec3 x = inward.unitOrthogonal(), y = inward.cross(x);
    for (const auto& [along, across] : around) {
        const Vec3 direction = inward + coneTangent * (along * x + across * y);
        diameter = std::min(diameter, ballOfRay(position, p, direction, std::min(diameter, largest)));
    }
    return diameter;
}

double WallSurface::ballOfRay(Slot position, const Vec3& origin, const Vec3& direction, double largest) const
{
    const double perDistance = direction.squaredNorm();
    const Hit hit = firstHit(position, origin, direction, largest / perDistance);
    const bool isWall = hit.position != noSlot && areOpposite(position, hit.position);
    return isWall ? hit.distance * perDistance : infinity;
}

double WallSurface::depthBehind(Slot position, const Vec3& p) const
{
    const Hit hit = firstHit(position, p, inwardOf(position), infinity);
    return hit.position == noSlot ? 0 : hit.distance;
}

double WallSurface::byBall(Slot position, const Vec3& p, double start) const
{
    const Vec3 inward = inwardOf(position);
    double diameter = start, found = infinity;
    HiddenFaces hidden;
    for (int i = 0; i < maxShrinkings; ++i) {
        const auto touch = nearestOpposite(position, p, diameter / 2, hidden.all());
        if (!touch)
            break;
        if (isInSight(position, p, touch->q))
            found = diameter = (touch->q - p).squaredNorm() / (touch->q - p).dot(inward);
        else if (hidden.isFull())
            break;
        else
            hidden.add(touch->position);
    }
    return found;
}

ThinnestPlace WallSurface::thinnestIn(Slot position, const WallCell& cell, double start) const
{
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = pointOf(position, cell.weights[i]);
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3, inward = inwardOf(position);
    LiftedCell lifted(cornersOf(position), corners, inward);
    ThinnestPlace thinnest;
    double diameter = start;
    HiddenFaces hidden;
    for (int i = 0; i < maxShrinkings; ++i) {
        lifted.lift(diameter / 2);
        const auto touch = nearestOpposite(position, cell, lifted, diameter / 2, hidden.all());
        if (!touch)
            break;
        const Vec3 way = touch->q - touch->p;
        const Vec3 p = towards(touch->p, centre, inset * way.norm());
        const auto [a, b, c] = cornersOf(touch->position);
        const double found = way.squaredNorm() / way.dot(inward);
        if (isInSight(position, p, towards(touch->q, (a + b + c) / 3, inset * way.norm()))) {
            thinnest.diameter = diameter = found;
            thinnest.point = p;
        } else {
            thinnest.hidden = std::min(thinnest.hidden, found);
            if (hidden.isFull())
                break;
            hidden.add(touch->position);
        }
    }
    return thinnest;
}

/// Finds the nearest pair of points. A face that is not opposite counts by its opposite ridges only.
template <typename NearestOfFace, typename NearestOfSide>
NearestPair WallSurface::nearestOf(Slot position, const Vec3& inward, Slot other, NearestOfFace ofFace,
                                   NearestOfSide ofSide) const
{
    if (areOpposite(position, other))
        return ofFace();
    NearestPair nearest;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!isOppositeRidge(other, i, inward))
            continue;
        const NearestPair pair = ofSide((i + 1) % 3, (i + 2) % 3);
        if (pair.squaredDistance < nearest.squaredDistance && isSteep(pair.b - pair.a, inward))
            nearest = pair;
    }
    return nearest;
}

std::optional<WallSurface::Touch> WallSurface::nearestOpposite(Slot position, const Vec3& p, double radius,
                                                               std::span<const Slot> hidden) const
{
    const Vec3 inward = inwardOf(position), centre = p + radius * inward;
    const auto reach = [&](const FaceBox& box) {
        const Eigen::Array3d c = centre.array();
        return (box.min.cast<double>() - c).max(c - box.max.cast<double>()).max(0.0).matrix().squaredNorm();
    };
    const auto pairWith = [&](const Vec3& q) { return NearestPair{p, q, (q - centre).squaredNorm()}; };
    std::optional<Touch> nearest;
    double min = (1 - m_shallow) * radius * (1 - m_shallow) * radius;
    m_tree.forEachNear(reach, min, [&](Slot other) {
        if (!mayTouch(position, other) || std::ranges::find(hidden, other) != hidden.end())
            return min;
        const std::array<Vec3, 3> corners = cornersOf(other);
        const NearestPair pair = nearestOf(
            position, inward, other, [&] { return pairWith(nearestInTriangle(centre, corners)); },
            [&](std::size_t from, std::size_t to) {
                return pairWith(nearestOfSegments(centre, centre, corners[from], corners[to]).b);
            });
        if (pair.squaredDistance < min) {
            min = pair.squaredDistance;
            nearest = {pair.a, pair.b, other};
        }
        return min;
    });
    return nearest;
}

std::optional<WallSurface::Touch> WallSurface::nearestOpposite(Slot position, const WallCell& cell,
                                                               const LiftedCell& lifted, double radius,
                                                               std::span<const Slot> hidden) const
{
    const Vec3 inward = inwardOf(position);
    const auto inSpace = [&](NearestPair pair) {
        pair.a.z() = 0;
        return NearestPair{lifted.toSpace(pair.a), lifted.toSpace(pair.b), pair.squaredDistance};
    };
    std::optional<Touch> nearest;
    double min = (1 - shallow) * radius * (1 - shallow) * radius;
    m_tree.forEachNear(
        [&](const FaceBox& box) { return lifted.reach(box); }, min,
        [&](Slot other) {
            if (!mayTouch(position, other) || std::ranges::find(hidden, other) != hidden.end())
                return min;
            std::array<Vec3, 3> corners = cornersOf(other);
            for (Vec3& corner : corners)
                corner = lifted.toFrame(corner);
            if (lifted.gapTo(corners) >= min || doTouch(position, cell, other))
                return min;
            const NearestPair pair = nearestOf(
                position, inward, other, [&] { return inSpace(nearestOfTriangles(lifted.corners(), corners)); },
                [&](std::size_t from, std::size_t to) {
                    return inSpace(nearestOfTriangleAndSegment(lifted.corners(), corners[from], corners[to]));
                });
            if (pair.squaredDistance < min) {
                min = pair.squaredDistance;
                nearest = {pair.a, pair.b, other};
            }
            return min;
        });
    return nearest;
}

bool WallSurface::isInSight(Slot position, const Vec3& p, const Vec3& q) const
{
    constexpr double beforeIt = 1 - 1e-6;
    return firstHit(position, p, q - p, beforeIt).position == noSlot;
}
} // namespace core
