#include "core/operations/model_command.h"

#include "core/mesh/mesh_builder.h"
#include "core/operations/flatten_base.h"
#include "core/operations/insert_model.h"
#include "core/operations/mask_operations.h"
#include "core/operations/snapshot.h"
#include "core/operations/symmetrize.h"
#include "core/operations/transform.h"
#include "core/operations/uniform_remesh.h"
#include "core/util/overloaded.h"

namespace core
{
namespace
{
/// Paints the whole model; masked vertices take the colour in proportion to their freedom.
void fill(Mesh& mesh, Rgb color)
{
    for (const Slot v : mesh.vertices()) {
        const Rgb before = mesh.color(v), after = mixed(before, color, mesh.freedom(v));
        if (after != before)
            mesh.setColor(v, after);
    }
}
} // namespace

std::shared_ptr<const Snapshot> snapshotOf(const Mesh& mesh)
{
    return std::make_shared<Snapshot>(Snapshot{extractMesh(mesh), mesh.frame()});
}

std::unique_ptr<Mesh> meshOf(const Snapshot& snapshot)
{
    auto mesh = std::make_unique<Mesh>(snapshot.surface, snapshot.frame.lattice);
    mesh->beginStroke();
    mesh->setFrame(snapshot.frame);
    mesh->endStroke();
    return mesh;
}

ModelChange applyToCopy(Mesh copy, const ModelCommand& command, const JobControl& control)
{
    ModelChange change;
    copy.beginStroke();
    const Overloaded edit{
        [&](const Insert& insert) { insertModel(copy, insert, change, control); },
        [&](const RemeshUniformly& remesh) { remeshUniformly(copy, remesh, change, control); },
        [&](const Symmetrize& symmetrizing) { symmetrize(copy, symmetrizing, change, control); },
        [&](const FlattenBase& flattening) { flattenBase(copy, flattening, change, control); },
        [&](const Fill& filling) { fill(copy, filling.color); },
        [&](const MaskOperation& operation) { applyMaskOperation(copy, operation); },
        [&](const Reset& reset) { copy.assign(*meshOf(*reset.start)); },
        [&](const auto& motion) { transform(copy, motion, change, control); },
    };
    std::visit(edit, command);
    change.delta = copy.endStroke();
    if (change.refusal != ModelRefusal::None || control.isCancelled()) {
        change.delta = {};
        return change;
    }
    change.changes = !change.delta.empty() || change.delta.frame != copy.frame();
    copy.swap(change.delta);
    control.reportProgress(1);
    return change;
}
} // namespace core
