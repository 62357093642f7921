// Tests wall thickness on solids with large triangles. The reference samples the surface densely and tests every face.

#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/point_triangle.h"
#include "core/geometry/polygon_triangulation.h"
#include "core/geometry/triangle_distance.h"
#include "core/print/print_check.h"
#include "core/print/wall_edges.h"
#include "core/print/wall_surface.h"
#include "core/util/worker_pool.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

using core::FlatPoint;
using core::PrintLimits;
using core::PrintMeasures;
using core::PrintReport;
using core::Slot;
using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int perMillimetre = 1000; ///< Coordinates of flat points are rounded to 1/1000 mm.

using Loop = std::vector<FlatPoint>;

FlatPoint flat(double x, double y)
{
    return {static_cast<int>(std::lround(x * perMillimetre)), static_cast<int>(std::lround(y * perMillimetre))};
}

Loop rectangle(double x, double y, double width, double depth)
{
    return {flat(x, y), flat(x + width, y), flat(x + width, y + depth), flat(x, y + depth)};
}

Loop circle(double x, double y, double radius, int corners)
{
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        loop.push_back(flat(x + radius * std::cos(angle), y + radius * std::sin(angle)));
    }
    return loop;
}

/// A hole in a plate from its upper side down to the height `floor` in mm. 0: it goes through the plate.
struct Hole
{
    Loop loop;
    double floor = 0;
};

/// A plate with holes, extruded along z, with as few and as large triangles as possible.
class Plate
{
public:
    Plate(const Loop& outline, const std::vector<Hole>& holes, double height) : m_height(height)
    {
        std::vector<Loop> above{outline}, below{outline};
        for (const Hole& hole : holes) {
            const Loop reversed(hole.loop.rbegin(), hole.loop.rend());
            above.push_back(reversed);
            if (hole.floor <= 0)
                below.push_back(reversed);
        }
        addCap(above, m_height, true);
        addCap(below, 0, false);
        addWall(outline, 0, m_height);
        for (const Hole& hole : holes) {
            addWall(Loop(hole.loop.rbegin(), hole.loop.rend()), std::max(0.0, hole.floor), m_height);
            if (hole.floor > 0)
                addCap({hole.loop}, hole.floor, true);
        }
    }

    TriangleMesh take() { return std::move(m_mesh); }

private:
    Slot at(const FlatPoint& p, double z)
    {
        const auto [found, isNew] = m_slots.try_emplace({p.x(), p.y(), z}, static_cast<Slot>(m_mesh.points.size()));
        if (isNew)
            m_mesh.points.push_back(
                Vec3(double(p.x()) / perMillimetre, double(p.y()) / perMillimetre, z).cast<float>());
        return found->second;
    }

    void addCap(const std::vector<Loop>& loops, double z, bool looksUp)
    {
        std::vector<FlatPoint> points;
        std::vector<std::vector<Slot>> slots;
        for (const Loop& loop : loops) {
            slots.emplace_back();
            for (const FlatPoint& p : loop) {
                slots.back().push_back(static_cast<Slot>(points.size()));
                points.push_back(p);
            }
        }
        const auto triangles = core::triangulatePolygon(points, slots);
        if (!triangles)
            return; // the mesh is then not closed, and the test fails
        for (auto [a, b, c] : *triangles) {
            if (!looksUp)
                std::swap(b, c);
            m_mesh.triangles.push_back({at(points[a], z), at(points[b], z), at(points[c], z)});
        }
    }

    void addWall(const Loop& loop, double low, double high)
    {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const FlatPoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
            m_mesh.triangles.push_back({at(p, low), at(q, low), at(q, high)});
            m_mesh.triangles.push_back({at(p, low), at(q, high), at(p, high)});
        }
    }

    TriangleMesh m_mesh;
    double m_height;
    std::map<std::tuple<int, int, double>, Slot> m_slots;
};

/// Scales z linearly along x: by 1 at x = 0, by `factor` at x = `length`.
TriangleMesh tapered(TriangleMesh mesh, double length, double factor)
{
    for (Vec3f& p : mesh.points)
        p.z() = static_cast<float>(double(p.z()) * (1 + (factor - 1) * double(p.x()) / length));
    return mesh;
}

TriangleMesh turned(TriangleMesh mesh, const Eigen::Quaterniond& by)
{
    for (Vec3f& p : mesh.points)
        p = (by * p.cast<double>()).cast<float>();
    return mesh;
}

/// Divides each face into four.
TriangleMesh inQuarters(const TriangleMesh& mesh)
{
    TriangleMesh fine{mesh.points, {}, {}};
    std::map<std::pair<Slot, Slot>, Slot> middles;
    const auto middle = [&](Slot a, Slot b) {
        const auto [found, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<Slot>(fine.points.size()));
        if (isNew)
            fine.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const Slot ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const core::Triangle& t : {core::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            fine.triangles.push_back(t);
    }
    return fine;
}

/// Divides the triangles until there are so many that each is measured less accurately.
TriangleMesh inManyFaces(TriangleMesh mesh)
{
    while (mesh.triangles.size() <= 100'000)
        mesh = inQuarters(mesh);
    return mesh;
}

/// Returns a block of 40 x 30 x 20 mm with a V-shaped groove across it. The bottom of the groove leaves `left` mm.
TriangleMesh grooved(double left, double halfWidth)
{
    return Plate({flat(0, 0), flat(40, 0), flat(40, 20), flat(20 + halfWidth, 20), flat(20, left),
                  flat(20 - halfWidth, 20), flat(0, 20)},
                 {}, 30)
        .take();
}

/// Returns a wedge, by default 100 x 40 mm, whose thickness changes from `from` to `to`. Its triangles span its whole
/// length.
TriangleMesh wedge(double from, double to, double length = 100, double width = 40)
{
    return Plate({flat(0, 0), flat(length, 0), flat(length, to), flat(0, from)}, {}, width).take();
}

/// A solid of flat faces. Coordinates of corners are rounded to 1/1000 mm.
class Polyhedron
{
public:
    Slot add(double x, double y, double z)
    {
        m_mesh.points.push_back(Vec3(x, y, z).cast<float>());
        return static_cast<Slot>(m_mesh.points.size() - 1);
    }

    /// Adds a flat face. The corners are counterclockwise as seen from outside.
    void addFace(const std::vector<Slot>& corners)
    {
        Vec3 normal = Vec3::Zero();
        for (std::size_t i = 0; i < corners.size(); ++i)
            normal += at(corners[i]).cross(at(corners[(i + 1) % corners.size()]));
        Eigen::Index dropped = 0;
        normal.cwiseAbs().maxCoeff(&dropped);
        const Eigen::Index u = (dropped + 1) % 3, v = (dropped + 2) % 3;
        const bool isTurned = normal[dropped] < 0;
        std::vector<FlatPoint> points;
        std::vector<Slot> loop;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 p = at(corners[isTurned ? corners.size() - 1 - i : i]);
            points.push_back(flat(p[u], p[v]));
            loop.push_back(static_cast<Slot>(i));
        }
        const auto triangles = core::triangulatePolygon(points, {loop});
        if (!triangles)
            return; // the mesh is then not closed, and the test fails
        const auto corner = [&](Slot i) { return corners[isTurned ? corners.size() - 1 - i : i]; };
        for (auto [a, b, c] : *triangles) {
            if (isTurned)
                std::swap(b, c);
            m_mesh.triangles.push_back({corner(a), corner(b), corner(c)});
        }
    }

    TriangleMesh take() { return std::move(m_mesh); }

private:
    Vec3 at(Slot v) const { return m_mesh.points[v].cast<double>(); }

    TriangleMesh m_mesh;
};

/// Returns a plate of 40 x 40 mm with a groove on each side. At their bottoms `left` mm remain between the grooves,
/// which cross at right angles or are parallel.
TriangleMesh scored(double height, double left, double halfWidth, bool isCrossing)
{
    const double depth = (height - left) / 2, a = 20 - halfWidth, b = 20 + halfWidth;
    if (!isCrossing)
        return Plate({flat(0, 0), flat(a, 0), flat(20, depth), flat(b, 0), flat(40, 0), flat(40, height),
                      flat(b, height), flat(20, height - depth), flat(a, height), flat(0, height)},
                     {}, 40)
            .take();
    Polyhedron plate; // the upper groove is along x, the lower one along y
    const auto add = [&](double x, double y, double z) { return plate.add(x, y, z); };
    const std::array<Slot, 4> below = {add(0, 0, 0), add(40, 0, 0), add(40, 40, 0), add(0, 40, 0)};
    const std::array<Slot, 4> above = {add(0, 0, height), add(40, 0, height), add(40, 40, height), add(0, 40, height)};
    // left edge, bottom, right edge of a groove at each of its two ends
    std::array<std::array<Slot, 3>, 2> lower, upper;
    for (std::size_t i = 0; i < 2; ++i) {
        const double end = i == 0 ? 0 : 40;
        lower[i] = {add(a, end, 0), add(20, end, depth), add(b, end, 0)};
        upper[i] = {add(end, a, height), add(end, 20, height - depth), add(end, b, height)};
    }
    const auto [l0, l1] = lower;
    const auto [u0, u1] = upper;
    plate.addFace({below[0], below[3], l1[0], l0[0]});
    plate.addFace({l0[0], l1[0], l1[1], l0[1]});
    plate.addFace({l0[1], l1[1], l1[2], l0[2]});
    plate.addFace({l0[2], l1[2], below[2], below[1]});
    plate.addFace({above[0], above[1], u1[0], u0[0]});
    plate.addFace({u0[0], u1[0], u1[1], u0[1]});
    plate.addFace({u0[1], u1[1], u1[2], u0[2]});
    plate.addFace({u0[2], u1[2], above[2], above[3]});
    plate.addFace({below[0], l0[0], l0[1], l0[2], below[1], above[1], above[0]});
    plate.addFace({below[2], l1[2], l1[1], l1[0], below[3], above[3], above[2]});
    plate.addFace({below[3], below[0], above[0], u0[0], u0[1], u0[2], above[3]});
    plate.addFace({below[1], below[2], above[2], u1[2], u1[1], u1[0], above[1]});
    return plate.take();
}

/// Returns a pyramid of `sides` sides with its tip at the origin and its base towards +z.
TriangleMesh spike(int sides, double radius, double height)
{
    Polyhedron body;
    const Slot tip = body.add(0, 0, 0);
    std::vector<Slot> base;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        const FlatPoint p = flat(radius * std::cos(angle), radius * std::sin(angle));
        base.push_back(body.add(double(p.x()) / perMillimetre, double(p.y()) / perMillimetre, height));
    }
    for (std::size_t i = 0; i < base.size(); ++i)
        body.addFace({tip, base[(i + 1) % base.size()], base[i]});
    body.addFace(base);
    return body.take();
}

/// Returns a cylinder, 20 mm wide and 10 mm high, approximated by `pieces` sides. A groove around its middle leaves
/// `left` mm of wall.
TriangleMesh ringGrooved(int pieces, double left, double halfWidth)
{
    constexpr double radius = 10, middle = 5, height = 10;
    const std::array<std::array<double, 2>, 7> profile = {{{0, 0},
                                                           {radius, 0},
                                                           {radius, height},
                                                           {middle + halfWidth, height},
                                                           {middle, left},
                                                           {middle - halfWidth, height},
                                                           {0, height}}};
    TriangleMesh mesh;
    std::vector<std::vector<Slot>> rings;
    for (const auto& [r, z] : profile) {
        std::vector<Slot>& ring = rings.emplace_back();
        for (int i = 0; i < pieces; ++i) {
            if (i == 0 || r > 0) {
                const double angle = 2 * std::numbers::pi * i / pieces;
                mesh.points.push_back(Vec3(r * std::cos(angle), r * std::sin(angle), z).cast<float>());
            }
            ring.push_back(static_cast<Slot>(mesh.points.size() - 1));
        }
    }
    for (std::size_t k = 0; k + 1 < rings.size(); ++k)
        for (std::size_t i = 0; i < rings[k].size(); ++i) {
            const std::size_t next = (i + 1) % rings[k].size();
            const Slot a = rings[k][i], b = rings[k][next], c = rings[k + 1][next], d = rings[k + 1][i];
            if (a != b)
                mesh.triangles.push_back({a, b, c});
            if (c != d)
                mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

TriangleMesh movedTo(TriangleMesh mesh, const Vec3& place)
{
    return shapes::moved(std::move(mesh), place.cast<float>());
}

/// Returns a block of 30 mm with a pointed cavity whose tip is `left` mm above the floor. `isPair`: two cavities whose
/// tips point at each other.
TriangleMesh hollowed(const TriangleMesh& spike, double left, bool isPair, double aside = 0)
{
    const TriangleMesh block = movedTo(Plate(rectangle(0, 0, 30, 30), {}, 30).take(), {0, 0, 0});
    if (!isPair)
        return shapes::together(block, shapes::reversed(movedTo(spike, {15, 14, left})));
    const TriangleMesh other = turned(spike, Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX())));
    const TriangleMesh hollows =
        shapes::together(movedTo(spike, {15, 15, 15 + left / 2}), movedTo(other, {15 + aside, 15, 15 - left / 2}));
    return shapes::together(block, shapes::reversed(hollows));
}

class Random
{
public:
    explicit Random(unsigned start) : m_engine(start) {}

    double between(double min, double max) { return std::uniform_real_distribution<double>(min, max)(m_engine); }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_engine); }
    Eigen::Quaterniond rotation()
    {
        std::normal_distribution<double> normal;
        const double w = normal(m_engine), x = normal(m_engine), y = normal(m_engine), z = normal(m_engine);
        return Eigen::Quaterniond(w, x, y, z).normalized();
    }

private:
    std::mt19937 m_engine;
};

Loop profile(Random& random, double width, double depth)
{
    const double wall = random.between(0.4, 6), other = random.between(0.4, 6), step = random.between(0.3, 0.7) * width;
    switch (random.below(4)) {
    case 0: // L-shaped
        return {flat(0, 0), flat(width, 0), flat(width, wall), flat(other, wall), flat(other, depth), flat(0, depth)};
    case 1: // U-shaped
        return {flat(0, 0),
                flat(width, 0),
                flat(width, depth),
                flat(width - other, depth),
                flat(width - other, wall),
                flat(other, wall),
                flat(other, depth),
                flat(0, depth)};
    case 2: // stepped
        return {flat(0, 0),
                flat(width, 0),
                flat(width, wall),
                flat(step, wall),
                flat(step, wall + other),
                flat(step / 2, wall + other),
                flat(step / 2, depth),
                flat(0, depth)};
    default: // wedge-shaped
        return {flat(0, 0), flat(width, 0), flat(width, wall + other), flat(0, wall / 2)};
    }
}

std::vector<Hole> holesIn(Random& random, double width, double depth, double height)
{
    std::vector<Hole> holes;
    const int count = 1 + random.below(3);
    const double cell = width / count;
    for (int i = 0; i < count; ++i) {
        const double room = std::min(cell, depth) / 2, wall = random.between(0.05, 0.6) * room;
        const double x = (i + 0.5) * cell, y = depth / 2, floor = random.between(0.3, 0.7 * height);
        const bool isThrough = random.below(2) == 0;
        if (random.below(2) == 0)
            holes.push_back({circle(x, y, room - wall, 5 + random.below(30)), isThrough ? 0 : floor});
        else
            holes.push_back({rectangle(x - cell / 2 + wall, y - depth / 2 + wall, cell - 2 * wall, depth - 2 * wall),
                             isThrough ? 0 : floor});
    }
    return holes;
}

/// Returns a random part at any angle, perhaps tapered: an extruded profile, or a block with pockets and bores.
TriangleMesh randomPart(unsigned number)
{
    Random random(number);
    const double width = random.between(20, 80), depth = random.between(15, 60), height = random.between(2, 40);
    TriangleMesh part =
        random.below(2) == 0
            ? Plate(profile(random, width, depth), {}, height).take()
            : Plate(rectangle(0, 0, width, depth), holesIn(random, width, depth, height), height).take();
    if (random.below(3) == 0)
        part = tapered(part, width, random.between(0.2, 1));
    return turned(part, random.rotation());
}

/// Reference for wall_thickness.h. The thickness at p is the diameter of the smallest ball that touches p and reaches a
/// point q in sight. q is on a face more than 120 degrees away, or on an edge or corner with such a normal.
class Reference
{
public:
    explicit Reference(const TriangleMesh& mesh) : m_mesh(mesh)
    {
        std::map<std::pair<Slot, Slot>, std::pair<std::size_t, Slot>> sides;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            m_faces.push_back(core::cornersOf(mesh, static_cast<Slot>(f)));
            const auto& [a, b, c] = m_faces.back();
            m_normals.push_back((b - a).cross(c - a).normalized());
            for (std::size_t i = 0; i < 3; ++i)
                sides[{mesh.triangles[f][i], mesh.triangles[f][(i + 1) % 3]}] = {f, mesh.triangles[f][(i + 2) % 3]};
        }
        for (const auto& [side, one] : sides) {
            const auto other = sides.find({side.second, side.first});
            if (side.first > side.second || other == sides.end())
                continue;
            const Vec3 from = at(side.first), to = at(side.second);
            const Vec3 otherNormal = m_normals[other->second.first], normal = m_normals[one.first];
            const double bend = normal.dot(otherNormal);
            const bool isInward = normal.dot(at(other->second.second) - from) > 1e-9;
            if (isInward ? bend < 0.94 : bend < std::cos(100 * std::numbers::pi / 180))
                m_ridges.push_back({from,
                                    to,
                                    at(one.second) - from,
                                    at(other->second.second) - from,
                                    normal,
                                    otherNormal,
                                    {side.first, side.second},
                                    {one.first, other->second.first},
                                    isInward});
        }
        findCorners();
    }

    double thicknessAt(std::size_t face, const Vec3& p) const
    {
        const Vec3 inward = -m_normals[face];
        double least = infinity;
        for (std::size_t g = 0; g < m_faces.size(); ++g)
            // excludes walls of a hexagonal hole, which meet at 120 degrees
            if (m_normals[face].dot(m_normals[g]) < -0.5001)
                least = std::min(least, ofFace(face, p, inward, g, least));
        for (const Ridge& ridge : m_ridges) {
            const Vec3 edge = (ridge.to - ridge.from).normalized(), way = inward - inward.dot(edge) * edge;
            const double sign = ridge.isInward ? 1 : -1;
            if (way.norm() > 0.5 && sign * way.dot(ridge.one) >= 0 && sign * way.dot(ridge.other) >= 0)
                least = std::min(least, ofRidge(face, p, inward, ridge, least));
        }
        for (const Corner& corner : m_corners) {
            const Vec3 way = corner.p - p;
            if (isOpposite(corner, inward) && way.dot(inward) >= std::sqrt(0.75) * way.norm() && way.norm() > 0 &&
                ballOf(way, inward) < least && isInSight(face, p, corner.p))
                least = ballOf(way, inward);
        }
        return least;
    }

    /// Results of the dense sampling: smallest thickness in mm, area and share of the surface thinner than the limit,
    /// and share of the surface that may count either way because ridges are about as thin as their faces.
    struct Figures
    {
        double least = infinity, thin = 0, thinShare = 0, doubt = 0;
    };
    Figures figures(double limit, std::size_t samples) const
    {
        std::mt19937 engine(1);
        // random points, because narrow strips would align with a regular grid
        const auto anywhere = [&](const std::array<Vec3, 3>& t) {
            std::uniform_real_distribution<double> share(0, 1);
            const double a = std::sqrt(share(engine)), b = share(engine);
            return Vec3((1 - a) * t[0] + a * (1 - b) * t[1] + a * b * t[2]);
        };
        struct Sample
        {
            double thickness;
            std::size_t face;
            std::array<Vec3, 3> triangle;
        };
        double area = 0;
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            area += areaOf(m_faces[f]);
        Figures figures;
        std::vector<Sample> all;
        std::vector<double> ofFaces(m_faces.size(), infinity);
        for (const auto& [face, foot] : feet()) {
            const Vec3 step = 0.02 * (m_faces[face][1] - m_faces[face][0]).normalized(),
                       other = m_normals[face].cross(step);
            all.push_back({thicknessAt(face, foot), face, {foot - step, foot + step, foot + other}});
        }
        for (std::size_t f = 0; f < m_faces.size(); ++f) {
            const double share = areaOf(m_faces[f]) / area;
            const int n = std::max(3, static_cast<int>(std::ceil(std::sqrt(share * static_cast<double>(samples)))));
            for (const std::array<Vec3, 3>& triangle : split(m_faces[f], n)) {
                const double thickness = thicknessAt(f, anywhere(triangle));
                all.push_back({thickness, f, triangle});
                ofFaces[f] = std::min(ofFaces[f], thickness);
                figures.thin += thickness < limit ? areaOf(triangle) : 0;
            }
        }
        measureRidges(limit, ofFaces, figures);
        figures.thinShare = figures.thin / area;
        figures.doubt /= area;
        std::ranges::sort(all, {}, &Sample::thickness);
        all.resize(std::min<std::size_t>(all.size(), 6)); // refines the search around the six thinnest samples
        for (Sample& sample : all)
            for (int round = 0; round < 4; ++round) {
                Sample best = sample;
                best.thickness = infinity;
                for (const std::array<Vec3, 3>& triangle : split(widened(sample.triangle, sample.face), 6))
                    if (const double t = thicknessAt(sample.face, middle(triangle)); t < best.thickness)
                        best = {t, sample.face, triangle};
                if (best.thickness < infinity)
                    sample = best;
                figures.least = std::min(figures.least, sample.thickness);
            }
        return figures;
    }

private:
    /// An edge: its ends, the directions to the third corners of its faces, and the faces' normals and slots.
    struct Ridge
    {
        Vec3 from, to, one, other, normal, otherNormal;
        std::array<Slot, 2> ends;
        std::array<std::size_t, 2> faces;
        bool isInward;
    };
    /// A corner whose edges are all on one side of a plane through it.
    struct Corner
    {
        Vec3 p;
        Slot vertex;
        std::size_t face;
        std::vector<Vec3> star;
        bool isInward;
    };
    /// A sample for ridges: a point of an inward edge with the length of edge it represents, or an inward corner.
    struct RidgePoint
    {
        Vec3 p;
        const Ridge* ridge;
        const Corner* corner;
        double length;

        std::array<Slot, 2> ends() const { return ridge ? ridge->ends : std::array{corner->vertex, corner->vertex}; }
        bool touches(const RidgePoint& other) const
        {
            const std::array<Slot, 2> own = ends(), others = other.ends();
            return std::ranges::find_first_of(own, others) != own.end();
        }
    };

    void findCorners()
    {
        std::set<Slot> endsOfRidges;
        for (const Ridge& ridge : m_ridges)
            endsOfRidges.insert(ridge.ends.begin(), ridge.ends.end());
        std::map<Slot, std::pair<Vec3, Corner>> corners;
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i) {
                const Slot v = m_mesh.triangles[f][i];
                const auto found = corners.try_emplace(v, Vec3::Zero(), Corner{at(v), v, 0, {}, false}).first;
                const Vec3 a = (m_faces[f][(i + 1) % 3] - m_faces[f][i]).normalized(),
                           b = (m_faces[f][(i + 2) % 3] - m_faces[f][i]).normalized();
                found->second.first += std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * m_normals[f];
                found->second.second.face = f;
                found->second.second.star.push_back(a);
            }
        for (auto& [vertex, found] : corners) {
            auto& [normal, corner] = found;
            normal.normalize();
            double least = 1, most = -1;
            for (const Vec3& edge : corner.star) {
                least = std::min(least, normal.dot(edge));
                most = std::max(most, normal.dot(edge));
            }
            corner.isInward = least > 0.1;
            if (least > 0.1 || (most < -0.1 && endsOfRidges.contains(vertex)))
                m_corners.push_back(corner);
        }
    }

    static bool isOpposite(const Corner& corner, const Vec3& inward)
    {
        const double sign = corner.isInward ? 1 : -1;
        return std::ranges::all_of(corner.star, [&](const Vec3& edge) { return sign * inward.dot(edge) >= 0; });
    }

    /// Returns points of faces opposite corners and edges, where random samples may miss the smallest thickness. Each
    /// has the index of its face.
    std::vector<std::pair<std::size_t, Vec3>> feet() const
    {
        std::vector<Vec3> from;
        for (const Corner& corner : m_corners)
            from.push_back(corner.p);
        for (const Ridge& ridge : m_ridges)
            for (const double share : {0.01, 0.5, 0.99})
                from.push_back(ridge.from + share * (ridge.to - ridge.from));
        std::vector<std::pair<std::size_t, Vec3>> feet;
        for (const Vec3& p : from)
            for (std::size_t f = 0; f < m_faces.size(); ++f) {
                const Vec3 q = core::nearestInTriangle(p, m_faces[f]);
                if ((q - p).norm() > 1e-6 && (q - p).cross(m_normals[f]).norm() < 1e-4 * (q - p).norm())
                    feet.push_back({f, q});
            }
        return feet;
    }

    /// Returns the cosine between a chord and the closest inward normal at a point of a ridge.
    static double cosineOf(const RidgePoint& at, const Vec3& chord)
    {
        if (at.corner)
            return isOpposite(*at.corner, -chord) ? 1 : -1;
        const Vec3 edge = (at.ridge->to - at.ridge->from).normalized(), across = chord - chord.dot(edge) * edge;
        if (across.dot(at.ridge->one) <= 0 && across.dot(at.ridge->other) <= 0)
            return across.norm();
        return std::max(-chord.dot(at.ridge->normal), -chord.dot(at.ridge->otherNormal));
    }

    double between(const RidgePoint& a, const RidgePoint& b, double below) const
    {
        const double length = (b.p - a.p).norm();
        if (length >= below)
            return infinity;
        const Vec3 chord = (b.p - a.p) / length;
        const double own = cosineOf(a, chord), others = cosineOf(b, -chord), ball = length / std::max(own, others);
        if (std::min(own, others) < std::sqrt(0.75) || ball >= below)
            return infinity;
        const Vec3 p = a.p + 1e-3 * (b.p - a.p), q = b.p - 1e-3 * (b.p - a.p);
        return isInSight(m_faces.size(), p, q) ? ball : infinity;
    }

    /// Measures the distances between points of inward edges and corners, then refines the search around the best pair.
    void measureRidges(double limit, const std::vector<double>& ofFaces, Figures& figures) const
    {
        constexpr int steps = 32;
        std::vector<RidgePoint> points;
        for (const Ridge& ridge : m_ridges)
            for (int i = 0; i < steps && ridge.isInward; ++i)
                points.push_back({ridge.from + (i + 0.5) / steps * (ridge.to - ridge.from), &ridge, nullptr,
                                  (ridge.to - ridge.from).norm() / steps});
        for (const Corner& corner : m_corners)
            if (corner.isInward)
                points.push_back({corner.p, nullptr, &corner, 0});
        // adds the closest points of each pair of edges, which samples may miss
        for (std::size_t i = 0; i < m_ridges.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Ridge &one = m_ridges[i], &other = m_ridges[j];
                if (!one.isInward || !other.isInward)
                    continue;
                const core::NearestPair nearest = core::nearestOfSegments(one.from, one.to, other.from, other.to);
                points.push_back({nearest.a, &one, nullptr, 1e-9});
                points.push_back({nearest.b, &other, nullptr, 1e-9});
            }
        double least = infinity;
        std::pair<RidgePoint, RidgePoint> best;
        for (const RidgePoint& a : points) {
            double thickness = infinity;
            for (const RidgePoint& b : points)
                if (!a.touches(b))
                    if (const double ball = between(a, b, thickness); ball < thickness) {
                        thickness = ball;
                        if (ball < least) {
                            least = ball;
                            best = {a, b};
                        }
                    }
            const double faces =
                a.ridge ? std::min(ofFaces[a.ridge->faces[0]], ofFaces[a.ridge->faces[1]]) : ofFaces[a.corner->face];
            const double area = thickness * (a.length > 0 ? a.length : thickness);
            if (thickness < limit && thickness < 0.97 * faces)
                figures.thin += area;
            if (thickness < limit && thickness > 0.92 * faces && thickness < 1.02 * faces)
                figures.doubt += area;
        }
        if (least == infinity)
            return;
        for (int round = 0, per = steps; round < 4; ++round, per *= 8) {
            const auto [from, to] = best;
            for (const RidgePoint& one : around(from, per))
                for (const RidgePoint& other : around(to, per))
                    if (const double ball = between(one, other, least); ball < least) {
                        least = ball;
                        best = {one, other};
                    }
        }
        figures.least = std::min(figures.least, least);
    }

    static std::vector<RidgePoint> around(const RidgePoint& at, int per)
    {
        if (!at.ridge)
            return {at};
        const Vec3 way = at.ridge->to - at.ridge->from;
        const double middle = (at.p - at.ridge->from).dot(way) / way.squaredNorm();
        std::vector<RidgePoint> points;
        for (int i = -8; i <= 8; ++i) {
            points.push_back(at);
            points.back().p = at.ridge->from + std::clamp(middle + i / (8.0 * per), 0.0, 1.0) * way;
        }
        return points;
    }

    Vec3 at(Slot v) const { return m_mesh.points[v].cast<double>(); }
    static double areaOf(const std::array<Vec3, 3>& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }
    static Vec3 middle(const std::array<Vec3, 3>& t) { return (t[0] + t[1] + t[2]) / 3; }

    /// Returns the triangle scaled by 2 about its centre and clipped to its face.
    std::array<Vec3, 3> widened(std::array<Vec3, 3> triangle, std::size_t face) const
    {
        const Vec3 centre = middle(triangle);
        for (Vec3& p : triangle)
            p = core::nearestInTriangle(centre + 2 * (p - centre), m_faces[face]);
        return triangle;
    }

    static std::vector<std::array<Vec3, 3>> split(const std::array<Vec3, 3>& t, int n)
    {
        std::vector<std::array<Vec3, 3>> parts;
        const auto point = [&](int i, int j) { return Vec3(t[0] + (t[1] - t[0]) * i / n + (t[2] - t[0]) * j / n); };
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                parts.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
                if (i + j + 1 < n)
                    parts.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
            }
        return parts;
    }

    static double ballOf(const Vec3& way, const Vec3& inward) { return way.squaredNorm() / way.dot(inward); }

    bool isInSight(std::size_t face, const Vec3& p, const Vec3& q) const
    {
        for (std::size_t f = 0; f < m_faces.size(); ++f) {
            const auto& [a, c, b] = m_faces[f];
            const double hit = f == face ? -1 : core::hitTriangle({p, q - p}, {a, b, c});
            if (hit >= 0 && hit < 1 - 1e-4)
                return false;
        }
        return true;
    }

    /// Returns the point of the face that the smallest ball reaches within 30 degrees of the normal. Searches the
    /// face's sides and a grid.
    static Vec3 steepPoint(const Vec3& p, const Vec3& inward, const std::array<Vec3, 3>& face)
    {
        constexpr int steps = 300, rows = 20;
        double least = infinity;
        Vec3 best = p;
        const auto look = [&](const Vec3& q) {
            const Vec3 way = q - p;
            if (way.dot(inward) < std::sqrt(0.75) * way.norm() || ballOf(way, inward) >= least)
                return;
            least = ballOf(way, inward);
            best = q;
        };
        for (std::size_t i = 0; i < 3; ++i)
            for (int k = 0; k < steps; ++k)
                look(face[i] + (face[(i + 1) % 3] - face[i]) * k / steps);
        for (int i = 1; i < rows; ++i)
            for (int k = 1; i + k < rows; ++k)
                look(face[0] + (face[1] - face[0]) * i / rows + (face[2] - face[0]) * k / rows);
        return best;
    }

    /// Returns the diameter of the ball at p that reaches face g, found by bisection. Points more than 30 degrees from
    /// the normal do not count.
    double ofFace(std::size_t face, const Vec3& p, const Vec3& inward, std::size_t g, double below) const
    {
        const auto reaches = [&](double diameter) {
            const Vec3 centre = p + diameter / 2 * inward;
            return (core::nearestInTriangle(centre, m_faces[g]) - centre).norm() < diameter / 2;
        };
        double low = 0, high = std::min(below, 1000.0);
        if (!reaches(high))
            return infinity;
        for (int i = 0; i < 40; ++i)
            (reaches((low + high) / 2) ? high : low) = (low + high) / 2;
        Vec3 q = core::nearestInTriangle(p + high / 2 * inward, m_faces[g]);
        if ((q - p).dot(inward) < std::sqrt(0.75) * (q - p).norm()) {
            q = steepPoint(p, inward, m_faces[g]);
            high = q == p ? infinity : ballOf(q - p, inward);
            if (high >= below)
                return infinity;
        }
        return isInSight(face, p, q + 1e-3 * (middle(m_faces[g]) - q)) || isInSight(face, p, q) ? high : infinity;
    }

    /// Returns the diameter of the smallest ball at p that reaches a sample of the edge.
    double ofRidge(std::size_t face, const Vec3& p, const Vec3& inward, const Ridge& ridge, double below) const
    {
        constexpr int steps = 400;
        const Vec3 edge = ridge.to - ridge.from;
        const double along = std::clamp((p - ridge.from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        if ((ridge.from + along * edge - p).norm() >= below)
            return infinity;
        double least = infinity;
        Vec3 nearest;
        for (int i = 0; i <= steps; ++i) {
            const Vec3 q = ridge.from + (ridge.to - ridge.from) * i / steps, way = q - p;
            if (way.dot(inward) <= 0 || way.dot(inward) < std::sqrt(0.75) * way.norm())
                continue;
            if (const double ball = ballOf(way, inward); ball < std::min(least, below)) {
                least = ball;
                nearest = q;
            }
        }
        return least < infinity && isInSight(face, p, nearest) ? least : infinity;
    }

    const TriangleMesh& m_mesh;
    std::vector<std::array<Vec3, 3>> m_faces;
    std::vector<Vec3> m_normals;
    std::vector<Ridge> m_ridges;
    std::vector<Corner> m_corners;
};

double thinShare(const PrintReport& report)
{
    return report.thin.area / report.area;
}
} // namespace

class TestWallThickness : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wedge_isMeasuredAtItsThinEnd();
    void groove_isMeasuredAtItsGround_data();
    void groove_isMeasuredAtItsGround();
    void edgesOf60Degrees_areNoThinPlaces();
    void parts_agreeWithDenseSampling();
    void ridges_agreeWithDenseSampling_data();
    void ridges_agreeWithDenseSampling();
    void ridges_areMeasuredAtTheirGround_data();
    void ridges_areMeasuredAtTheirGround();
    void ridges_arePlacesOfTheirOwn();
    void rods_ofThreeSidesAreThin();
    void grooves_ofFineModelsAreSeen();
    void walls_ofAnySizeAreMeasured_data();
    void walls_ofAnySizeAreMeasured();
    void barsBetweenHoles_areThin();
    void parts_makeUpTheirFaces();
    void parts_areBounded();
    void places_ofOneFaceAreApart();
    void picture_showsThinEnds();
    void wallOfTheLimit_isNotThin_data();
    void wallOfTheLimit_isNotThin();
    void parts_doNotDependOnThreads();
    void normals_ofEdgesAreInTheirBoxes();
    void bounds_areBelowTheDistances();
};

void TestWallThickness::wedge_isMeasuredAtItsThinEnd()
{
    const PrintMeasures measures = core::measureForPrint(wedge(0.2, 10));
    const PrintReport report = core::checkForPrint(measures, {.minWall = 0.8, .bed = {}});
    QVERIFY(report.thinnest && std::abs(*report.thinnest / 0.2 - 1) < 0.05);
    // The wedge is thinner than 0.8 mm up to 6.1 mm from its thin end, on each of its two sides.
    const double expected = 2 * 40 * 100 * 0.6 / 9.8 / report.area;
    QVERIFY2(std::abs(thinShare(report) / expected - 1) < 0.1, qPrintable(QString::number(thinShare(report))));
    // two sides, or one place if they are joined at the blunt end
    QVERIFY(report.thin.count == 2u || report.thin.count == 1u);
    for (const core::PrintPlace& place : report.thin.places) {
        QVERIFY(std::abs(place.worst / 0.2 - 1) < 0.05);
        QVERIFY(place.point.x() < 1);
    }
}

void TestWallThickness::groove_isMeasuredAtItsGround_data()
{
    QTest::addColumn<double>("halfWidth");
    QTest::addRow("steep") << 5.0;
    QTest::addRow("right angle") << 19.5;
    QTest::addRow("slot-like") << 0.3;
}

void TestWallThickness::groove_isMeasuredAtItsGround()
{
    QFETCH(const double, halfWidth);
    const TriangleMesh block = grooved(0.5, halfWidth);
    const PrintReport report = core::checkForPrint(core::measureForPrint(block), {.minWall = 0.8, .bed = {}});
    QVERIFY(report.thinnest && std::abs(*report.thinnest / 0.5 - 1) < 0.05);
    // The groove's sides are too steep to be opposite faces. Balls within 30 degrees of the normal touch its bottom
    // edge.
    if (halfWidth > 10)
        return;
    const double aside = 0.5 * std::tan(std::numbers::pi / 6);
    const double expected = 2 * 30 * aside;
    QVERIFY2(std::abs(report.thin.area / expected - 1) < 0.1,
             qPrintable(QStringLiteral("%1 mm2, not %2").arg(report.thin.area).arg(expected)));
    QVERIFY(std::abs(report.thin.places[0].point.x() - 20) < 0.5);
}

/// A bar with an equilateral cross-section has edges of exactly 60 degrees, the limit of sharp edges. Rotations must
/// not make it thin.
void TestWallThickness::edgesOf60Degrees_areNoThinPlaces()
{
    TriangleMesh bar = Plate({flat(0, 0), flat(30, 0), flat(15, 1)}, {}, 20).take();
    for (Vec3f& p : bar.points)
        if (p.y() > 0)
            p.y() = static_cast<float>(30 * std::sin(std::numbers::pi / 3));
    Random random(1);
    for (int turn = 0; turn < 12; ++turn) {
        const PrintMeasures measures = core::measureForPrint(turned(bar, random.rotation()));
        const PrintReport report = core::checkForPrint(measures, {.minWall = 0.8, .bed = {}});
        QVERIFY2(report.thinnest && *report.thinnest > 10, qPrintable(QString::number(turn)));
        QCOMPARE(report.thin.count, std::size_t(0));
    }
}

void TestWallThickness::parts_agreeWithDenseSampling()
{
    const auto first = static_cast<unsigned>(std::max(1, qEnvironmentVariableIntValue("FETTLE_SEED")));
    const auto count = static_cast<unsigned>(byEffort(20, 400, 4000));
    for (unsigned number = first; number < first + count; ++number) {
        const TriangleMesh part = randomPart(number);
        const PrintMeasures measures = core::measureForPrint(part);
        QVERIFY2(measures.walls, qPrintable(QStringLiteral("seed %1 makes no solid").arg(number)));
        const double least = core::checkForPrint(measures, {.bed = {}}).thinnest.value_or(infinity);
        const double limit = std::min(PrintLimits::maxWall, (1.1 + 0.1 * (number % 20)) * std::max(least, 0.2));
        const PrintReport report = core::checkForPrint(measures, {.minWall = limit, .bed = {}});
        const Reference::Figures reference = Reference(part).figures(limit * (1 - 1e-3), 4000);
        const QString figures = QStringLiteral("seed %1: %2 mm, reference %3; thinner than %4: %5, reference %6")
                                    .arg(number)
                                    .arg(least)
                                    .arg(reference.least)
                                    .arg(limit)
                                    .arg(thinShare(report))
                                    .arg(reference.thinShare);
        if (qEnvironmentVariableIsSet("FETTLE_TRACE"))
            qInfo().noquote() << figures;
        // both measured close to a sharp edge, where the result depends on the distance to the edge
        const bool isKnife = least < 0.1 && reference.least < 0.1;
        QVERIFY2(isKnife || std::abs(least / reference.least - 1) < 0.05, qPrintable(figures));
        QVERIFY2(std::abs(thinShare(report) - reference.thinShare) < 0.015 + 0.05 * reference.thinShare,
                 qPrintable(figures));
    }
}

void TestWallThickness::ridges_agreeWithDenseSampling_data()
{
    QTest::addColumn<int>("kind");
    for (const auto& [name, kind] : {std::pair("scored", 0),
                                     {"crossing grooves", 1},
                                     {"tip above a floor", 2},
                                     {"two tips", 3},
                                     {"spike", 4},
                                     {"tip above a facet", 5},
                                     {"groove around", 6}})
        QTest::addRow("%s", name) << kind;
}

/// Compares random solids with thin walls between ridges, in random orientations, with the reference.
void TestWallThickness::ridges_agreeWithDenseSampling()
{
    QFETCH(const int, kind);
    const int count = byEffort(4, 60, 600);
    for (int number = 1; number <= count; ++number) {
        Random random(static_cast<unsigned>(100 * kind + number));
        const auto inThousandths = [&](double min, double max) {
            return std::round(1e3 * random.between(min, max)) / 1e3;
        };
        const double left = 2 * inThousandths(0.15, 1), height = left + 2 * inThousandths(0.5, 4);
        const double halfWidth = inThousandths(0.1, 8), radius = inThousandths(0.5, 6), length = inThousandths(3, 10);
        const int sides = 3 + random.below(number % 2 == 0 ? 5 : 40);
        TriangleMesh mesh;
        switch (kind) {
        case 0:
        case 1:
            mesh = scored(height, left, halfWidth, kind == 1);
            break;
        case 2:
            mesh = hollowed(spike(sides, radius, length), left, false);
            break;
        case 3:
            mesh = hollowed(spike(sides, radius, length), left, true, random.between(0, 0.4) * left);
            break;
        case 4:
            mesh = spike(sides, radius, length);
            break;
        case 6:
            // three pieces would have edges of 60 degrees, the limit of sharp edges
            mesh = ringGrooved(std::max(4, sides), left, std::min(halfWidth, 4.0));
            break;
        default:
            mesh = hollowed(turned(spike(sides, radius, length),
                                   Eigen::Quaterniond(Eigen::AngleAxisd(random.between(-0.3, 0.3), Vec3::UnitX()))),
                            left, false);
        }
        mesh = turned(std::move(mesh), random.rotation());
        const PrintMeasures measures = core::measureForPrint(mesh);
        QVERIFY(measures.walls);
        const double limit = std::min(PrintLimits::maxWall, random.between(1.05, 2) * left);
        const PrintReport report = core::checkForPrint(measures, {.minWall = limit, .bed = {}});
        const double least = report.thinnest.value_or(infinity);
        const Reference::Figures reference = Reference(mesh).figures(limit * (1 - 1e-3), 4000);
        const QString figures = QStringLiteral("%1: %2 mm, reference %3; thinner than %4: %5, reference %6")
                                    .arg(number)
                                    .arg(least)
                                    .arg(reference.least)
                                    .arg(limit)
                                    .arg(thinShare(report))
                                    .arg(reference.thinShare);
        if (qEnvironmentVariableIsSet("FETTLE_TRACE"))
            qInfo().noquote() << figures;
        const bool isKnife = least < 0.1 && reference.least < 0.1;
        const bool isThick = least > PrintLimits::maxWall && reference.least > PrintLimits::maxWall;
        QVERIFY2(isKnife || isThick || std::abs(least / reference.least - 1) < 0.05, qPrintable(figures));
        QVERIFY2(std::abs(thinShare(report) - reference.thinShare) <
                     0.015 + 0.05 * reference.thinShare + reference.doubt,
                 qPrintable(figures));
    }
}

void TestWallThickness::ridges_areMeasuredAtTheirGround_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<double>("left");
    for (const double degrees : {30.0, 60.0, 90.0, 120.0}) {
        const double halfWidth = 1.2 * std::tan(degrees * std::numbers::pi / 360);
        QTest::addRow("scored by %g degrees", degrees) << scored(3, 0.6, halfWidth, false) << 0.6;
        QTest::addRow("crossing grooves of %g degrees", degrees) << scored(3, 0.6, halfWidth, true) << 0.6;
    }
    for (const double radius : {0.5, 2.0, 5.0}) {
        QTest::addRow("tip, %g wide", radius) << hollowed(spike(4, radius, 10), 0.5, false) << 0.5;
        QTest::addRow("two tips, %g wide", radius) << hollowed(spike(4, radius, 10), 0.4, true) << 0.4;
    }
    const std::vector few{6, 33}, many{6, 17, 20, 33, 64, 128};
    for (const int sides : byEffort(few, many)) { // more sides mean flatter edges of the tip
        QTest::addRow("tip of %d sides", sides) << hollowed(spike(sides, 3, 10), 0.5, false) << 0.5;
        QTest::addRow("two tips of %d sides", sides) << hollowed(spike(sides, 3, 10), 0.4, true) << 0.4;
    }
    // neighbouring sides of the groove are opposite each other across its concave edges
    for (const int pieces : byEffort(std::vector{5, 32}, std::vector{5, 6, 8, 10, 13, 16, 20, 24, 32}))
        QTest::addRow("groove around, of %d pieces", pieces) << ringGrooved(pieces, 0.5, 2) << 0.5;
    // The model has a slot on each side of a block. Their edges are 0.3 mm apart in x and in y.
    QTest::addRow("edges of two slots") << Plate({flat(0, 0), flat(19, 0), flat(19, 4), flat(19.4, 4), flat(19.4, 0),
                                                  flat(40, 0), flat(40, 8), flat(20.2, 8), flat(20.2, 4.3),
                                                  flat(19.7, 4.3), flat(19.7, 8), flat(0, 8)},
                                                 {}, 20)
                                               .take()
                                        << std::hypot(0.3, 0.3);
}

void TestWallThickness::ridges_areMeasuredAtTheirGround()
{
    QFETCH(const TriangleMesh, mesh);
    QFETCH(const double, left);
    Random random(1);
    const int turns = byEffort(2, 4);
    for (int turn = 0; turn < turns; ++turn) {
        const PrintMeasures measures = core::measureForPrint(turn == 0 ? mesh : turned(mesh, random.rotation()));
        const PrintReport report = core::checkForPrint(measures, {.minWall = 0.8, .bed = {}});
        QVERIFY2(report.thinnest && std::abs(*report.thinnest / left - 1) < 0.02,
                 qPrintable(QString::number(report.thinnest.value_or(-1))));
        QVERIFY(report.thin.count > 0 && report.thin.area > 0);
        QVERIFY(std::ranges::any_of(report.thin.places, [&](const core::PrintPlace& place) {
            return std::abs(place.worst / left - 1) < 0.02;
        }));
    }
}

/// Checks that the picture shows the bottoms of both grooves along their whole length, and that they count as strips.
void TestWallThickness::ridges_arePlacesOfTheirOwn()
{
    const TriangleMesh plate = scored(3, 0.6, 0.3, false);
    const PrintMeasures measures = core::measureForPrint(plate);
    const PrintReport report = core::checkForPrint(measures, {.minWall = 0.8, .bed = {}});
    QCOMPARE(report.thin.count, std::size_t(2));
    for (const core::PrintPlace& place : report.thin.places) {
        QVERIFY(std::abs(place.point.x() - 20) < 1e-3 && std::abs(std::abs(place.point.y() - 1.5) - 0.3) < 1e-3);
        QVERIFY(std::abs(place.area / (40 * 0.6) - 1) < 0.01);
    }
    const std::vector<float> picture = core::pictureOf(measures, core::PrintPicture::Thickness);
    for (std::size_t v = 0; v < plate.points.size(); ++v)
        QVERIFY((std::abs(plate.points[v].y() - 1.5F) < 0.4F) == (picture[v] < 0.7F));
    QVERIFY(core::checkForPrint(measures, {.minWall = 0.5, .bed = {}}).thin.count == 0);
    // The wall between two neighbouring slots is thin everywhere, so their edges add no ridges.
    const TriangleMesh comb =
        Plate({flat(0, 0), flat(30, 0), flat(30, 10), flat(20, 10), flat(20, 2), flat(15.3, 2), flat(15.3, 10),
               flat(14.7, 10), flat(14.7, 2), flat(10, 2), flat(10, 10), flat(0, 10)},
              {}, 10)
            .take();
    QVERIFY(core::wallThickness(comb, PrintLimits::largestBall).ridges.empty());
}

/// Faces of a three-sided rod or spike are not opposite each other, but they are opposite its edges.
void TestWallThickness::rods_ofThreeSidesAreThin()
{
    Random random(2);
    // the angles differ from 60 degrees by less than a thousandth
    const TriangleMesh rod = Plate({flat(0, 0), flat(0.5, 0), flat(0.25, 0.433)}, {}, 20).take();
    for (int turn = 0; turn < 4; ++turn) {
        const PrintReport report =
            core::checkForPrint(core::measureForPrint(turned(rod, random.rotation())), {.minWall = 0.8, .bed = {}});
        QVERIFY(report.thinnest && *report.thinnest < 0.45);
        QVERIFY2(thinShare(report) > 0.3, qPrintable(QString::number(thinShare(report))));
    }
    for (const int sides : {3, 4, 6}) {
        const PrintReport report = core::checkForPrint(
            core::measureForPrint(turned(spike(sides, 1, 20), random.rotation())), {.minWall = 0.8, .bed = {}});
        QVERIFY2(report.thinnest && *report.thinnest < 0.15, qPrintable(QString::number(sides)));
        QVERIFY(report.thin.count > 0);
    }
}

/// Tests a block of more than 100,000 small faces whose groove is too steep to have opposite faces.
void TestWallThickness::grooves_ofFineModelsAreSeen()
{
    const TriangleMesh block = inManyFaces(grooved(0.4, 1));
    const PrintReport report = core::checkForPrint(core::measureForPrint(block), {.minWall = 0.8, .bed = {}});
    QVERIFY2(report.thinnest && std::abs(*report.thinnest / 0.4 - 1) < 0.02,
             qPrintable(QString::number(report.thinnest.value_or(-1))));
    QVERIFY(report.thin.count > 0);
}

void TestWallThickness::walls_ofAnySizeAreMeasured_data()
{
    QTest::addColumn<TriangleMesh>("mesh");
    QTest::addColumn<double>("thickness");
    // The faces are small compared with the block, but larger than the wall between groove and floor.
    TriangleMesh groove = grooved(0.5, 1), narrow = grooved(0.5, 0.3), tip = hollowed(spike(4, 0.5, 10), 0.5, false);
    for (int i = 0; i < 5; ++i) {
        QTest::addRow("groove, %d times in quarters", i) << groove << 0.5;
        QTest::addRow("tip, %d times in quarters", i) << tip << 0.5;
        groove = inQuarters(groove);
        narrow = inQuarters(narrow);
        tip = inQuarters(tip);
    }
    // The faces are less than 1 mm wide, and no face's centre has the bottom of the cut within 30 degrees of its
    // normal.
    QTest::addRow("narrow groove over small faces") << shapes::scaled(narrow, 0.5F) << 0.25;
    QTest::addRow("tip over small faces") << shapes::scaled(tip, 0.5F) << 0.25;
    QTest::addRow("groove of many faces") << inManyFaces(shapes::scaled(grooved(0.1, 0.3), 6)) << 0.6;
    QTest::addRow("narrow groove of many faces") << inManyFaces(grooved(0.5, 0.3)) << 0.5;
    QTest::addRow("tiny groove") << shapes::scaled(grooved(0.3, 0.3), 0.01F) << 0.003;
    QTest::addRow("scored, large") << shapes::scaled(scored(3, 0.6, 0.5, false), 30) << 18.0;
    QTest::addRow("crossing grooves, large") << shapes::scaled(scored(3, 0.6, 0.5, true), 30) << 18.0;
}

void TestWallThickness::walls_ofAnySizeAreMeasured()
{
    QFETCH(const TriangleMesh, mesh);
    QFETCH(const double, thickness);
    const PrintReport report = core::checkForPrint(core::measureForPrint(mesh), {.bed = {}});
    QVERIFY2(report.thinnest && std::abs(*report.thinnest / thickness - 1) < 0.02,
             qPrintable(QString::number(report.thinnest.value_or(-1))));
}

/// Tests a plate with many holes, in which most faces are hidden from each other by the bars between holes.
void TestWallThickness::barsBetweenHoles_areThin()
{
    constexpr int count = 8;
    constexpr double hole = 3, bar = 0.6, height = 4, side = count * (hole + bar) + bar;
    std::vector<Hole> holes;
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < count; ++k)
            holes.push_back({rectangle(bar + i * (hole + bar), bar + k * (hole + bar), hole, hole)});
    const TriangleMesh plate = Plate(rectangle(0, 0, side, side), holes, height).take();
    const double inHoles = count * count * 4 * hole * height, outside = 4 * count * hole * height;
    Random random(3);
    for (int turn = 0; turn < 3; ++turn) {
        const PrintReport report =
            core::checkForPrint(core::measureForPrint(turned(plate, random.rotation())), {.minWall = 0.8, .bed = {}});
        QVERIFY(report.thinnest && std::abs(*report.thinnest / bar - 1) < 0.01);
        QVERIFY2(std::abs(report.thin.area / (inHoles + outside) - 1) < 0.03,
                 qPrintable(QStringLiteral("%1 mm2, not %2").arg(report.thin.area).arg(inHoles + outside)));
    }
}

void TestWallThickness::parts_makeUpTheirFaces()
{
    const TriangleMesh block = grooved(0.5, 5);
    const core::WallThickness walls = core::wallThickness(block, PrintLimits::largestBall);
    QVERIFY(!walls.parts.empty());
    std::map<Slot, double> shares, areas;
    for (const core::WallPart& part : walls.parts) {
        const auto corner = [&](std::size_t i) { return Vec3(part.corners[i].cast<double>()); };
        shares[part.face] += double(part.share);
        areas[part.face] += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
        QVERIFY(part.least <= part.most);
        const auto corners = core::cornersOf(block, part.face);
        const Vec3 thinnest = part.thinnest.cast<double>();
        QVERIFY((core::nearestInTriangle(thinnest, corners) - thinnest).norm() < 1e-4);
    }
    for (const auto& [face, share] : shares) {
        const auto [a, b, c] = core::cornersOf(block, face);
        QVERIFY(std::abs(share - 1) < 1e-6);
        QVERIFY(std::abs(areas[face] / ((b - a).cross(c - a).norm() / 2) - 1) < 1e-4);
    }
    QVERIFY(std::ranges::is_sorted(walls.parts, {}, &core::WallPart::face));
}

/// Checks that few triangles are not divided into millions of parts: metres of sheet metal, and knife edges.
void TestWallThickness::parts_areBounded()
{
    for (const TriangleMesh& mesh : {wedge(0.2, 10, 3000, 2000), wedge(0.01, 3000, 3000, 3000), grooved(0.001, 0.01),
                                     Plate({flat(0, 0), flat(2000, 0), flat(2000, 1000)}, {}, 0.4).take(),
                                     Plate({flat(0, 0), flat(2000, 0), flat(2000, 100)}, {}, 1500).take()}) {
        const PrintMeasures measures = core::measureForPrint(mesh);
        QVERIFY(measures.walls);
        QVERIFY2(measures.walls->parts.size() < 60000, qPrintable(QString::number(measures.walls->parts.size())));
    }
}

/// Checks that two grooves above the same two triangles of the base are reported as two places.
void TestWallThickness::places_ofOneFaceAreApart()
{
    const TriangleMesh block = Plate({flat(0, 0), flat(60, 0), flat(60, 20), flat(47, 20), flat(45, 0.6), flat(43, 20),
                                      flat(17, 20), flat(15, 0.5), flat(13, 20), flat(0, 20)},
                                     {}, 30)
                                   .take();
    const PrintReport report = core::checkForPrint(core::measureForPrint(block), {.minWall = 0.8, .bed = {}});
    std::vector<double> worst;
    for (const core::PrintPlace& place : report.thin.places)
        if (place.normal.y() < -0.9)
            worst.push_back(place.worst);
    std::ranges::sort(worst);
    QCOMPARE(worst.size(), std::size_t(2));
    QVERIFY(std::abs(worst[0] / 0.5 - 1) < 0.05 && std::abs(worst[1] / 0.6 - 1) < 0.05);
}

void TestWallThickness::picture_showsThinEnds()
{
    const TriangleMesh mesh = wedge(0.2, 10);
    const std::vector<float> picture = core::pictureOf(core::measureForPrint(mesh), core::PrintPicture::Thickness);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        QVERIFY(mesh.points[v].x() < 1 ? picture[v] < 0.3F : picture[v] > 2);
    // The picture shows a thin place without a vertex nearby at the nearest vertices.
    const TriangleMesh block = grooved(0.5, 5);
    const std::vector<float> ofBlock = core::pictureOf(core::measureForPrint(block), core::PrintPicture::Thickness);
    QVERIFY(std::ranges::count_if(ofBlock, [](float t) { return t < 0.8F; }) >= 2);
}

void TestWallThickness::wallOfTheLimit_isNotThin_data()
{
    QTest::addColumn<float>("thickness");
    QTest::addColumn<float>("distance"); ///< distance of the model from the origin, mm
    QTest::addColumn<bool>("isThin");
    QTest::addRow("a float below") << 0.7999992F << 0.0F << false;
    QTest::addRow("far away") << 0.8F << 1000.0F << false;
    QTest::addRow("a hundredth below") << 0.79F << 0.0F << true;
    QTest::addRow("a hundredth below, far away") << 0.79F << 1000.0F << true;
    QTest::addRow("above") << 0.81F << 0.0F << false;
}

void TestWallThickness::wallOfTheLimit_isNotThin()
{
    QFETCH(const float, thickness);
    QFETCH(const float, distance);
    QFETCH(const bool, isThin);
    const TriangleMesh slab =
        turned(shapes::moved(clay::slab(20, static_cast<double>(thickness), 2), Vec3f::Constant(distance)),
               Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized())));
    const PrintReport report = core::checkForPrint(core::measureForPrint(slab), {.minWall = 0.8, .bed = {}});
    QCOMPARE(report.thin.count > 0, isThin);
}

void TestWallThickness::parts_doNotDependOnThreads()
{
    const TriangleMesh part = randomPart(7);
    core::WorkerPool::shared().setThreads(1);
    const core::WallThickness alone = core::wallThickness(part, PrintLimits::largestBall);
    core::WorkerPool::shared().setThreads(5);
    const core::WallThickness together = core::wallThickness(part, PrintLimits::largestBall);
    core::WorkerPool::shared().setThreads(0);
    QVERIFY(alone.ridges.size() == together.ridges.size() &&
            std::ranges::equal(alone.ridges, together.ridges, {}, &core::WallRidge::least, &core::WallRidge::least));
    QCOMPARE(alone.parts.size(), together.parts.size());
    for (std::size_t i = 0; i < alone.parts.size(); ++i)
        QVERIFY(alone.parts[i].least == together.parts[i].least && alone.parts[i].corners == together.parts[i].corners);
}

/// Checks that each direction opposite an edge or a corner is also opposite the box of its face's normals.
void TestWallThickness::normals_ofEdgesAreInTheirBoxes()
{
    Random random(4);
    int opposite = 0;
    for (const TriangleMesh& mesh :
         {scored(3, 0.6, 0.1, true), spike(3, 1, 8), wedge(0.001, 10), hollowed(spike(5, 2, 6), 0.5, true),
          turned(ringGrooved(9, 0.5, 2), random.rotation()), randomPart(3), randomPart(8)}) {
        const core::WallEdges edges(mesh);
        for (Slot face = 0; face < mesh.triangles.size(); ++face) {
            const core::FaceBox box = edges.normalsAt(face, mesh.triangles[face]);
            QCOMPARE((box.min <= box.max).all(), edges.isAt(face));
            for (int i = 0; i < 500 && edges.isAt(face); ++i) {
                const Vec3 direction = random.rotation() * Vec3::UnitX();
                bool isOpposite = false;
                for (std::size_t k = 0; k < 3; ++k)
                    isOpposite = isOpposite || edges.isOppositeSide(face, k, direction) ||
                                 edges.isOppositeCorner(mesh.triangles[face][k], direction);
                const Eigen::Array3d min = box.min.cast<double>() * direction.array();
                const double least = min.min(box.max.cast<double>() * direction.array()).sum();
                QVERIFY(!isOpposite || least < core::maxOppositeCosine + 1e-6);
                opposite += isOpposite ? 1 : 0;
            }
        }
    }
    QVERIFY2(opposite > 1000, qPrintable(QString::number(opposite)));
}

/// Checks the quick bounds of the distance from a face to a point and to a triangle.
void TestWallThickness::bounds_areBelowTheDistances()
{
    Random random(5);
    const core::WallSurface surface(turned(spike(40, 3, 10), random.rotation()));
    const auto point = [&] { return Vec3(random.between(-12, 12), random.between(-12, 12), random.between(-12, 12)); };
    int beyond = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto position = static_cast<Slot>(random.below(static_cast<int>(surface.size())));
        const Vec3 p = point(), q = point();
        const std::array<Vec3, 3> triangle = {p, p + 0.2 * (q - p), p + 0.2 * point()};
        const double ofPoint = (core::nearestInTriangle(p, surface.cornersOf(position)) - p).squaredNorm();
        QVERIFY(surface.reach(position, std::array{p}) <= ofPoint);
        const core::NearestPair pair = core::nearestOfTriangles(triangle, surface.cornersOf(position));
        QVERIFY(surface.reach(position, triangle) <= pair.squaredDistance);
        beyond += surface.reach(position, triangle) > pair.squaredDistance / 4 ? 1 : 0;
    }
    QVERIFY2(beyond > 1000, qPrintable(QString::number(beyond)));
}

FETTLE_TEST(TestWallThickness)

#include "tst_wall_thickness.moc"
