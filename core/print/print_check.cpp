// Checks whether a model will print. Walls are measured by wall_thickness; everything else is one pass over the faces.

#include "core/print/print_check.h"

#include "core/geometry/face_geometry.h"
#include "core/geometry/point_triangle.h"
#include "core/print/print_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core
{
namespace
{
/// Progress, 0 to 1, at the end of checkMesh().
constexpr double afterCheck = 0.3;
constexpr double degree = std::numbers::pi / 180;

/// The properties of a face that the checks need.
struct Side
{
    Vec3 centre, normal; ///< length of the normal: area of the face
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

/// Returns the angle of a face from the vertical, degrees; above 0 it leans out. Returns -90 for a face on the bed or
/// without area.
double leaningOf(const Side& side)
{
    const double area = side.area();
    return side.isOnBed || area == 0 ? -90 : std::asin(std::clamp(-side.normal.y() / area, -1.0, 1.0)) / degree;
}

/// Returns the tolerance of the wall limit, mm: a wall that is thinner by less than it is not reported. Covers the
/// rounding of float32 coordinates and what printers cannot resolve.
double wallTolerance(const TriangleMesh& mesh, double minWall)
{
    constexpr double share = 1e-3, floatSteps = 4;
    float farthest = 0;
    for (const Vec3f& p : mesh.points)
        farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    const double step = static_cast<double>(farthest) * static_cast<double>(std::numeric_limits<float>::epsilon());
    return std::max(share * minWall, floatSteps * step);
}

PrintFault thinPlaces(const PrintMeasures& measures, const Sides& sides, double minWall)
{
    if (!measures.walls)
        return {};
    const double limit = minWall - wallTolerance(measures.mesh, minWall);
    const std::vector<float>& thickness = measures.walls->atCentres;
    PrintPlaces places(measures.mesh);
    auto part = measures.walls->parts.begin();
    const auto end = measures.walls->parts.end();
    for (Slot f = 0; f < thickness.size(); ++f) {
        if (part == end || part->face != f) {
            if (static_cast<double>(thickness[f]) < limit)
                places.addFace(f, static_cast<double>(thickness[f]));
            continue;
        }
        const double area = sides[f].area();
        for (; part != end && part->face == f; ++part)
            if (const double share = part->shareBelow(limit); share > 0)
                places.addPart(*part, area * static_cast<double>(part->share) * share);
    }
    for (const WallRidge& ridge : measures.walls->ridges)
        if (static_cast<double>(ridge.least) < limit)
            places.addRidge(ridge);
    return places.take();
}

PrintFault overhangPlaces(const TriangleMesh& mesh, const Sides& sides, double limit)
{
    const double sine = std::sin(limit * degree);
    PrintPlaces places(mesh);
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const Side side = sides[f];
        if (!side.isOnBed && -side.normal.y() > sine * side.area() * (1 + 1e-6)) // not for a face at exactly the limit
            places.addFace(f, side.normal.y() / side.area());
    }
    PrintFault fault = places.take();
    for (PrintPlace& place : fault.places)
        place.worst = leaningOf(sides[place.face]);
    return fault;
}

/// Returns the least thickness over all faces' centres, parts and ridges; nothing if no face has an opposite face.
std::optional<double> thinnestOf(const WallThickness& walls)
{
    float min = std::numeric_limits<float>::infinity();
    for (const float thickness : walls.atCentres)
        min = std::min(min, thickness);
    for (const WallPart& part : walls.parts)
        min = std::min(min, part.least);
    for (const WallRidge& ridge : walls.ridges)
        min = std::min(min, ridge.least);
    return std::isfinite(min) ? std::optional(static_cast<double>(min)) : std::nullopt;
}

/// Returns the corner of the face with the largest barycentric weight at the point p.
Slot nearestCorner(const TriangleMesh& mesh, Slot face, const Vec3f& p)
{
    const auto weights = cornerWeights(p.cast<double>(), cornersOf(mesh, face));
    return mesh.triangles[face][static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin())];
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
    if (measures.walls)
        report.thinnest = thinnestOf(*measures.walls);
    report.thin = thinPlaces(measures, sides, limits.minWall);
    // The strips along thin ridges overlap thin faces, so the sum may exceed the whole area.
    report.thin.area = std::min(report.thin.area, report.area);
    report.overhangs = overhangPlaces(measures.mesh, sides, limits.overhang);
    for (Slot f = 0; f < measures.mesh.triangles.size(); ++f) {
        const Side side = sides[f];
        report.baseArea += side.isOnBed ? -side.normal.y() : 0;
    }
    report.fit = fitOf(measures.report.size, limits.bed);
    return report;
}

bool hasThinWalls(const PrintReport& report, const PrintLimits& limits)
{
    return !report.thin.places.empty() && report.thin.places.front().area > limits.minWall * limits.minWall;
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
    if (unitDoubtOf(volume) == UnitDoubt::None && longestSide >= PrintLimits::inchSide)
        return UnitDoubt::None;
    return longestSide < PrintLimits::metreSide ? UnitDoubt::Metres : UnitDoubt::Inches;
}

std::vector<float> pictureOf(const PrintMeasures& measures, PrintPicture picture)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const bool isThickness = picture == PrintPicture::Thickness;
    std::vector<float> values(measures.mesh.points.size(), isThickness ? infinity : -90);
    if (isThickness && !measures.walls)
        return values;
    const auto show = [&](Slot face, const Vec3f& p, float thickness) {
        float& value = values[nearestCorner(measures.mesh, face, p)];
        value = std::min(value, thickness);
    };
    const Sides sides(measures.mesh);
    std::vector<bool> isDivided(isThickness ? measures.mesh.triangles.size() : 0);
    if (isThickness) {
        for (const WallPart& part : measures.walls->parts) {
            isDivided[part.face] = true;
            for (const Vec3f& corner : part.corners)
                show(part.face, corner, part.least);
        }
        for (const WallRidge& ridge : measures.walls->ridges)
            for (const Vec3f& end : ridge.ends)
                show(ridge.face, end, ridge.least);
    }
    for (Slot f = 0; f < measures.mesh.triangles.size(); ++f) {
        if (isThickness && isDivided[f])
            continue;
        const float value = isThickness ? measures.walls->atCentres[f] : static_cast<float>(leaningOf(sides[f]));
        for (const Slot corner : measures.mesh.triangles[f])
            values[corner] = isThickness ? std::min(values[corner], value) : std::max(values[corner], value);
    }
    return values;
}
} // namespace core
