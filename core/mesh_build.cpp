// From a stranger's triangles to a sculptable mesh:
//   1. judge      the coordinates as they came, exactly                          mesh_check
//   2. fit        move, choose the lattice, snap                                 lattice_placement
//   3. judge      again if snapping moved a point; retry neighbouring lattice points where faces came to meet
//   4. lay out    along a Morton curve, and link                                 morton_order, mesh

#include "mesh_build.h"

#include "lattice_placement.h"
#include "morton_order.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr int resnapRounds = 6;

/// A model moved and snapped to its lattice.
struct Fit
{
    TriangleMesh mesh;
    LatticePlacement placement;
    bool exact = true; ///< the snapping moved no point
};

Fit fitToLattice(const TriangleMesh& model, bool centre)
{
    Box box;
    for (const Vec3f& p : model.points)
        box.extend(p.cast<double>());
    Fit fit = {model, placeOnLattice(box, centre)};
    const Lattice& lattice = fit.placement.lattice;
    for (Vec3f& p : fit.mesh.points) {
        const Vec3 moved = p.cast<double>() + fit.placement.moved;
        p = lattice.toPoint(fit.placement.toLattice(p));
        fit.exact = fit.exact && p.cast<double>() == moved;
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

std::vector<Slot> unsoundFaces(const MeshReport& report)
{
    std::vector<Slot> faces = report.degenerateFaces.firstFaces;
    for (const FacePair& pair : report.intersections.pairs) {
        faces.push_back(pair.first);
        faces.push_back(pair.second);
    }
    std::ranges::sort(faces);
    faces.erase(std::ranges::unique(faces).begin(), faces.end());
    return faces;
}

/// Lattice points by distance from where the vertex was before it was snapped; `choice` 0 is the nearest.
Vec3f latticeNeighbour(const Lattice& lattice, const Vec3& exact, std::size_t choice)
{
    const Vec3 nearest = lattice.snap(exact).cast<double>();
    std::vector<std::pair<double, Vec3>> candidates;
    for (int x : {-1, 0, 1}) {
        for (int y : {-1, 0, 1}) {
            for (int z : {-1, 0, 1}) {
                const Vec3 p = nearest + lattice.unit() * Vec3(x, y, z);
                if (lattice.contains(p))
                    candidates.emplace_back((p - exact).squaredNorm(), p);
            }
        }
    }
    std::ranges::stable_sort(candidates, {}, [](const auto& candidate) { return candidate.first; });
    return candidates[std::min(choice, candidates.size() - 1)].second.cast<float>();
}

/// Sends the corners of unsound faces to other lattice points nearby until all is sound, or gives up.
void resnap(Fit& fit, const TriangleMesh& model, BuildResult& result)
{
    std::vector<std::size_t> choices(model.points.size(), 0);
    MeshReport report = checkMesh(fit.mesh);
    for (int round = 0; round < resnapRounds && !report.printReady(); ++round) {
        const std::vector<Slot> unsound = unsoundFaces(report);
        for (std::size_t i = 0; i < unsound.size(); ++i) {
            // One corner of each face a round, so that the corners part.
            const Slot v = fit.mesh.triangles[unsound[i]][(i + static_cast<std::size_t>(round)) % 3];
            ++choices[v];
            const Vec3 exact = model.points[v].cast<double>() + fit.placement.moved;
            fit.mesh.points[v] = latticeNeighbour(fit.placement.lattice, exact, choices[v]);
        }
        report = checkMesh(fit.mesh);
    }
    result.resnapped = static_cast<std::size_t>(std::ranges::count_if(choices, [](std::size_t c) { return c > 0; }));
    if (!report.printReady())
        result.unsnappable = std::max<std::size_t>(1, unsoundFaces(report).size());
}
} // namespace

BuildResult buildMesh(const TriangleMesh& model, bool centre)
{
    BuildResult result;
    result.report = checkMesh(model);
    if (!result.report.printReady())
        return result;
    const TriangleMesh used = withoutUnusedVertices(model);
    Fit fit = fitToLattice(used, centre);
    result.moved = fit.placement.moved;
    if (!fit.exact)
        resnap(fit, used, result);
    if (result.unsnappable == 0) {
        const Lattice& lattice = fit.placement.lattice;
        result.mesh = std::make_unique<Mesh>(inMortonOrder(fit.mesh, lattice), lattice);
    }
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
