#include "core/operations/model_command.h"

#include "core/mesh/mesh_builder.h"
#include "core/operations/detached_part.h"
#include "core/operations/flatten_base.h"
#include "core/operations/insert_model.h"
#include "core/operations/mask_operations.h"
#include "core/operations/part_operations.h"
#include "core/operations/snapshot.h"
#include "core/operations/symmetrize.h"
#include "core/operations/transform.h"
#include "core/operations/trim.h"
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

/// Applies a command to the whole mesh, whose stroke is open. `part`: the part that is moved, turned or mirrored;
/// nothing: all parts.
void edit(Mesh& mesh, const ModelCommand& command, std::optional<PartId> part, ModelChange& change,
          const JobControl& control)
{
    const Overloaded apply{
        [&](const Insert& insert) { insertModel(mesh, insert, change, control); },
        [&](const RemeshUniformly& remesh) { remeshUniformly(mesh, remesh, change, control); },
        [&](const Symmetrize& symmetrizing) { symmetrize(mesh, symmetrizing, change, control); },
        [&](const FlattenBase& flattening) { flattenBase(mesh, flattening, change, control); },
        [&](const Trim& trimming) { trim(mesh, trimming, change, control); },
        [&](const Fill& filling) { fill(mesh, filling.color); },
        [&](const MaskOperation& operation) { applyMaskOperation(mesh, operation); },
        [&](const Reset& reset) { mesh.assign(*meshOf(*reset.start)); },
        [&](const auto& other) {
            if constexpr (requires { transform(mesh, other, part, change, control); })
                transform(mesh, other, part, change, control);
            else if constexpr (requires { transform(mesh, other, change, control); })
                transform(mesh, other, change, control);
        },
    };
    std::visit(apply, command);
}

template <class... Commands> bool isAnyOf(const ModelCommand& command)
{
    return (std::holds_alternative<Commands>(command) || ...);
}

/// Returns whether the command adds, removes or regroups parts.
bool isOnParts(const ModelCommand& command)
{
    return isAnyOf<DuplicatePart, DeletePart, SeparatePart, CombineParts, SplitPart>(command);
}

/// Applies a command to one part of several.
void applyToPart(Mesh& mesh, const ModelCommand& command, PartId part, ModelChange& change, const JobControl& control)
{
    if (!hasFaces(mesh, part)) {
        change.refusal = ModelRefusal::NoSuchPart;
        return;
    }
    if (isAnyOf<Move, Rotate, Mirror, Transform>(command))
        return edit(mesh, command, part, change, control);
    DetachedPart detached(mesh, part);
    detached.mesh().beginStroke();
    edit(detached.mesh(), command, {}, change, control);
    detached.mesh().endStroke();
    if (change.refusal == ModelRefusal::None && !control.isCancelled())
        detached.putBack(mesh, change, control);
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

bool isOnAllParts(const ModelCommand& command)
{
    if (const auto* const hide = std::get_if<Hide>(&command))
        return hide->showsAll();
    if (const auto* const insert = std::get_if<Insert>(&command))
        return insert->combination == Insert::Combination::Part;
    return isAnyOf<Scale, Recentre, PlaceOnBed, Reset, ShowParts>(command);
}

bool isInFrame(const ModelCommand& command)
{
    return isAnyOf<EditPart, ShowParts>(command);
}

ModelChange applyInFrame(const Mesh& mesh, const ModelCommand& command, PartId part)
{
    ModelChange change;
    change.delta = {{}, {}, {}, mesh.slots(), mesh.meshHash(), mesh.frame()};
    change.refusal = editParts(change.delta.frame.parts, command, part);
    change.changes = change.refusal == ModelRefusal::None && change.delta.frame != mesh.frame();
    return change;
}

ModelChange applyToCopy(Mesh copy, const ModelCommand& command, const JobControl& control, std::optional<PartId> part)
{
    if (isInFrame(command))
        return applyInFrame(copy, command, part.value_or(copy.frame().parts.all().front().id));
    ModelChange change;
    if (part && !isOnAllParts(command))
        change.refusal = refusalOf(copy, *part);
    if (change.refusal != ModelRefusal::None)
        return change;
    copy.beginStroke();
    if (const auto* const hide = std::get_if<Hide>(&command))
        applyHide(copy, *hide, part);
    else if (const auto* const maskArea = std::get_if<MaskArea>(&command))
        applyMaskArea(copy, *maskArea, part, change);
    else if (const auto* const hideArea = std::get_if<HideArea>(&command))
        applyHideArea(copy, *hideArea, part, change);
    else if (isOnParts(command))
        applyToParts(copy, command, part, change, control);
    else if (part && copy.frame().parts.size() > 1 && !isOnAllParts(command))
        applyToPart(copy, command, *part, change, control);
    else
        edit(copy, command, {}, change, control);
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
