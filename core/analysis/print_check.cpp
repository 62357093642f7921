// Will it print? Walls by wall_thickness; the rest is a pass over the faces.

#include "core/analysis/print_check.h"

#include "core/util/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace core
{
namespace
{
/// Shares of the time.
constexpr double afterCheck = 0.3;
constexpr double degree = std::numbers::pi / 180;

/// What the pass needs of a face.
struct Side
{
    Vec3 centre, normal; ///< the normal is as long as the face has area
    bool isOnBed;

    double area() const { return std::sqrt(normal.squaredNorm()); }
};

class Sides
{
public:
    explicit Sides(const TriangleMesh& mesh) : m_mesh(mesh)
    {
        double lowest = std::numeric_limits<double>::infinity();
        for (const Triangle& t : mesh.triangles)
            for (const Slot corner : t)
                lowest = std::min(lowest, static_cast<double>(mesh.points[corner].y()));
        m_bed = lowest + PrintLimits::bedTolerance;
    }

    Side operator[](Slot face) const
    {
        const auto& [a, b, c] = m_mesh.triangles[face];
        const Vec3 p = m_mesh.points[a].cast<double>(), q = m_mesh.points[b].cast<double>(),
                   r = m_mesh.points[c].cast<double>();
        const bool isLow = p.y() <= m_bed && q.y() <= m_bed && r.y() <= m_bed;
        const Vec3 normal = (q - p).cross(r - p) / 2;
        return {(p + q + r) / 3, normal, isLow && normal.y() < 0};
    }

private:
    const TriangleMesh& m_mesh;
    double m_bed = 0;
};

/// Degrees from the vertical: above 0 it leans out.
double leaningOf(const Side& side)
{
    const double area = side.area();
    return side.isOnBed || area == 0 ? -90 : std::asin(std::clamp(-side.normal.y() / area, -1.0, 1.0)) / degree;
}

/// Faces that share a vertex hang together. Faces are added in ascending order, so the places have one order.
class Places
{
public:
    explicit Places(const TriangleMesh& mesh) : m_mesh(mesh), m_sets(mesh.points.size()) {}

    /// Of two the one with the lower badness is the worse.
    void add(Slot face, double badness)
    {
        m_faces.push_back({face, badness});
        const auto& [a, b, c] = m_mesh.triangles[face];
        m_sets.unite(a, b);
        m_sets.unite(a, c);
    }

    template <class Value> PrintFault take(const Sides& sides, Value valueOf)
    {
        PrintFault fault;
        std::vector<double> min;
        std::vector<Slot> number(m_sets.size(), noSlot);
        for (const auto& [face, badness] : m_faces) {
            Slot& place = number[m_sets.root(m_mesh.triangles[face][0])];
            const Side side = sides[face];
            if (place == noSlot) {
                place = static_cast<Slot>(fault.places.size());
                fault.places.emplace_back();
                min.push_back(std::numeric_limits<double>::infinity());
            }
            fault.places[place].area += side.area();
            fault.area += side.area();
            if (badness < min[place]) {
                min[place] = badness;
                fault.places[place].face = face;
            }
        }
        fault.count = fault.places.size();
        std::ranges::stable_sort(fault.places, std::greater(), &PrintPlace::area);
        fault.places.resize(std::min(fault.places.size(), PrintFault::maxPlaces));
        for (PrintPlace& place : fault.places) {
            const Side side = sides[place.face];
            place.point = side.centre;
            place.normal = side.area() > 0 ? Vec3(side.normal / side.area()) : Vec3::UnitY();
            place.worst = valueOf(place.face);
        }
        return fault;
    }

private:
    struct Bad
    {
        Slot face;
        double badness;
    };

    const TriangleMesh& m_mesh;
    DisjointSets m_sets; ///< of vertices
    std::vector<Bad> m_faces;
};

PrintFault thinPlaces(const PrintMeasures& measures, const Sides& sides, double minWall)
{
    if (!measures.walls)
        return {};
    const std::vector<float>& thickness = measures.walls->byBalls;
    Places places(measures.mesh);
    for (Slot f = 0; f < thickness.size(); ++f)
        if (static_cast<double>(thickness[f]) < minWall)
            places.add(f, static_cast<double>(thickness[f]));
    return places.take(sides, [&](Slot f) { return static_cast<double>(thickness[f]); });
}

PrintFault overhangPlaces(const TriangleMesh& mesh, const Sides& sides, double limit)
{
    const double sine = std::sin(limit * degree);
    Places places(mesh);
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const Side side = sides[f];
        if (!side.isOnBed &&
            -side.normal.y() > sine * side.area() * (1 + 1e-6)) // a face that leans so much exactly is none
            places.add(f, side.normal.y() / side.area());
    }
    return places.take(sides, [&](Slot f) { return leaningOf(sides[f]); });
}

std::optional<double> minOf(const std::vector<float>& values)
{
    const auto min = std::ranges::min_element(values);
    return min != values.end() && std::isfinite(*min) ? std::optional(static_cast<double>(*min)) : std::nullopt;
}

BedFit fitOf(const Vec3& size, const PrintBed& bed)
{
    if (size.y() > bed.z)
        return BedFit::Not;
    if (size.x() <= bed.x && size.z() <= bed.y)
        return BedFit::AsItStands;
    return size.x() <= bed.y && size.z() <= bed.x ? BedFit::Turned : BedFit::Not;
}
} // namespace

PrintMeasures measureForPrint(TriangleMesh mesh, const JobControl& control)
{
    PrintMeasures measures{std::move(mesh), {}, {}};
    measures.report = checkMesh(measures.mesh, control.part(0, afterCheck));
    if (measures.report.printReady() && !control.isCancelled())
        measures.walls = wallThickness(measures.mesh, PrintLimits::largestBall, control.part(afterCheck, 1));
    return measures;
}

PrintReport checkForPrint(const PrintMeasures& measures, const PrintLimits& limits)
{
    PrintReport report;
    const Sides sides(measures.mesh);
    report.area = measures.report.area;
    if (measures.walls) {
        report.minByRays = minOf(measures.walls->byRays);
        report.minByBalls = minOf(measures.walls->byBalls);
    }
    report.thin = thinPlaces(measures, sides, limits.minWall);
    report.overhangs = overhangPlaces(measures.mesh, sides, limits.overhang);
    for (Slot f = 0; f < measures.mesh.triangles.size(); ++f) {
        const Side side = sides[f];
        report.baseArea += side.isOnBed ? -side.normal.y() : 0;
    }
    report.fit = fitOf(measures.report.size, limits.bed);
    return report;
}

UnitDoubt unitDoubtOf(double volume)
{
    const double size = std::abs(volume);
    return size < PrintLimits::metreVolume  ? UnitDoubt::Metres
           : size < PrintLimits::inchVolume ? UnitDoubt::Inches
                                            : UnitDoubt::None;
}

UnitDoubt guessedUnit(double volume, double longestSide)
{
    if (unitDoubtOf(volume) == UnitDoubt::None)
        return UnitDoubt::None;
    return longestSide < 1 ? UnitDoubt::Metres : UnitDoubt::Inches;
}

std::vector<float> pictureOf(const PrintMeasures& measures, PrintPicture picture)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const bool isThickness = picture == PrintPicture::Thickness;
    std::vector<float> values(measures.mesh.points.size(), isThickness ? infinity : -90);
    const Sides sides(measures.mesh);
    for (Slot f = 0; f < measures.mesh.triangles.size(); ++f) {
        const float value = !isThickness     ? static_cast<float>(leaningOf(sides[f]))
                            : measures.walls ? measures.walls->byBalls[f]
                                             : infinity;
        for (const Slot corner : measures.mesh.triangles[f])
            values[corner] = isThickness ? std::min(values[corner], value) : std::max(values[corner], value);
    }
    return values;
}
} // namespace core
