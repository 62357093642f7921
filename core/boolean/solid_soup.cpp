#include "core/boolean/solid_soup.h"

#include "core/geometry/face_geometry.h"
#include "core/util/parallel.h"

#include <algorithm>
#include <cmath>

namespace core::boolean
{
namespace
{
constexpr std::size_t pointsPerChunk = 1 << 14;

/// Returns the lattice of an import, 2^finer times finer. Far from the origin, where float32 numbers are farther apart
/// than that, returns the finest whose points are exact in float32.
LatticePlacement placementFor(const Box& box, int finer)
{
    constexpr int mantissaBits = 24;
    const LatticePlacement import = placeOnLattice(box);
    const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    int exponent = 0; // largest < 2^exponent
    std::frexp(largest, &exponent);
    const Lattice lattice(std::min(import.lattice.exponent() + finer, mantissaBits - exponent));
    const auto onLattice = [&](double x) { return lattice.snap(x); };
    return {lattice, import.moved.unaryExpr(onLattice)};
}

void addColors(const TriangleMesh& solid, std::vector<Rgb>& colors)
{
    if (solid.colors.empty())
        colors.resize(colors.size() + solid.points.size());
    else
        colors.insert(colors.end(), solid.colors.begin(), solid.colors.end());
}
} // namespace

SolidSoup soupOf(SetOperation operation, std::span<const TriangleMesh> solids, int finer)
{
    Box box;
    for (const TriangleMesh& solid : solids)
        box.extend(core::boxOf(solid));
    return soupOn(placementFor(box, finer), operation, solids);
}

SolidSoup soupOn(const LatticePlacement& placement, SetOperation operation, std::span<const TriangleMesh> solids)
{
    SolidSoup soup;
    soup.placement = placement;
    const bool isColored = std::ranges::any_of(solids, [](const TriangleMesh& solid) { return !solid.colors.empty(); });
    soup.isDifference = operation == SetOperation::Difference;
    soup.least = operation == SetOperation::Intersection ? static_cast<int>(solids.size()) : 1;
    repair::TriangleSoup& surface = soup.surface;
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const TriangleMesh& solid = solids[s];
        const auto first = static_cast<Slot>(surface.points.size());
        soup.firstPoints.push_back(first);
        soup.firstFaces.push_back(static_cast<Slot>(surface.triangles.size()));
        surface.points.resize(first + solid.points.size());
        forEachChunk(solid.points.size(), pointsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                surface.points[first + i] = soup.placement.toLattice(solid.points[i]);
        });
        if (isColored)
            addColors(solid, surface.colors);
        const bool isTurned = soup.windingOf(s) < 0;
        LatticeBox& around = soup.boxes.emplace_back();
        for (const auto& [a, b, c] : solid.triangles) {
            surface.triangles.push_back({first + a, first + (isTurned ? c : b), first + (isTurned ? b : c)});
            for (const Slot v : {a, b, c})
                around.extend(surface.points[first + v]);
        }
    }
    soup.firstPoints.push_back(static_cast<Slot>(surface.points.size()));
    soup.firstFaces.push_back(static_cast<Slot>(surface.triangles.size()));
    return soup;
}
} // namespace core::boolean
