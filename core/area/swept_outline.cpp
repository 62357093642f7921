// Sweeps a closed curve through a model:
//   1. project   the curve and the model along the lines of sight onto a plane
//   2. clip      the curve to the model's rectangle there, so that the solid is about as large as the model
//   3. resolve   crossings of the curve                                                        winding_outline
//   4. cap       in front of the model and behind it                                           polygon_triangulation
//   5. wall      between the caps, in rows of triangles about as large as the model's

#include "core/area/swept_outline.h"

#include "core/area/fitted_loops.h"
#include "core/area/sight.h"
#include "core/mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
using Flat = Eigen::Vector2d;
using FlatBox = Eigen::AlignedBox2d;

/// Distance from the model to the caps and to the clipping rectangle, as a share of the model's size.
constexpr double margin = 0.03;
/// Least depth of the front cap in perspective, as a share of the greatest depth of the model.
constexpr double minDepth = 1e-3;
/// Largest number of wall faces; above it they are made larger than the model's.
constexpr double maxWallFaces = 60'000;

/// The model as seen: its range of depths, and the rectangle around it if all of it is in front of the eye.
struct SeenModel
{
    double front = 0, back = 0; ///< depths of the caps
    FlatBox rectangle;          ///< empty: there is none
    double edge = 0;            ///< mean edge length, mm
};

SeenModel seenModel(const Sight& sight, const Mesh& mesh)
{
    Box box;
    for (const Slot v : mesh.vertices())
        box.extend(mesh.point(v).cast<double>());
    const double size = box.diagonal().norm();
    SeenModel model{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), {}, 0};
    for (const Slot v : mesh.vertices()) {
        const Vec3 at = sight.seen(mesh.point(v).cast<double>());
        model.front = std::min(model.front, at.z());
        model.back = std::max(model.back, at.z());
        model.rectangle.extend(Flat(at.head<2>()));
    }
    model.front -= margin * size;
    model.back += margin * size;
    const double least = minDepth * model.back;
    if (sight.isPerspective() && model.front < least) {
        model.front = least;
        model.rectangle.setEmpty();
    }
    if (!model.rectangle.isEmpty()) {
        const Flat by = margin * model.rectangle.diagonal().norm() * Flat::Ones();
        model.rectangle = FlatBox(model.rectangle.min() - by, model.rectangle.max() + by);
    }
    double length = 0;
    for (const Slot e : mesh.edges())
        length += static_cast<double>((mesh.point(mesh.to(2 * e)) - mesh.point(mesh.to(2 * e + 1))).norm());
    model.edge = length / static_cast<double>(mesh.live().edges);
    return model;
}

/// Clips a closed curve to one side of a line parallel to an axis (Sutherland and Hodgman 1974). Winding numbers of
/// points on that side stay as they are.
std::vector<Flat> clipped(const std::vector<Flat>& curve, int axis, double limit, bool isUpper)
{
    std::vector<Flat> result;
    const auto isKept = [&](const Flat& p) { return isUpper ? p[axis] <= limit : p[axis] >= limit; };
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Flat& p = curve[i];
        const Flat& q = curve[(i + 1) % curve.size()];
        if (isKept(p))
            result.push_back(p);
        if (isKept(p) == isKept(q))
            continue;
        Flat cut = p + (limit - p[axis]) / (q[axis] - p[axis]) * (q - p);
        cut[axis] = limit;
        result.push_back(cut);
    }
    return result;
}

std::vector<Flat> clipped(std::vector<Flat> curve, const FlatBox& box)
{
    for (int axis = 0; axis < 2; ++axis) {
        curve = clipped(curve, axis, box.min()[axis], false);
        curve = clipped(curve, axis, box.max()[axis], true);
    }
    return curve;
}

/// Builds the solid between the two caps.
class Sweeper
{
public:
    Sweeper(const Sight& sight, const SeenModel& model, const FittedLoops& outline);

    TriangleMesh solid();

private:
    struct Side
    {
        Slot from, to; ///< corners, as indices in m_corners
        int parts;     ///< number of wall edges in a row
    };
    Slot add(const Flat& at, double depth)
    {
        m_mesh.points.push_back(m_sight.placed(at, depth).cast<float>());
        return static_cast<Slot>(m_mesh.points.size() - 1);
    }
    double wallFaces(double edge);
    void addWall(const Side& side, std::span<const Slot> firsts, std::span<const Slot> afters);

    const Sight& m_sight;
    const SeenModel& m_model;
    std::vector<Flat> m_corners;
    std::vector<FlatPoint> m_points;
    std::vector<std::vector<Slot>> m_loops;
    std::vector<Side> m_sides;
    int m_rows = 1; ///< rows of wall points between the caps
    TriangleMesh m_mesh;
};

Sweeper::Sweeper(const Sight& sight, const SeenModel& model, const FittedLoops& outline)
    : m_sight(sight)
    , m_model(model)
{
    for (const FlatLoop& flat : outline.loops()) {
        std::vector<Slot>& loop = m_loops.emplace_back();
        const auto first = static_cast<Slot>(m_corners.size());
        for (std::size_t i = 0; i < flat.size(); ++i) {
            loop.push_back(first + static_cast<Slot>(i));
            m_points.push_back(flat[i]);
            m_corners.push_back(outline.placeOf(flat[i]));
            m_sides.push_back({loop.back(), first + static_cast<Slot>((i + 1) % flat.size()), 1});
        }
    }
}

/// Divides the walls into edges of about this length. Returns the number of faces that they would have.
double Sweeper::wallFaces(double edge)
{
    const double depth = m_model.back - m_model.front;
    const double scale = m_sight.scaleAt((m_model.front + m_model.back) / 2);
    double sum = 0;
    for (Side& side : m_sides) {
        const double parts = std::ceil((m_corners[side.to] - m_corners[side.from]).norm() * scale / edge);
        side.parts = static_cast<int>(std::clamp(parts, 1.0, maxWallFaces));
        sum += side.parts;
    }
    m_rows = static_cast<int>(std::clamp(std::ceil(depth / edge) - 1, 1.0, maxWallFaces));
    return 2 * sum * m_rows;
}

/// Adds the wall along a side. `firsts` and `afters`: points at its two ends, from the front cap to the back cap.
void Sweeper::addWall(const Side& side, std::span<const Slot> firsts, std::span<const Slot> afters)
{
    std::vector<Slot> before;
    for (int row = 1; row <= m_rows; ++row) {
        const double depth = std::lerp(m_model.front, m_model.back, static_cast<double>(row) / (m_rows + 1));
        std::vector<Slot> points = {firsts[static_cast<std::size_t>(row)]};
        for (int part = 1; part < side.parts; ++part) {
            const double share = static_cast<double>(part) / side.parts;
            points.push_back(add(m_corners[side.from] + share * (m_corners[side.to] - m_corners[side.from]), depth));
        }
        points.push_back(afters[static_cast<std::size_t>(row)]);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            if (row == 1) {
                m_mesh.triangles.push_back({firsts.front(), points[i + 1], points[i]});
            } else {
                m_mesh.triangles.push_back({before[i], before[i + 1], points[i + 1]});
                m_mesh.triangles.push_back({before[i], points[i + 1], points[i]});
            }
        }
        before = std::move(points);
    }
    m_mesh.triangles.push_back({firsts.front(), afters.front(), afters[1]});
    for (std::size_t i = 0; i + 1 < before.size(); ++i)
        m_mesh.triangles.push_back({before[i], before[i + 1], firsts.back()});
    m_mesh.triangles.push_back({before.back(), afters.back(), firsts.back()});
}

/// Returns the solid; empty if loops cross.
TriangleMesh Sweeper::solid()
{
    constexpr double larger = 1.25;
    const auto cap = triangulatePolygon(m_points, m_loops);
    if (!cap)
        return {};
    for (double edge = m_model.edge; wallFaces(edge) > maxWallFaces && m_rows > 1;)
        edge *= larger;
    std::vector<std::vector<Slot>> columns(m_corners.size()); // points of each corner, from front to back
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        for (int row = 0; row <= m_rows + 1; ++row)
            columns[i].push_back(
                add(m_corners[i], std::lerp(m_model.front, m_model.back, static_cast<double>(row) / (m_rows + 1))));
    }
    for (const auto& [a, b, c] : *cap) {
        m_mesh.triangles.push_back({columns[a].front(), columns[c].front(), columns[b].front()});
        m_mesh.triangles.push_back({columns[a].back(), columns[b].back(), columns[c].back()});
    }
    for (const Side& side : m_sides)
        addWall(side, columns[side.from], columns[side.to]);
    return std::move(m_mesh);
}
} // namespace

SweptOutline sweptOutline(const ViewArea& area, const Mesh& mesh)
{
    const Sight sight(area);
    const std::vector<Flat> curve = sight.seenCurve(area.outline);
    SweptOutline swept;
    const FittedLoops whole(curve);
    swept.hasArea = !whole.loops().empty();
    const SeenModel model = seenModel(sight, mesh);
    if (!swept.hasArea || !(model.back > model.front))
        return swept;
    FlatBox box;
    for (const Flat& p : curve)
        box.extend(p);
    if (model.rectangle.isEmpty() || model.rectangle.contains(box)) {
        swept.solid = Sweeper(sight, model, whole).solid();
        swept.hasArea = !swept.solid.triangles.empty();
    } else if (const FittedLoops part(clipped(curve, model.rectangle)); !part.loops().empty()) {
        swept.solid = Sweeper(sight, model, part).solid();
        swept.hasArea = !swept.solid.triangles.empty();
    }
    return swept;
}
} // namespace core
