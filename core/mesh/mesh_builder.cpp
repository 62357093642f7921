// Makes a sculptable mesh from the triangles of any file:
//   1. check      the coordinates as read, exactly                                mesh_check
//   2. place      move the model, choose the lattice                             lattice_placement
//   3. fit        snap; check again if snapping moved a point and step 1 did not check on this lattice;
//                 retry neighbouring lattice points where faces intersect        lattice_fit
//   4. sort       along a Morton curve, and link                                 morton_order, mesh

#include "core/mesh/mesh_builder.h"

#include "core/geometry/lattice_placement.h"
#include "core/geometry/morton_order.h"
#include "core/mesh/lattice_fit.h"
#include "core/parts/part_split.h"

#include <algorithm>

namespace core
{
namespace
{
/// Shares of the progress at the end of the check and of the lattice fit.
constexpr double afterCheck = 0.7, afterFit = 0.75;

/// A model moved to its place on a lattice.
struct Placed
{
    LatticePlacement placement;
    std::vector<Vec3> points; ///< translated, not snapped
    bool exact = true;        ///< every translated point is on the lattice
};

/// Places the model at its old position on its old lattice. Returns nothing if there is no frame or if a point is not
/// on that lattice.
std::optional<Placed> restorePlacement(const TriangleMesh& model, const std::optional<MeshFrame>& frame)
{
    if (!frame)
        return std::nullopt;
    Placed placed{{frame->lattice, -frame->place}, {}};
    for (const Vec3f& p : model.points) {
        placed.points.push_back(p.cast<double>() - frame->place);
        const Vec3f snapped = frame->lattice.snap(placed.points.back());
        if (snapped.cast<double>() != placed.points.back() || !frame->lattice.isOnLattice(snapped))
            return std::nullopt;
    }
    return placed;
}

Placed place(const TriangleMesh& model, bool centre)
{
    Box box;
    for (const Vec3f& p : model.points)
        box.extend(p.cast<double>());
    Placed placed;
    placed.placement = placeOnLattice(box, centre);
    placed.points.reserve(model.points.size());
    for (const Vec3f& p : model.points) {
        const Vec3 moved = p.cast<double>() + placed.placement.moved;
        placed.points.push_back(moved);
        placed.exact = placed.exact && placed.placement.lattice.snap(moved).cast<double>() == moved;
    }
    return placed;
}
} // namespace

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
        if (!mesh.masks.empty())
            result.masks.push_back(mesh.masks[v]);
        if (!mesh.parts.empty())
            result.parts.push_back(mesh.parts[v]);
    }
    for (Triangle& t : result.triangles) {
        for (Slot& v : t)
            v = newIndex[v];
    }
    return result;
}

BuildResult buildMesh(const TriangleMesh& model, bool centre, const JobControl& control,
                      const std::optional<MeshFrame>& frame)
{
    BuildResult result;
    result.report = checkMesh(model, control.part(0, afterCheck));
    if (control.isCancelled() || !result.report.printReady())
        return result;
    TriangleMesh used = withoutUnusedVertices(model);
    const std::optional<Placed> restored = restorePlacement(used, frame);
    const Placed placed = restored ? *restored : place(used, centre);
    const Lattice& lattice = placed.placement.lattice;
    const bool seen = result.report.latticeOk.value_or(false) && placed.placement.moved == Vec3::Zero();
    LatticeFit fit;
    if (placed.exact || seen)
        fit.points = snappedTo(lattice, placed.points);
    else
        fit = used.parts.empty() ? fitToLattice(lattice, placed.points, used.triangles, control)
                                 : fitPartsToLattice(lattice, placed.points, used.triangles, used.parts, control);
    control.reportProgress(afterFit);
    result.resnapped = fit.resnapped;
    result.unsnappable = fit.unsnappable;
    if (control.isCancelled() || result.unsnappable > 0)
        return result;
    for (Slot v = 0; v < used.points.size(); ++v)
        used.points[v] = lattice.toPoint(fit.points[v]);
    result.mesh = std::make_unique<Mesh>(inMortonOrder(used, lattice), lattice);
    MeshFrame own = restored ? *frame : result.mesh->frame();
    own.place = Vec3::Zero() - placed.placement.moved; // subtraction avoids -0
    own.parts = listedParts(used, frame ? frame->parts : PartList());
    result.mesh->beginStroke();
    result.mesh->setFrame(own);
    result.mesh->endStroke();
    return result;
}

TriangleMesh extractMesh(const Mesh& mesh)
{
    TriangleMesh result;
    const SlotCounts live = mesh.live();
    result.points.reserve(live.vertices);
    result.colors.reserve(live.vertices);
    result.masks.reserve(live.vertices);
    result.triangles.reserve(live.faces);
    std::vector<Slot> newIndex(mesh.slots().vertices, noSlot);
    for (const Slot v : mesh.vertices()) {
        newIndex[v] = static_cast<Slot>(result.points.size());
        result.points.push_back(mesh.point(v));
        result.colors.push_back(mesh.color(v));
        result.masks.push_back(mesh.mask(v));
        result.parts.push_back(mesh.part(v));
    }
    for (const Slot f : mesh.faces()) {
        const Triangle& t = mesh.corners(f);
        result.triangles.push_back({newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]});
    }
    if (std::ranges::all_of(result.colors, [](Rgb c) { return c == Rgb(); }))
        result.colors.clear();
    if (std::ranges::all_of(result.masks, [](std::uint8_t mask) { return mask == 0; }))
        result.masks.clear();
    if (std::ranges::all_of(result.parts, [](PartId part) { return part == 0; }))
        result.parts.clear();
    return result;
}
} // namespace core
