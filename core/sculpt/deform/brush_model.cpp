#include "core/sculpt/deform/brush_model.h"

#include "core/geometry/face_geometry.h"
#include "core/mesh/mesh_builder.h"
#include "core/util/fingerprint.h"

#include <bit>
#include <cmath>

namespace core
{
namespace
{
/// Half width of the column searched around a vertical line, so that rounding the line to float32 misses no face.
constexpr float columnSlack = 1e-6f;

/// Returns the faces' boxes, all at height 0, so that the tree is queried by vertical lines.
std::vector<FaceBox> columnsOf(const TriangleMesh& mesh)
{
    std::vector<FaceBox> boxes = faceBoxes(mesh.points, mesh.triangles);
    for (FaceBox& box : boxes)
        box.min.y() = box.max.y() = 0;
    return boxes;
}

TriangleMesh toUnitSize(const TriangleMesh& mesh)
{
    TriangleMesh unit = withoutUnusedVertices(mesh);
    unit.colors.clear();
    const Vec3 middle = boxOf(unit).center();
    double farthest2 = 0;
    for (const Vec3f& p : unit.points)
        farthest2 = std::max(farthest2, (p.cast<double>() - middle).squaredNorm());
    const double scale = 1 / std::sqrt(farthest2);
    for (Vec3f& p : unit.points)
        p = (scale * (p.cast<double>() - middle)).cast<float>();
    return unit;
}

/// Returns whether the line through (x, z) along y passes to the left of the edge. The two faces of an edge get
/// opposite answers, and no line counts as hitting the edge itself.
bool isLeftOf(const Vec3f& from, const Vec3f& to, double x, double z)
{
    const bool runsOn = from.x() < to.x() || (from.x() == to.x() && from.z() < to.z());
    const Vec3 a = (runsOn ? from : to).cast<double>(), b = (runsOn ? to : from).cast<double>();
    const bool isLeft = (b.x() - a.x()) * (z - a.z()) - (b.z() - a.z()) * (x - a.x()) >= 0;
    return isLeft == runsOn;
}

/// A point where an upward line crosses a face, entering the solid or leaving it (isExit).
struct Crossing
{
    double height;
    bool isExit;
};

std::optional<Crossing> crossingOf(const TriangleMesh& mesh, Slot face, double x, double z)
{
    const Triangle& t = mesh.triangles[face];
    const Vec3f &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const bool left = isLeftOf(a, b, x, z);
    if (isLeftOf(b, c, x, z) != left || isLeftOf(c, a, x, z) != left)
        return std::nullopt;
    const std::array<Vec3, 3> p = cornersOf(mesh, face);
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    if (normal.y() == 0)
        return std::nullopt;
    const double rise = normal.x() * (x - p[0].x()) + normal.z() * (z - p[0].z());
    const double lowest = std::min({p[0].y(), p[1].y(), p[2].y()}), highest = std::max({p[0].y(), p[1].y(), p[2].y()});
    return Crossing{std::clamp(p[0].y() - rise / normal.y(), lowest, highest), normal.y() > 0};
}

std::string fingerprintOf(const TriangleMesh& mesh)
{
    Fingerprint print;
    for (const Vec3f& p : mesh.points)
        for (const float coordinate : p)
            print.add(std::bit_cast<std::uint32_t>(coordinate + 0.0f));
    for (const Triangle& t : mesh.triangles)
        for (const Slot corner : t)
            print.add(corner);
    return print.text();
}
} // namespace

BrushModel::BrushModel(TriangleMesh surface, std::string source)
    : m_surface(std::move(surface))
    , m_source(std::move(source))
    , m_fingerprint(fingerprintOf(m_surface))
    , m_columns(columnsOf(m_surface))
{}

BrushModel::Made BrushModel::of(const TriangleMesh& mesh, std::string source)
{
    Made made;
    const Vec3 sizes = boxOf(mesh).sizes();
    if (mesh.triangles.size() > maxFaces)
        made.fault = Fault::TooManyFaces;
    else if (!(sizes.maxCoeff() >= minLength))
        made.fault = Fault::TooSmall;
    else if (made.report = checkMesh(mesh); !made.report.printReady())
        made.fault = Fault::Unsound;
    else if (sizes.minCoeff() < minThickness * sizes.maxCoeff())
        made.fault = Fault::TooFlat;
    else
        made.model = std::shared_ptr<const BrushModel>(new BrushModel(toUnitSize(mesh), std::move(source)));
    return made;
}

std::optional<BrushModel::Span> BrushModel::spanAt(const Vec3& p) const
{
    const auto x = static_cast<float>(p.x()), z = static_cast<float>(p.z());
    const FaceBox line = {{x - columnSlack, 0, z - columnSlack}, {x + columnSlack, 0, z + columnSlack}};
    std::optional<Crossing> below, above;
    m_columns.forEachMeeting(line, [&](Slot position) {
        const auto crossing = crossingOf(m_surface, m_columns.at(position), p.x(), p.z());
        if (!crossing)
            return;
        if (crossing->height <= p.y()) {
            if (!below || crossing->height > below->height)
                below = crossing;
        } else if (!above || crossing->height < above->height) {
            above = crossing;
        }
    });
    if (!below || !above || below->isExit || !above->isExit)
        return std::nullopt;
    return Span{below->height, above->height};
}
} // namespace core
