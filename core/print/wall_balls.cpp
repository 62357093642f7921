// Measures thickness with balls. A ball inside the solid that touches the surface at p, with normal n, and again at q
// has the diameter |q - p|^2 / ((p - q) . n).
//   1. rays     from p inward; each hit on an opposite face is a candidate q
//               (after Shapira, Shamir and Cohen-Or 2008, whose cone of rays it uses)
//   2. ball     the ball shrinks: the next q is the point of the opposite faces nearest to its centre, until none is
//               inside (after Ma, Bae and Choi 2012, with the faces themselves instead of sampled points)
//   3. cell     the same for all points p of a flat triangle at once. The diameter is convex in p and q together, so
//               for each opposite face the shrinking ends at the least ball.
// A point q that is more than 30 degrees off the normal at p is ignored. At the bottom of a groove, for example, the
// walls reach behind each other's planes without matter between them.

#include "core/print/wall_balls.h"

#include "core/geometry/point_triangle.h"
#include "core/geometry/triangle_distance.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// A ball counts as empty if every point in it is within this share of the radius from its surface. With a much smaller
/// share, a ball in round matter, which nearly touches all of the surface, would test every face.
constexpr double shallow = 0.04, shallowOfMany = 0.1;
constexpr int maxShrinkings = 48;
/// Least start diameter of a second search, in the model's unit.
constexpr double minSecondStart = 0.001;
/// Largest number of hidden faces that are skipped for one ball.
constexpr std::size_t maxHidden = 16;
/// Distance by which lines of sight begin and end inside the faces, as a share of the line's length. On an edge,
/// rounding would decide what they hit.
constexpr double inset = 1e-3;

/// Moves p towards `goal`, by at most `length`.
Vec3 towards(const Vec3& p, const Vec3& goal, double length)
{
    const Vec3 way = goal - p;
    const double distance = way.norm();
    return distance > length ? Vec3(p + length / distance * way) : goal;
}

/// Squared cosine of half the least angle between the normals of opposite faces.
constexpr double minSteepness = (1 - maxOppositeCosine) / 2;

/// Returns whether a ball that touches the surface at p and at p + way has its two contact normals 120 degrees or more
/// apart.
bool isSteep(const Vec3& way, const Vec3& inward)
{
    const double height = way.dot(inward);
    return height > 0 && height * height >= minSteepness * way.squaredNorm();
}

/// Returns the point q of a segment that gives the least ball touching the surface at p, among the points that are
/// steep: within 30 degrees of the normal. The diameter f(s) = |w + s e|^2 / ((w + s e) . n) has its minimum where D
/// s^2 + 2 C s + 2 B C - D A = 0, with A = w . w, B = w . e, C = w . n and D = e . n. The steep points form an
/// interval, unless the segment itself is steep. Returns nothing if no point is steep.
std::optional<Vec3> steepPoint(const Vec3& p, const Vec3& inward, const Vec3& from, const Vec3& to)
{
    const Vec3 w = from - p, side = to - from;
    const double length = side.norm();
    if (length == 0)
        return isSteep(w, inward) ? std::optional(from) : std::nullopt;
    const Vec3 e = side / length;
    const double a = w.squaredNorm(), b = w.dot(e), c = w.dot(inward), d = e.dot(inward);
    const double square = d * d - minSteepness, half = c * d - minSteepness * b, constant = c * c - minSteepness * a;
    const double inRoot = half * half - square * constant;
    if (square >= 0 || inRoot < 0)
        return std::nullopt;
    const double low = std::max(0.0, (-half + std::sqrt(inRoot)) / square),
                 high = std::min(length, (-half - std::sqrt(inRoot)) / square);
    if (low > high || c + (low + high) / 2 * d <= 0)
        return std::nullopt;
    const double root = std::sqrt(std::max(0.0, c * c - d * (2 * b * c - d * a)));
    const double best = std::abs(d) < 1e-9 ? -b : (root - c) / d;
    return Vec3(from + std::clamp(best, low, high) * e);
}

double ballOf(const Vec3& way, const Vec3& inward)
{
    return way.squaredNorm() / way.dot(inward);
}

/// Returns the point q of an opposite face that gives the least ball touching the surface at p, among the steep points.
/// It is where the ball touches the face's plane, or a point on a side of the face.
std::optional<Vec3> steepPoint(const Vec3& p, const Vec3& inward, const std::array<Vec3, 3>& face)
{
    constexpr double inside = 1e-12;
    const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized(), chord = inward + normal;
    const Vec3 q = p + (face[0] - p).dot(normal) / chord.dot(normal) * chord;
    if (isSteep(q - p, inward) && (nearestInTriangle(q, face) - q).squaredNorm() <= inside * (q - p).squaredNorm())
        return q;
    std::optional<Vec3> least;
    for (std::size_t i = 0; i < 3; ++i)
        if (const auto onSide = steepPoint(p, inward, face[i], face[(i + 1) % 3]))
            if (!least || ballOf(*onSide - p, inward) < ballOf(*least - p, inward))
                least = onSide;
    return least;
}

/// Faces found to be hidden from the contact point of one ball.
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

WallBalls::WallBalls(const TriangleMesh& mesh, const WallSurface& surface, const WallRays& rays)
    : m_mesh(mesh)
    , m_surface(surface)
    , m_rays(rays)
    , m_shallow(surface.hasMany() ? shallowOfMany : shallow)
{}

/// A cell in the frame of its face: x along the face's longest side, z inward. A long thin cell across the world's axes
/// has a wide box in space, but a narrow one in this frame.
class WallBalls::LiftedCell
{
public:
    LiftedCell(const WallTree& tree, const std::array<Vec3, 3>& face, const std::array<Vec3, 3>& cell,
               const Vec3& inward)
        : m_origin(cell[0])
    {
        Vec3 longest = face[1] - face[0];
        for (std::size_t i = 1; i < 3; ++i)
            if (const Vec3 side = face[(i + 1) % 3] - face[i]; side.squaredNorm() > longest.squaredNorm())
                longest = side;
        m_axes.row(2) = inward;
        m_axes.row(0) = (longest - longest.dot(inward) * inward).normalized();
        m_axes.row(1) = inward.cross(Vec3(m_axes.row(0)));
        for (std::size_t i = 0; i < 3; ++i) {
            m_cell[i] = toFrame(cell[i]);
            m_cell[i].z() = 0;
            m_space.extend(cell[i]);
        }
        m_min = m_cell[0].cwiseMin(m_cell[1]).cwiseMin(m_cell[2]);
        m_max = m_cell[0].cwiseMax(m_cell[1]).cwiseMax(m_cell[2]);
        m_error = 2 * std::max(tree.errorOf(m_space.min()), tree.errorOf(m_space.max()));
    }

    void lift(double height)
    {
        for (Vec3& p : m_cell)
            p.z() = height;
        m_min.z() = m_max.z() = height;
        m_isWide = m_space.sizes().maxCoeff() > height;
        const Vec3 lift = height * Vec3(m_axes.row(2));
        const double error = m_error + 1e-6 * height;
        m_float.error = static_cast<float>(error);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            m_float.high[i] = static_cast<float>(m_space.max()[k] + lift[k] + error);
            m_float.low[i] = static_cast<float>(m_space.min()[k] + lift[k] - error);
            m_float.max[i] = static_cast<float>(m_max[k] + error);
            m_float.min[i] = static_cast<float>(m_min[k] - error);
            m_float.origin[i] = static_cast<float>(m_origin[k]);
            for (std::size_t j = 0; j < 3; ++j)
                m_float.axes[i][j] = static_cast<float>(m_axes(k, static_cast<Eigen::Index>(j)));
        }
    }
    Vec3 toFrame(const Vec3& p) const { return m_axes * (p - m_origin); }
    Vec3 toSpace(const Vec3& p) const { return m_axes.transpose() * p + m_origin; }
    /// Returns the lifted corners in space.
    std::array<Vec3, 3> corners() const { return {toSpace(m_cell[0]), toSpace(m_cell[1]), toSpace(m_cell[2])}; }

    /// Returns lower bounds of the squared distances from the lifted cell to eight boxes; infinity for boxes behind the
    /// face.
    WallTree::Floats operator()(const WallTree::Node& node) const
    {
        constexpr float closer = 1 - 1e-6F;
        using Floats = WallTree::Floats;
        Floats inSpace = Floats::Zero(), inFrame = Floats::Zero(), top = Floats::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            inSpace += (node.min[i] - m_float.high[i]).max(m_float.low[i] - node.max[i]).max(0.0F).square();
        if (!m_isWide)
            return closer * inSpace;
        std::array<Floats, 3> centre, half;
        for (std::size_t i = 0; i < 3; ++i) {
            centre[i] = 0.5F * (node.min[i] + node.max[i]) - m_float.origin[i];
            half[i] = 0.5F * (node.max[i] - node.min[i]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::array<float, 3>& axis = m_float.axes[k];
            const Floats middle = axis[0] * centre[0] + axis[1] * centre[1] + axis[2] * centre[2];
            const Floats extent =
                std::abs(axis[0]) * half[0] + std::abs(axis[1]) * half[1] + std::abs(axis[2]) * half[2];
            inFrame += (middle - extent - m_float.max[k]).max(m_float.min[k] - middle - extent).max(0.0F).square();
            top = middle + extent;
        }
        const Floats bound = closer * inFrame.max(inSpace);
        return (top <= -m_float.error).select(Floats::Constant(std::numeric_limits<float>::infinity()), bound);
    }
    /// Returns the nearest pair of the lifted cell and a segment, in the frame, if it is steep: the ball that touches
    /// the face reaches the segment within 30 degrees of the face's normal. Otherwise returns approximately the nearest
    /// steep pair, or none. From the squared distance `bound` on any pair is good enough.
    NearestPair nearestSteepPair(const Vec3& from, const Vec3& to, double bound) const
    {
        const NearestPair pair = nearestOfTriangleAndSegment(m_cell, from, to);
        if (pair.squaredDistance >= bound || isSteepFromBelow(pair))
            return pair;
        const Vec3 p = nearestOfTriangleAndSegment(below(), from, to).a;
        return toPoint(p, steepPoint(p, Vec3::UnitZ(), from, to));
    }
    /// Returns the nearest steep pair of the lifted cell and an opposite triangle, in the frame.
    NearestPair nearestSteepPair(const std::array<Vec3, 3>& triangle, double bound) const
    {
        const NearestPair pair = nearestOfTriangles(m_cell, triangle);
        if (pair.squaredDistance >= bound || isSteepFromBelow(pair))
            return pair;
        const Vec3 p = pair.a - Vec3(0, 0, pair.a.z());
        if (const auto q = steepPoint(p, Vec3::UnitZ(), triangle))
            return toPoint(p, q);
        const Vec3 nearest = nearestOfTriangles(below(), triangle).a;
        return toPoint(nearest, steepPoint(nearest, Vec3::UnitZ(), triangle));
    }
    double gapTo(const std::array<Vec3, 3>& triangle) const
    {
        const Vec3 max = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
        return max.z() <= 0 ? noBall : gapTo(triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]), max);
    }

private:
    /// Returns the cell before lifting, in the plane of its face.
    std::array<Vec3, 3> below() const
    {
        std::array<Vec3, 3> cell = m_cell;
        for (Vec3& p : cell)
            p.z() = 0;
        return cell;
    }
    bool isSteepFromBelow(const NearestPair& pair) const
    {
        return isSteep(pair.b - pair.a + pair.a.z() * Vec3::UnitZ(), Vec3::UnitZ());
    }
    /// Returns the pair of the ball's centre above the face's point p and a point q; no pair if there is no q.
    NearestPair toPoint(const Vec3& p, const std::optional<Vec3>& q) const
    {
        const Vec3 centre = p + m_min.z() * Vec3::UnitZ();
        return q ? NearestPair{centre, *q, (*q - centre).squaredNorm()} : NearestPair();
    }
    double gapTo(const Vec3& min, const Vec3& max) const
    {
        return (min - m_max).cwiseMax(m_min - max).cwiseMax(0.0).squaredNorm();
    }

    /// Numbers for the box tests, widened by the float32 error.
    struct InFloats
    {
        std::array<float, 3> low, high, min, max, origin;
        std::array<std::array<float, 3>, 3> axes;
        float error;
    };

    Vec3 m_origin, m_min, m_max;
    Eigen::Matrix3d m_axes;
    std::array<Vec3, 3> m_cell;
    Box m_space; ///< box of the cell before lifting
    double m_error;
    InFloats m_float;
    bool m_isWide = false; ///< the cell is wider than its lift, so that bounds in the frame are tighter than in space
};

/// Returns whether the cell has a corner, or a point of an edge, that its face shares with the other face.
bool WallBalls::doTouch(Slot position, const WallCell& cell, Slot other) const
{
    const Triangle &own = m_mesh.triangles[m_surface.faceAt(position)],
                   &others = m_mesh.triangles[m_surface.faceAt(other)];
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

/// Returns the start diameter for a second search with a small ball, 0 if it would be too small to matter. A large ball
/// misses walls near its own contact point, because they reach less deep into it than the threshold m_shallow.
double WallBalls::secondStart(double diameter) const
{
    const double second = m_shallow / (2 - m_shallow) * diameter;
    return diameter < noBall && second > minSecondStart ? second : 0;
}

double WallBalls::byBall(Slot position, const Vec3& p, double start) const
{
    const double found = shrunk(position, p, start);
    const double second = secondStart(std::min(start, found));
    return second > 0 ? std::min(found, shrunk(position, p, second)) : found;
}

/// Shrinks the ball to the last contact, which gives the least diameter. Visibility is tested only for this contact; if
/// it is hidden, the search is repeated with a test at each step.
double WallBalls::shrunk(Slot position, const Vec3& p, double start) const
{
    const Vec3 inward = m_surface.inwardOf(position);
    double diameter = start;
    std::optional<Touch> last;
    for (int i = 0; i < maxShrinkings; ++i) {
        const auto touch = nearestOpposite(position, p, diameter / 2, {});
        if (!touch)
            break;
        last = touch;
        diameter = ballOf(touch->q - p, inward);
    }
    if (!last)
        return noBall;
    return m_rays.isInSight(position, p, last->q) ? diameter : shrunkInSight(position, p, start);
}

double WallBalls::shrunkInSight(Slot position, const Vec3& p, double start) const
{
    const Vec3 inward = m_surface.inwardOf(position);
    double diameter = start, found = noBall;
    HiddenFaces hidden;
    for (int i = 0; i < maxShrinkings; ++i) {
        const auto touch = nearestOpposite(position, p, diameter / 2, hidden.all());
        if (!touch)
            break;
        if (m_rays.isInSight(position, p, touch->q))
            found = diameter = ballOf(touch->q - p, inward);
        else if (hidden.isFull())
            break;
        else
            hidden.add(touch->position);
    }
    return found;
}

ThinnestPlace WallBalls::thinnestIn(Slot position, const WallCell& cell, double start) const
{
    ThinnestPlace found = shrunk(position, cell, start);
    if (const double second = secondStart(std::min(start, found.diameter)); second > 0) {
        const ThinnestPlace near = shrunk(position, cell, second);
        const double hidden = std::min(found.hidden, near.hidden);
        if (near.diameter < found.diameter)
            found = near;
        found.hidden = hidden;
    }
    return found;
}

ThinnestPlace WallBalls::shrunk(Slot position, const WallCell& cell, double start) const
{
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = m_surface.pointOf(position, cell.weights[i]);
    const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3, inward = m_surface.inwardOf(position);
    LiftedCell lifted(m_surface.tree(), m_surface.cornersOf(position), corners, inward);
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
        const auto [a, b, c] = m_surface.cornersOf(touch->position);
        const double found = ballOf(way, inward);
        if (m_rays.isInSight(position, p, towards(touch->q, (a + b + c) / 3, inset * way.norm()))) {
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

/// Returns the nearest pair of points. A face that is not opposite counts only by its opposite edges and corners.
template <typename NearestOfFace, typename NearestOfSide>
NearestPair WallBalls::nearestOf(Slot position, const Vec3& inward, Slot other, NearestOfFace ofFace,
                                 NearestOfSide ofSide) const
{
    if (m_surface.areOpposite(position, other))
        return ofFace();
    NearestPair nearest;
    const auto keep = [&](std::size_t from, std::size_t to) {
        if (const NearestPair pair = ofSide(from, to); pair.squaredDistance < nearest.squaredDistance)
            nearest = pair;
    };
    const Slot face = m_surface.faceAt(other);
    for (std::size_t i = 0; i < 3; ++i) {
        if (m_surface.edges().isOppositeSide(face, i, inward))
            keep((i + 1) % 3, (i + 2) % 3);
        if (m_surface.edges().isOppositeCorner(m_mesh.triangles[face][i], inward))
            keep(i, i);
    }
    return nearest;
}

std::optional<WallBalls::Touch> WallBalls::nearestOpposite(Slot position, const Vec3& p, double radius,
                                                           std::span<const Slot> hidden) const
{
    const Vec3 inward = m_surface.inwardOf(position), centre = p + radius * inward;
    const auto pairWith = [&](const std::optional<Vec3>& q) {
        return q ? NearestPair{p, *q, (*q - centre).squaredNorm()} : NearestPair();
    };
    std::optional<Touch> nearest;
    double min = (1 - m_shallow) * radius * (1 - m_shallow) * radius;
    const WallTree::Point point(m_surface.tree(), centre);
    const WallTree::Opposite opposite(inward, maxOppositeCosine);
    const auto reach = [&](const WallTree::Node& node) { return opposite(node, point(node)); };
    m_surface.tree().forEachNear(reach, min, [&](Slot other) {
        if (!m_surface.mayTouch(position, other) || m_surface.reach(other, std::array{centre}) >= min ||
            std::ranges::find(hidden, other) != hidden.end())
            return min;
        const std::array<Vec3, 3> corners = m_surface.cornersOf(other);
        const NearestPair pair = nearestOf(
            position, inward, other,
            [&] {
                const Vec3 q = nearestInTriangle(centre, corners);
                const bool isNear = (q - centre).squaredNorm() < min;
                return !isNear || isSteep(q - p, inward) ? pairWith(q) : pairWith(steepPoint(p, inward, corners));
            },
            [&](std::size_t from, std::size_t to) {
                return pairWith(steepPoint(p, inward, corners[from], corners[to]));
            });
        if (pair.squaredDistance < min) {
            min = pair.squaredDistance;
            nearest = {pair.a, pair.b, other};
        }
        return min;
    });
    return nearest;
}

std::optional<WallBalls::Touch> WallBalls::nearestOpposite(Slot position, const WallCell& cell,
                                                           const LiftedCell& lifted, double radius,
                                                           std::span<const Slot> hidden) const
{
    const Vec3 inward = m_surface.inwardOf(position);
    const auto inSpace = [&](NearestPair pair) {
        if (!std::isfinite(pair.squaredDistance))
            return pair;
        pair.a.z() = 0;
        return NearestPair{lifted.toSpace(pair.a), lifted.toSpace(pair.b), pair.squaredDistance};
    };
    std::optional<Touch> nearest;
    double min = (1 - shallow) * radius * (1 - shallow) * radius;
    const WallTree::Opposite opposite(inward, maxOppositeCosine);
    const auto reach = [&](const WallTree::Node& node) { return opposite(node, lifted(node)); };
    const std::array<Vec3, 3> ownCorners = lifted.corners();
    m_surface.tree().forEachNear(reach, min, [&](Slot other) {
        if (!m_surface.mayTouch(position, other) || m_surface.reach(other, ownCorners) >= min ||
            std::ranges::find(hidden, other) != hidden.end())
            return min;
        std::array<Vec3, 3> corners = m_surface.cornersOf(other);
        for (Vec3& corner : corners)
            corner = lifted.toFrame(corner);
        if (lifted.gapTo(corners) >= min || doTouch(position, cell, other))
            return min;
        const NearestPair pair = nearestOf(
            position, inward, other, [&] { return inSpace(lifted.nearestSteepPair(corners, min)); },
            [&](std::size_t from, std::size_t to) {
                return inSpace(lifted.nearestSteepPair(corners[from], corners[to], min));
            });
        if (pair.squaredDistance < min) {
            min = pair.squaredDistance;
            nearest = {pair.a, pair.b, other};
        }
        return min;
    });
    return nearest;
}

} // namespace core
