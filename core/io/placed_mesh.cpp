#include "core/io/placed_mesh.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice_placement.h"
#include "core/mesh/lattice_fit.h"
#include "core/util/file_error.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
/// Smallest acceptable mean edge length, in steps between neighbouring floats. With fewer steps the surface is refused
/// without a check: its faces would meet everywhere.
constexpr double minStepsPerEdge = 3;

bool areFloatsTooCoarse(const TriangleMesh& mesh, const Vec3& place)
{
    double area = 0;
    for (Slot f = 0; f < mesh.triangles.size(); ++f) {
        const auto [a, b, c] = cornersOf(mesh, f);
        area += (b - a).cross(c - a).norm() / 2;
    }
    Box box = boxOf(mesh);
    box.translate(place);
    return floatStepsPerEdge(box, area, mesh.triangles.size()) < minStepsPerEdge;
}

/// Moves points to other floats where rounding made faces meet. Returns false if some points have no suitable float.
bool fitToFloats(TriangleMesh& mesh, std::span<const Vec3> places)
{
    double largest = 0;
    for (const Vec3& p : places)
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    int exponent = 0; // smallest exponent with 2^exponent above the largest coordinate
    std::frexp(largest, &exponent);
    const Lattice lattice(static_cast<int>(std::log2(Lattice::limit)) - exponent);
    const LatticeFit fit = mesh.parts.empty() ? fitToLattice(lattice, places, mesh.triangles)
                                              : fitPartsToLattice(lattice, places, mesh.triangles, mesh.parts);
    if (fit.unsnappable > 0)
        return false;
    for (std::size_t i = 0; i < fit.points.size(); ++i)
        mesh.points[i] = lattice.toPoint(fit.points[i]);
    return true;
}
} // namespace

TriangleMesh placedMesh(const std::filesystem::path& path, TriangleMesh mesh, const Vec3& place)
{
    std::vector<Vec3> places;
    places.reserve(mesh.points.size());
    for (const Vec3f& p : mesh.points)
        places.push_back(p.cast<double>() + place);
    const bool isExact = std::ranges::all_of(places, [](const Vec3& p) { return p.cast<float>().cast<double>() == p; });
    if (!isExact && areFloatsTooCoarse(mesh, place))
        throw FileError(FileErrorKind::TooFar, path);
    std::ranges::transform(places, mesh.points.begin(), [](const Vec3& p) { return Vec3f(p.cast<float>()); });
    if (!isExact && !checkMesh(mesh).printReady() && !fitToFloats(mesh, places))
        throw FileError(FileErrorKind::TooFar, path);
    return mesh;
}
} // namespace core
