// Moves a surface onto its lattice (core/README.md, "The lattice"):
//   1. snap     each vertex to the nearest lattice point
//   2. check    for degenerate faces and self-intersections, exactly
//   3. resnap   a corner of each unsound face to the next-nearest lattice point, check again, and repeat a few times
//   4. nesting  the whole surface must bound a solid

#include "core/mesh/lattice_fit.h"

#include "core/analysis/nesting.h"
#include "core/analysis/self_intersection.h"

#include <algorithm>
#include <map>

namespace core
{
namespace
{
constexpr std::size_t resnapRounds = 6;

/// Returns faces that are degenerate or meet another face. Stops at 1000 pairs, so the list may be incomplete; it is
/// empty only if the surface is sound.
std::vector<Slot> unsoundFaces(std::span<const LatticePoint> points, std::span<const Triangle> triangles,
                               const std::stop_token& stop)
{
    std::vector<Slot> faces = degenerateFaces<LatticePredicates>(points, triangles);
    for (const FacePair& pair : selfIntersections<LatticePredicates>(points, triangles, 1000, stop).pairs) {
        faces.push_back(pair.first);
        faces.push_back(pair.second);
    }
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    return faces;
}

/// Returns the lattice point that is at rank `choice` among the 27 nearest by distance from `exact`, the position
/// before snapping; 0 is the nearest.
LatticePoint latticeNeighbour(const Lattice& lattice, const Vec3& exact, std::size_t choice)
{
    const LatticePoint nearest = lattice.toLattice(lattice.snap(exact));
    std::vector<std::pair<double, LatticePoint>> candidates;
    for (int x : {-1, 0, 1}) {
        for (int y : {-1, 0, 1}) {
            for (int z : {-1, 0, 1}) {
                const LatticePoint p = nearest + LatticePoint(x, y, z);
                if (p.cwiseAbs().maxCoeff() <= Lattice::limit)
                    candidates.emplace_back((p.cast<double>() * lattice.unit() - exact).squaredNorm(), p);
            }
        }
    }
    std::ranges::stable_sort(candidates, {}, [](const auto& candidate) { return candidate.first; });
    return candidates[std::min(choice, candidates.size() - 1)].second;
}
} // namespace

std::vector<LatticePoint> snappedTo(const Lattice& lattice, std::span<const Vec3> points)
{
    std::vector<LatticePoint> result;
    result.reserve(points.size());
    for (const Vec3& p : points)
        result.push_back(lattice.toLattice(lattice.snap(p)));
    return result;
}

LatticeFit fitToLattice(const Lattice& lattice, std::span<const Vec3> points, std::span<const Triangle> triangles,
                        const JobControl& control)
{
    LatticeFit fit;
    fit.points = snappedTo(lattice, points);
    std::vector<std::size_t> choices(points.size(), 0);
    std::vector<Slot> unsound = unsoundFaces(fit.points, triangles, control.stop);
    for (std::size_t round = 0; round < resnapRounds && !unsound.empty() && !control.isCancelled(); ++round) {
        for (std::size_t i = 0; i < unsound.size(); ++i) {
            // Different corners for neighbouring faces, so that the corners separate
            const Slot v = triangles[unsound[i]][(i + round) % 3];
            fit.points[v] = latticeNeighbour(lattice, points[v], ++choices[v]);
        }
        unsound = unsoundFaces(fit.points, triangles, control.stop);
    }
    fit.resnapped = static_cast<std::size_t>(std::ranges::count_if(choices, [](std::size_t c) { return c > 0; }));
    fit.unsnappable = unsound.size();
    if (unsound.empty() && !control.isCancelled() && !boundsSolid(fit.points, triangles))
        fit.unsnappable = triangles.size();
    return fit;
}

LatticeFit fitPartsToLattice(const Lattice& lattice, std::span<const Vec3> points, std::span<const Triangle> triangles,
                             std::span<const PartId> parts, const JobControl& control)
{
    std::map<PartId, std::vector<Triangle>> byPart;
    for (const Triangle& t : triangles)
        byPart[parts[t[0]]].push_back(t);
    if (byPart.size() == 1)
        return fitToLattice(lattice, points, triangles, control);
    LatticeFit all;
    all.points = snappedTo(lattice, points);
    std::vector<Slot> newIndex(points.size(), noSlot);
    for (auto& [part, faces] : byPart) {
        std::vector<Slot> used;
        for (Triangle& t : faces) {
            for (Slot& v : t) {
                if (newIndex[v] == noSlot) {
                    newIndex[v] = static_cast<Slot>(used.size());
                    used.push_back(v);
                }
                v = newIndex[v];
            }
        }
        std::vector<Vec3> own;
        for (const Slot v : used)
            own.push_back(points[v]);
        const LatticeFit fit = fitToLattice(lattice, own, faces, control);
        for (Slot i = 0; i < used.size(); ++i)
            all.points[used[i]] = fit.points[i];
        all.resnapped += fit.resnapped;
        all.unsnappable += fit.unsnappable;
    }
    return all;
}
} // namespace core
