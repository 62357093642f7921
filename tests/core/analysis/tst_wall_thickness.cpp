// Walls of solids with large triangles, against a reference that samples the surface densely and asks every face.

#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/analysis/print_check.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/point_triangle.h"
#include "core/geometry/polygon_triangulation.h"
#include "core/util/worker_pool.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

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
constexpr int perMillimetre = 1000; ///< of flat points

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

/// A hole in a plate, from its upper side down to that height; 0: through.
struct Hole
{
    Loop loop;
    double floor = 0;
};

/// A plate with holes, along z. Its triangles are as large as they can be.
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
            return; // the mesh is not closed then, which the test sees
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

/// The height, z, changes evenly along x, from itself to `factor` times as much at `length`.
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

/// A block of 40 x 30 x 20 with a groove of an angle across it that leaves so much.
TriangleMesh grooved(double left, double halfWidth)
{
    return Plate({flat(0, 0), flat(40, 0), flat(40, 20), flat(20 + halfWidth, 20), flat(20, left),
                  flat(20 - halfWidth, 20), flat(0, 20)},
                 {}, 30)
        .take();
}

/// A wedge of 100 x 40, so thick at its ends; its triangles go from end to end.
TriangleMesh wedge(double from, double to, double length = 100, double width = 40)
{
    return Plate({flat(0, 0), flat(length, 0), flat(length, to), flat(0, from)}, {}, width).take();
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
    case 0: // L
        return {flat(0, 0), flat(width, 0), flat(width, wall), flat(other, wall), flat(other, depth), flat(0, depth)};
    case 1: // U
        return {flat(0, 0),
                flat(width, 0),
                flat(width, depth),
                flat(width - other, depth),
                flat(width - other, wall),
                flat(other, wall),
                flat(other, depth),
                flat(0, depth)};
    case 2: // steps
        return {flat(0, 0),
                flat(width, 0),
                flat(width, wall),
                flat(step, wall),
                flat(step, wall + other),
                flat(step / 2, wall + other),
                flat(step / 2, depth),
                flat(0, depth)};
    default: // wedge
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

/// A profile, or a block with pockets and bores, perhaps a wedge, at any angle.
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

/// Takes, as wall_thickness.h says it, of all points q in sight, on faces that look more than 120 degrees away, or on
/// edges that jut into the matter and lie there, the least ball that touches p and q.
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
            if (normal.dot(at(other->second.second) - from) > 1e-9 && normal.dot(otherNormal) < 0.94)
                m_ridges.push_back({from, to, at(one.second) - from, at(other->second.second) - from});
        }
    }

    double thicknessAt(std::size_t face, const Vec3& p) const
    {
        const Vec3 inward = -m_normals[face];
        double least = infinity;
        for (std::size_t g = 0; g < m_faces.size(); ++g)
            if (m_normals[face].dot(m_normals[g]) < -0.5)
                least = std::min(least, ofFace(face, p, inward, g, least));
        for (const Ridge& ridge : m_ridges) {
            const Vec3 edge = (ridge.to - ridge.from).normalized(), way = inward - inward.dot(edge) * edge;
            if (way.norm() > 0.5 && way.dot(ridge.one) >= 0 && way.dot(ridge.other) >= 0)
                least = std::min(least, ofRidge(face, p, inward, ridge, least));
        }
        return least;
    }

    /// The least found, and the share of the surface that is thinner than the limit.
    struct Figures
    {
        double least = infinity, thin = 0, thinShare = 0;
    };
    Figures figures(double limit, std::size_t samples) const
    {
        std::mt19937 engine(1);
        const auto anywhere = [&](const std::array<Vec3, 3>& t) { // on a grid strips would count wholly or not at all
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
        for (std::size_t f = 0; f < m_faces.size(); ++f) {
            const double share = areaOf(m_faces[f]) / area;
            const int n = std::max(3, static_cast<int>(std::ceil(std::sqrt(share * static_cast<double>(samples)))));
            for (const std::array<Vec3, 3>& triangle : split(m_faces[f], n)) {
                const double thickness = thicknessAt(f, anywhere(triangle));
                all.push_back({thickness, f, triangle});
                figures.thin += thickness < limit ? areaOf(triangle) : 0;
            }
        }
        figures.thinShare = figures.thin / area;
        std::ranges::sort(all, {}, &Sample::thickness);
        all.resize(std::min<std::size_t>(all.size(), 6)); // about these it is looked for more closely
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
    struct Ridge
    {
        Vec3 from, to, one, other;
    };

    Vec3 at(Slot v) const { return m_mesh.points[v].cast<double>(); }
    static double areaOf(const std::array<Vec3, 3>& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }
    static Vec3 middle(const std::array<Vec3, 3>& t) { return (t[0] + t[1] + t[2]) / 3; }

    /// Twice as large, as far as it stays on its face.
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

    /// Bisects: the ball of a diameter reaches into the face, or it does not.
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
        const Vec3 q = core::nearestInTriangle(p + high / 2 * inward, m_faces[g]);
        return isInSight(face, p, q + 1e-3 * (middle(m_faces[g]) - q)) || isInSight(face, p, q) ? high : infinity;
    }

    /// Samples the edge.
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
    void parts_makeUpTheirFaces();
    void parts_areBounded();
    void places_ofOneFaceAreApart();
    void picture_showsThinEnds();
    void wallOfTheLimit_isNotThin_data();
    void wallOfTheLimit_isNotThin();
    void parts_doNotDependOnThreads();
};

void TestWallThickness::wedge_isMeasuredAtItsThinEnd()
{
    const PrintMeasures measures = core::measureForPrint(wedge(0.2, 10));
    const PrintReport report = core::checkForPrint(measures, {.minWall = 0.8, .bed = {}});
    QVERIFY(report.minByBalls && std::abs(*report.minByBalls / 0.2 - 1) < 0.05);
    QVERIFY(report.minByRays && std::abs(*report.minByRays / 0.2 - 1) < 0.1);
    // The wedge is 0.8 mm thick 6.1 mm from its thin end, on both of its sides.
    const double expected = 2 * 40 * 100 * 0.6 / 9.8 / report.area;
    QVERIFY2(std::abs(thinShare(report) / expected - 1) < 0.1, qPrintable(QString::number(thinShare(report))));
    QVERIFY(report.thin.count == 2u || report.thin.count == 1u); // its two sides, or joined at the blunt end
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
    QVERIFY(report.minByBalls && std::abs(*report.minByBalls / 0.5 - 1) < 0.05);
    // The sides are too steep to be opposite: balls touch the edge, from within 30 degrees.
    if (halfWidth > 10)
        return;
    const double aside = 0.5 * std::tan(std::numbers::pi / 6);
    const double expected = 2 * 30 * aside;
    QVERIFY2(std::abs(report.thin.area / expected - 1) < 0.1,
             qPrintable(QStringLiteral("%1 mm2, not %2").arg(report.thin.area).arg(expected)));
    QVERIFY(std::abs(report.thin.places[0].point.x() - 20) < 0.5);
}

/// Edges of 60 degrees, of a bar of an equilateral section, stay on the same side of the rule however they are turned.
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
        QVERIFY2(report.minByBalls && *report.minByBalls > 10, qPrintable(QString::number(turn)));
        QCOMPARE(report.thin.count, std::size_t(0));
    }
}

void TestWallThickness::parts_agreeWithDenseSampling()
{
    const auto first = static_cast<unsigned>(std::max(1, qEnvironmentVariableIntValue("FETTLE_SEED")));
    const auto count = static_cast<unsigned>(byEffort(40, 400, 4000));
    for (unsigned number = first; number < first + count; ++number) {
        const TriangleMesh part = randomPart(number);
        const PrintMeasures measures = core::measureForPrint(part);
        QVERIFY2(measures.walls, qPrintable(QStringLiteral("seed %1 makes no solid").arg(number)));
        const double least = core::checkForPrint(measures, {.bed = {}}).minByBalls.value_or(infinity);
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
        const bool isKnife = least < 0.1 && reference.least < 0.1; // both have come near enough to a sharp edge
        QVERIFY2(isKnife || std::abs(least / reference.least - 1) < 0.05, qPrintable(figures));
        QVERIFY2(std::abs(thinShare(report) - reference.thinShare) < 0.015 + 0.05 * reference.thinShare,
                 qPrintable(figures));
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
        QVERIFY(part.least <= part.most && part.least <= part.byRays);
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

/// Metres of sheet metal, and edges like knives: twelve triangles do not become millions.
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

/// Two grooves across the same two triangles of the ground are two places.
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
    // A thin place that no corner is near is shown at the nearest ones.
    const TriangleMesh block = grooved(0.5, 5);
    const std::vector<float> ofBlock = core::pictureOf(core::measureForPrint(block), core::PrintPicture::Thickness);
    QVERIFY(std::ranges::count_if(ofBlock, [](float t) { return t < 0.8F; }) >= 2);
}

void TestWallThickness::wallOfTheLimit_isNotThin_data()
{
    QTest::addColumn<float>("thickness");
    QTest::addColumn<float>("distance"); ///< from the origin, mm
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
    QCOMPARE(alone.parts.size(), together.parts.size());
    for (std::size_t i = 0; i < alone.parts.size(); ++i)
        QVERIFY(alone.parts[i].least == together.parts[i].least && alone.parts[i].corners == together.parts[i].corners);
}

FETTLE_TEST(TestWallThickness)

#include "tst_wall_thickness.moc"
