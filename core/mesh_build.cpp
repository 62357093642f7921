// From a stranger's triangles to a sculptable mesh:
//   1. judge      the coordinates as they came, exactly                          mesh_check
//   2. fit        move, choose the lattice, snap                                 lattice_placement
//   3. judge      again if snapping moved a point and step 1 did not see this lattice; retry neighbouring lattice points
//                 where faces came to meet
//   4. lay out    along a Morton curve, and link                                 morton_order, mesh

#include "mesh_build.h"

#include "lattice_placement.h"
#include "morton_order.h"
#include "nesting.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr std::size_t resnapRounds = 6;

/// A model moved and snapped to its lattice.
struct Fit
{
    LatticePlacement placement;
    std::vector<LatticePoint> points;
    bool exact = true; ///< the snapping moved no point
};

Fit fitToLattice(const TriangleMesh& model, bool centre)
{
    Box box;
    for (const Vec3f& p : model.points)
        box.extend(p.cast<double>());
    Fit fit;
    fit.placement = placeOnLattice(box, centre);
    const Lattice& lattice = fit.placement.lattice;
    fit.points.reserve(model.points.size());
    for (const Vec3f& p : model.points) {
        fit.points.push_back(fit.placement.toLattice(p));
        const Vec3 snapped = lattice.toPoint(fit.points.back()).cast<double>();
        fit.exact = fit.exact && snapped == p.cast<double>() + fit.placement.moved;
    }
    return fit;
}

TriangleMesh withoutUnusedVertices(const TriangleMesh& mesh)
{
    std::vector<Slot> newIndex(mesh.points.size(), noSlot);
    TriangleMesh result;
    result.triangles = mesh.triangles;
    for (const Triangle& t : mesh.triangles) {
        for (Slot v : t)
            newIndex[v] = 0;
    }
    for (Slot v = 0; v < mesh.points.size(); ++v) {
        if (newIndex[v] == noSlot)
            continue;
        newIndex[v] = static_cast<Slot>(result.points.size());
        result.points.push_back(mesh.points[v]);
        if (!mesh.colors.empty())
            result.colors.push_back(mesh.colors[v]);
    }
    for (Triangle& t : result.triangles) {
        for (Slot& v : t)
            v = newIndex[v];
    }
    return result;
}

/// Some at least, if the snapped model is not as sound as it was.
std::vector<Slot> unsoundFaces(const Fit& fit, std::span<const Triangle> triangles)
{
    std::vector<Slot> faces = degenerateFaces<LatticePredicates>(fit.points, triangles);
    for (const FacePair& pair : selfIntersections<LatticePredicates>(fit.points, triangles).pairs) {
        faces.push_back(pair.first);
        faces.push_back(pair.second);
    }
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    return faces;
}

/// Lattice points by distance from where the vertex was before it was snapped; `choice` 0 is the nearest.
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

/// Sends the corners of unsound faces to other lattice points nearby until all is sound, or gives up.
void resnap(Fit& fit, const TriangleMesh& model, BuildResult& result)
{
    std::vector<std::size_t> choices(model.points.size(), 0);
    std::vector<Slot> unsound = unsoundFaces(fit, model.triangles);
    for (std::size_t round = 0; round < resnapRounds && !unsound.empty(); ++round) {
        for (std::size_t i = 0; i < unsound.size(); ++i) {
            const Slot v = model.triangles[unsound[i]][(i + round) % 3]; // one corner of each face, so that corners part
            const Vec3 exact = model.points[v].cast<double>() + fit.placement.moved;
            fit.points[v] = latticeNeighbour(fit.placement.lattice, exact, ++choices[v]);
        }
        unsound = unsoundFaces(fit, model.triangles);
    }
    result.resnapped = static_cast<std::size_t>(std::ranges::count_if(choices, [](std::size_t c) { return c > 0; }));
    result.unsnappable = unsound.size();
    if (unsound.empty() && !boundsSolid(fit.points, model.triangles))
        result.unsnappable = model.triangles.size();
}
} // namespace

BuildResult buildMesh(const TriangleMesh& model, bool centre)
{
    BuildResult result;
    result.report = checkMesh(model);
    if (!result.report.printReady())
        return result;
    TriangleMesh used = withoutUnusedVertices(model);
    Fit fit = fitToLattice(used, centre);
    const bool seen = result.report.latticeOk.value_or(false) && fit.placement.moved == Vec3::Zero();
    if (!fit.exact && !seen)
        resnap(fit, used, result);
    if (result.unsnappable > 0)
        return result;
    const Lattice& lattice = fit.placement.lattice;
    for (Slot v = 0; v < used.points.size(); ++v)
        used.points[v] = lattice.toPoint(fit.points[v]);
    result.moved = fit.placement.moved;
    result.mesh = std::make_unique<Mesh>(inMortonOrder(used, lattice), lattice);
    return result;
}

TriangleMesh extractMesh(const Mesh& mesh)
{
    TriangleMesh result;
    const SlotCounts live = mesh.live();
    result.points.reserve(live.vertices);
    result.colors.reserve(live.vertices);
    result.triangles.reserve(live.faces);
    std::vector<Slot> newIndex(mesh.slots().vertices, noSlot);
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (!mesh.isVertex(v))
            continue;
        newIndex[v] = static_cast<Slot>(result.points.size());
        result.points.push_back(mesh.point(v));
        result.colors.push_back(mesh.color(v));
    }
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        if (!mesh.isFace(f))
            continue;
        const Triangle& t = mesh.corners(f);
        result.triangles.push_back({newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]});
    }
    if (std::ranges::all_of(result.colors, [](Rgb c) { return c == Rgb(); }))
        result.colors.clear();
    return result;
}
} // namespace core
