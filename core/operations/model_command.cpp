#include "core/operations/model_command.h"

#include "core/mesh/mesh_builder.h"
#include "core/operations/flatten_base.h"
#include "core/operations/insert_model.h"
#include "core/operations/mask_operations.h"
#include "core/operations/snapshot.h"
#include "core/operations/symmetrize.h"
#include "core/operations/transform.h"
#include "core/operations/uniform_remesh.h"

namespace core
{
namespace
{
template <class Command> void edit(Mesh& mesh, const Command& command, ModelChange& change, const JobControl& control)
{
    transform(mesh, command, change, control);
}

void edit(Mesh& mesh, const Insert& command, ModelChange& change, const JobControl& control)
{
    insertModel(mesh, command, change, control);
}

void edit(Mesh& mesh, const RemeshUniformly& command, ModelChange& change, const JobControl& control)
{
    remeshUniformly(mesh, command, change, control);
}

void edit(Mesh& mesh, const Symmetrize& command, ModelChange& change, const JobControl& control)
{
    symmetrize(mesh, command, change, control);
}

void edit(Mesh& mesh, const FlattenBase& command, ModelChange& change, const JobControl& control)
{
    flattenBase(mesh, command, change, control);
}

/// As far as the mask lets it.
void edit(Mesh& mesh, const Fill& command, ModelChange&, const JobControl&)
{
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (!mesh.isVertex(v))
            continue;
        const Rgb before = mesh.color(v), after = mixed(before, command.color, mesh.freedom(v));
        if (after != before)
            mesh.setColor(v, after);
    }
}

void edit(Mesh& mesh, const MaskOperation& command, ModelChange&, const JobControl&)
{
    applyMaskOperation(mesh, command);
}

void edit(Mesh& mesh, const Reset& command, ModelChange&, const JobControl&)
{
    mesh.assign(*meshOf(*command.start));
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
    mesh->setUniformDetail(snapshot.frame.uniformDetail);
    mesh->endStroke();
    return mesh;
}

ModelChange applyToCopy(Mesh copy, const ModelCommand& command, const JobControl& control)
{
    ModelChange change;
    copy.beginStroke();
    std::visit([&](const auto& wanted) { edit(copy, wanted, change, control); }, command);
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
