// Source: Web3D Consortium, ISO/IEC 19775-1, 13.3.2 (Cone), 13.3.3 (Cylinder), 13.3.5 (Extrusion: planes of the
// cross-sections along the spine).
#include "core/io/mesh/x3d_solids.h"

#include "core/geometry/geometry.h"
#include "core/geometry/rotation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>

namespace core::io
{
namespace
{
constexpr int sides = 32;
/// Sine of the largest turn of a spine that counts as straight. Rounding of the points causes such turns in any
/// direction. Curves with fewer than 60,000 segments a full turn have larger ones.
constexpr double straightTurn = 1e-4;

/// Collects points and faces as text.
class FaceText
{
public:
    explicit FaceText(bool isReversed) : m_isReversed(isReversed) {}

    int addPoint(const Vec3& point)
    {
        for (int axis = 0; axis < 3; ++axis)
            appendNumber(m_faces.points, point[axis]);
        return m_points++;
    }
    void addFace(std::vector<int> corners)
    {
        if (m_isReversed)
            std::reverse(corners.begin(), corners.end());
        for (const int corner : corners)
            appendNumber(m_faces.coordIndex, corner);
        appendNumber(m_faces.coordIndex, -1);
    }
    X3dFaces take() { return std::move(m_faces); }

private:
    X3dFaces m_faces;
    int m_points = 0;
    bool m_isReversed;
};

/// Adds a ring of points about the y axis, anticlockwise as seen from above.
std::vector<int> addRing(FaceText& to, double radius, double y)
{
    std::vector<int> ring;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        ring.push_back(to.addPoint({radius * std::cos(angle), y, -radius * std::sin(angle)}));
    }
    return ring;
}

std::vector<int> reversed(std::vector<int> ring)
{
    std::reverse(ring.begin(), ring.end());
    return ring;
}

X3dFaces coneOf(const FileBytes& file, const X3dNode& node)
{
    const double radius = x3dNumber(file, node, "bottomRadius", "1"), height = x3dNumber(file, node, "height", "2");
    FaceText faces(false);
    const std::vector<int> ring = addRing(faces, radius, -height / 2);
    const int apex = faces.addPoint({0, height / 2, 0});
    for (int i = 0; i < sides && !node.isFalse("side"); ++i)
        faces.addFace({ring[i], ring[(i + 1) % sides], apex});
    if (!node.isFalse("bottom"))
        faces.addFace(reversed(ring));
    return faces.take();
}

X3dFaces cylinderOf(const FileBytes& file, const X3dNode& node)
{
    const double radius = x3dNumber(file, node, "radius", "1"), height = x3dNumber(file, node, "height", "2");
    FaceText faces(false);
    const std::vector<int> lower = addRing(faces, radius, -height / 2), upper = addRing(faces, radius, height / 2);
    for (int i = 0; i < sides && !node.isFalse("side"); ++i)
        faces.addFace({lower[i], lower[(i + 1) % sides], upper[(i + 1) % sides], upper[i]});
    if (!node.isFalse("bottom"))
        faces.addFace(reversed(lower));
    if (!node.isFalse("top"))
        faces.addFace(upper);
    return faces.take();
}

/// A cross-section that is swept along a spine.
struct Extrusion
{
    std::vector<Vec3> spine;
    std::vector<Eigen::Vector2d> section;
    std::vector<double> scale, orientation;
    bool isSpineClosed = false, isSectionClosed = false;
};

/// Returns whether the first and the last value are equal; each value has `each` numbers.
bool endsAsItBegins(const std::vector<double>& values, std::size_t each)
{
    const auto last = values.begin() + static_cast<std::ptrdiff_t>(each * (values.size() / each - 1));
    return std::equal(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(each), last);
}

Extrusion extrusionOf(const FileBytes& file, const X3dNode& node, double radians)
{
    Extrusion result;
    const auto spine = x3dNumbers(file, node, "spine", "0 0 0 0 1 0"),
               section = x3dNumbers(file, node, "crossSection", "1 1 1 -1 -1 -1 -1 1 1 1");
    for (std::size_t i = 0; i + 3 <= spine.size(); i += 3)
        result.spine.emplace_back(spine[i], spine[i + 1], spine[i + 2]);
    for (std::size_t i = 0; i + 2 <= section.size(); i += 2)
        result.section.emplace_back(section[i], section[i + 1]);
    result.scale = x3dNumbers(file, node, "scale", "1 1");
    result.orientation = x3dNumbers(file, node, "orientation", "0 0 1 0");
    if (result.scale.size() < 2 || result.orientation.size() < 4)
        refuseX3d(file, node, FileFault::Number, {});
    for (std::size_t i = 3; i < result.orientation.size(); i += 4)
        result.orientation[i] *= radians;
    result.isSectionClosed = result.section.size() > 2 && result.section.front() == result.section.back();
    if (result.isSectionClosed)
        result.section.pop_back();
    result.isSpineClosed = result.spine.size() > 3 && result.spine.front() == result.spine.back() &&
                           endsAsItBegins(result.scale, 2) && endsAsItBegins(result.orientation, 4);
    if (result.isSpineClosed)
        result.spine.pop_back();
    return result;
}

/// Returns for each point the direction of the spine, or, if `isTurning`, the normal of the plane in which it turns.
std::vector<Vec3> alongSpine(const Extrusion& extrusion, bool isTurning)
{
    const std::vector<Vec3>& spine = extrusion.spine;
    const std::size_t last = spine.size() - 1;
    std::vector<Vec3> result;
    for (std::size_t i = 0; i <= last; ++i) {
        const Vec3 &before = spine[i > 0                     ? i - 1
                                   : extrusion.isSpineClosed ? last
                                                             : 0],
                   &after = spine[i < last                  ? i + 1
                                  : extrusion.isSpineClosed ? 0
                                                            : last];
        // `turning` is 0 at an end.
        const Vec3 ahead = after - spine[i], back = before - spine[i], turning = ahead.cross(back);
        const bool isStraight = turning.norm() <= straightTurn * ahead.norm() * back.norm();
        if (isTurning)
            result.push_back(isStraight ? Vec3(0, 0, 0) : turning.normalized());
        else
            result.push_back((after - before).normalized());
    }
    return result;
}

bool isDirection(const Vec3& v)
{
    return v.squaredNorm() > 0.5;
}

/// Gives each point without a direction that of the preceding point; points at the beginning get the first direction
/// that exists. Returns whether there is any.
bool fillDirections(std::vector<Vec3>& directions)
{
    const auto first = std::find_if(directions.begin(), directions.end(), isDirection);
    if (first == directions.end())
        return false;
    Vec3 last = *first;
    for (Vec3& direction : directions)
        last = direction = isDirection(direction) ? direction : last;
    return true;
}

/// Returns the frames of the cross-sections: x and z are in their planes, y is along the spine.
std::vector<Eigen::Matrix3d> framesOf(const Extrusion& extrusion)
{
    std::vector<Vec3> y = alongSpine(extrusion, false), z = alongSpine(extrusion, true);
    const bool hasWay = fillDirections(y);
    if (!fillDirections(z)) { // the spine is straight
        const Vec3 up = hasWay ? y.front() : Vec3(0, 1, 0);
        return std::vector<Eigen::Matrix3d>(y.size(), rotationBetween(Vec3(0, 1, 0), up).toRotationMatrix());
    }
    std::vector<Eigen::Matrix3d> frames;
    Vec3 last = z.front();
    for (std::size_t i = 0; i < y.size(); ++i) {
        const Vec3 axis = z[i].dot(last) < 0 ? Vec3(-z[i]) : z[i];
        last = axis;
        Eigen::Matrix3d frame;
        frame << y[i].cross(axis), y[i], axis;
        frames.push_back(frame);
    }
    return frames;
}

/// Returns the values for a point of the spine. If there are too few, the last ones are used.
const double* valuesAt(const std::vector<double>& values, std::size_t each, std::size_t point)
{
    return values.data() + each * std::min(point, values.size() / each - 1);
}

/// Adds the rings of the cross-sections. A cross-section that equals the preceding one shares its points.
std::vector<std::vector<int>> addRings(const Extrusion& extrusion, FaceText& to)
{
    const std::vector<Eigen::Matrix3d> frames = framesOf(extrusion);
    std::vector<std::vector<int>> rings;
    std::vector<Vec3> before;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const double *scale = valuesAt(extrusion.scale, 2, i), *turn = valuesAt(extrusion.orientation, 4, i);
        Eigen::Matrix3d frame = frames[i];
        if (const Vec3 axis(turn[0], turn[1], turn[2]); axis.norm() > 0)
            frame *= Eigen::AngleAxisd(turn[3], axis.normalized()).toRotationMatrix();
        std::vector<Vec3> points;
        for (const Eigen::Vector2d& p : extrusion.section)
            points.emplace_back(extrusion.spine[i] + frame * Vec3(scale[0] * p.x(), 0, scale[1] * p.y()));
        if (points == before) {
            rings.push_back(rings.back());
            continue;
        }
        std::vector<int>& ring = rings.emplace_back();
        for (const Vec3& point : points)
            ring.push_back(to.addPoint(point));
        before = std::move(points);
    }
    return rings;
}

X3dFaces facesOfExtrusion(const FileBytes& file, const X3dNode& node, double radians)
{
    const Extrusion extrusion = extrusionOf(file, node, radians);
    if (extrusion.spine.size() < 2 || extrusion.section.size() < 2)
        return {};
    FaceText faces(node.isFalse("ccw"));
    const std::vector<std::vector<int>> rings = addRings(extrusion, faces);
    const std::size_t corners = extrusion.section.size();
    for (std::size_t i = 0; i + (extrusion.isSpineClosed ? 0 : 1) < rings.size(); ++i) {
        const auto &lower = rings[i], &upper = rings[(i + 1) % rings.size()];
        if (lower == upper)
            continue;
        for (std::size_t k = 0; k + (extrusion.isSectionClosed ? 0 : 1) < corners; ++k) {
            const std::size_t next = (k + 1) % corners;
            faces.addFace({lower[k], lower[next], upper[next], upper[k]});
        }
    }
    const bool mayHaveCaps = !extrusion.isSpineClosed && corners > 2;
    if (mayHaveCaps && !node.isFalse("beginCap"))
        faces.addFace(reversed(rings.front()));
    if (mayHaveCaps && !node.isFalse("endCap"))
        faces.addFace(rings.back());
    return faces.take();
}
} // namespace

std::optional<X3dFaces> facesOfX3dSolid(const FileBytes& file, const X3dNode& node, double radians)
{
    if (node.name == "Cone")
        return coneOf(file, node);
    if (node.name == "Cylinder")
        return cylinderOf(file, node);
    if (node.name == "Extrusion")
        return facesOfExtrusion(file, node, radians);
    return std::nullopt;
}
} // namespace core::io
