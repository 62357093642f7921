#include "core/operations/part_union.h"

#include "core/analysis/part_overlap.h"
#include "core/boolean/mesh_boolean.h"
#include "core/parts/part_split.h"

#include <vector>

namespace core
{
PartUnion uniteParts(TriangleMesh& mesh, const std::optional<Lattice>& lattice, const JobControl& control)
{
    constexpr double afterOverlap = 0.2;
    if (!doPartsOverlap(mesh, control.part(0, afterOverlap)) || control.isCancelled())
        return PartUnion::NotNeeded;
    std::vector<TriangleMesh> solids;
    for (PartPiece& piece : splitByPart(mesh))
        solids.push_back(std::move(piece.mesh));
    const JobControl rest = control.part(afterOverlap, 1);
    BooleanResult all =
        lattice ? combineOn(*lattice, SetOperation::Union, solids, rest) : combine(SetOperation::Union, solids, rest);
    if (!all.mesh)
        return PartUnion::Failed;
    mesh = std::move(*all.mesh);
    return PartUnion::Done;
}
} // namespace core
