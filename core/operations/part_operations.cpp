#include "core/operations/part_operations.h"

#include "core/analysis/nesting.h"
#include "core/operations/detached_part.h"
#include "core/operations/trim.h"
#include "core/util/overloaded.h"

#include <algorithm>

namespace core
{
namespace
{
void setParts(Mesh& mesh, PartList parts)
{
    MeshFrame frame = mesh.frame();
    frame.parts = std::move(parts);
    mesh.setFrame(frame);
}

PartList shown(const PartList& list, const std::vector<PartId>& visible)
{
    std::vector<Part> parts = list.all();
    for (Part& part : parts)
        part.isVisible = std::ranges::find(visible, part.id) != visible.end();
    return PartList(std::move(parts));
}

PartList edited(const PartList& list, PartId id, const EditPart& edit)
{
    std::vector<Part> parts = list.all();
    const auto found = std::ranges::find(parts, id, &Part::id);
    Part part = *found;
    part.name = shortened(edit.name);
    part.isLocked = edit.isLocked;
    part.tag = edit.tag;
    const auto place = static_cast<std::size_t>(found - parts.begin());
    parts.erase(found);
    const std::size_t position = std::min(edit.position.value_or(place), parts.size());
    parts.insert(parts.begin() + static_cast<std::ptrdiff_t>(position), part);
    return PartList(std::move(parts));
}

/// Changes the parts of a mesh, whose stroke is open.
class PartOperations
{
public:
    PartOperations(Mesh& mesh, PartId part, ModelChange& change, const JobControl& control)
        : m_mesh(mesh)
        , m_part(part)
        , m_change(change)
        , m_control(control)
    {}

    void duplicate(const std::string& name);
    void remove();
    void separate();
    void combineWith(const CombineParts& command);
    void split(const SplitPart& command);

private:
    const PartList& list() const { return m_mesh.frame().parts; }
    void refuse(ModelRefusal refusal) { m_change.refusal = refusal; }

    Mesh& m_mesh;
    PartId m_part;
    ModelChange& m_change;
    const JobControl& m_control;
};

void PartOperations::duplicate(const std::string& name)
{
    if (list().size() == PartList::maxParts)
        return refuse(ModelRefusal::TooManyParts);
    Part copy = *list().find(m_part);
    copy.id = list().freeId();
    copy.name = list().freeName(name);
    std::vector<Part> parts = list().all();
    parts.insert(std::ranges::find(parts, m_part, &Part::id) + 1, copy);
    replacePart(m_mesh, copy.id, surfaceOf(m_mesh, m_part));
    setParts(m_mesh, PartList(std::move(parts)));
    m_change.addedPart = copy.id;
}

void PartOperations::remove()
{
    if (list().size() == 1)
        return refuse(ModelRefusal::LastPart);
    replacePart(m_mesh, m_part, {});
    setParts(m_mesh, list().without({m_part}));
}

void PartOperations::separate()
{
    const TriangleMesh surface = surfaceOf(m_mesh, m_part);
    const Components pieces = solidPiecesOf(surface.points, surface.triangles);
    if (pieces.count == 1)
        return refuse(ModelRefusal::OnePiece);
    if (list().size() + pieces.count - 1 > PartList::maxParts)
        return refuse(ModelRefusal::TooManyParts);
    std::vector<std::size_t> faces(pieces.count);
    for (const Slot piece : pieces.ofFace)
        ++faces[piece];
    const auto largest = static_cast<std::size_t>(std::ranges::max_element(faces) - faces.begin());

    PartList parts = list();
    std::vector<PartId> ids;
    for (std::size_t piece = 0; piece < pieces.count; ++piece) {
        Part own = *parts.find(m_part);
        if (piece != largest) {
            own.id = parts.freeId();
            own.name = own.name.empty() ? std::string() : shortened(own.name + ' ' + std::to_string(piece + 1));
        }
        ids.push_back(own.id);
        parts = parts.with(std::move(own));
    }
    std::vector<Slot> slots; // of the surface's vertices
    std::ranges::copy_if(m_mesh.vertices(), std::back_inserter(slots),
                         [&](Slot v) { return m_mesh.part(v) == m_part; });
    for (Slot f = 0; f < surface.triangles.size(); ++f) {
        for (const Slot v : surface.triangles[f]) {
            if (const PartId id = ids[pieces.ofFace[f]]; m_mesh.part(slots[v]) != id)
                m_mesh.setPart(slots[v], id);
        }
    }
    setParts(m_mesh, std::move(parts));
}

void PartOperations::combineWith(const CombineParts& command)
{
    std::vector<TriangleMesh> solids = {surfaceOf(m_mesh, m_part)};
    if (command.others.empty() || std::ranges::count(command.others, m_part) > 0)
        return refuse(ModelRefusal::NoOtherPart);
    for (const PartId other : command.others) {
        m_change.refusal = refusalOf(m_mesh, other);
        if (!hasFaces(m_mesh, other))
            refuse(ModelRefusal::NoSuchPart);
        if (m_change.refusal != ModelRefusal::None)
            return;
        solids.push_back(surfaceOf(m_mesh, other));
    }
    BooleanResult result = combineOn(m_mesh.lattice(), command.operation, solids, m_control);
    if (m_control.isCancelled())
        return;
    m_change.report = result.report;
    if (!result.mesh) {
        m_change.faces = result.report.intersections.count;
        return refuse(result.refusal == BooleanRefusal::LeavesNothing ? ModelRefusal::NothingLeft
                                                                      : ModelRefusal::FacesMeet);
    }
    const bool isUnchanged = result.mesh->points.size() == solids.front().points.size() &&
                             result.mesh->triangles.size() == solids.front().triangles.size();
    if (command.operation == SetOperation::Difference && isUnchanged)
        return refuse(ModelRefusal::PartsApart);
    if (!fitSurface(*result.mesh, m_mesh.lattice(), m_change, m_control))
        return;
    replacePart(m_mesh, m_part, *result.mesh);
    for (const PartId other : command.others)
        replacePart(m_mesh, other, {});
    setParts(m_mesh, list().without(command.others));
}

void PartOperations::split(const SplitPart& command)
{
    if (list().size() == PartList::maxParts)
        return refuse(ModelRefusal::TooManyParts);
    std::vector<Vec3f> hidden;
    for (const Slot v : m_mesh.vertices()) {
        if (m_mesh.part(v) == m_part && m_mesh.isHidden(v))
            hidden.push_back(m_mesh.point(v));
    }
    DetachedPart detached(m_mesh, m_part);
    detached.mesh().beginStroke();
    auto taken = core::split(detached.mesh(), {command.area, command.color}, m_change, m_control);
    detached.mesh().endStroke();
    if (!taken || m_change.refusal != ModelRefusal::None)
        return;
    Part added = *list().find(m_part);
    added.id = list().freeId();
    added.name = list().freeName(command.name);
    detached.putBack(m_mesh, m_change, m_control);
    if (m_change.refusal != ModelRefusal::None || !fitSurface(*taken, m_mesh.lattice(), m_change, m_control))
        return;
    replacePart(m_mesh, added.id, *taken);
    hideAt(m_mesh, added.id, hidden);
    std::vector<Part> parts = list().all();
    parts.insert(std::ranges::find(parts, m_part, &Part::id) + 1, added);
    setParts(m_mesh, PartList(std::move(parts)));
}
} // namespace

ModelRefusal editParts(PartList& parts, const ModelCommand& command, PartId part)
{
    if (const auto* const show = std::get_if<ShowParts>(&command))
        parts = shown(parts, show->visible);
    else if (!parts.find(part))
        return ModelRefusal::NoSuchPart;
    else if (const auto* const edit = std::get_if<EditPart>(&command))
        parts = edited(parts, part, *edit);
    return ModelRefusal::None;
}

ModelRefusal refusalOf(const Mesh& mesh, PartId part)
{
    const PartList& parts = mesh.frame().parts;
    if (!parts.find(part))
        return ModelRefusal::NoSuchPart;
    return parts.isEditable(part) ? ModelRefusal::None : ModelRefusal::NotEditable;
}

void applyToParts(Mesh& mesh, const ModelCommand& command, std::optional<PartId> part, ModelChange& change,
                  const JobControl& control)
{
    const PartId target = part.value_or(mesh.frame().parts.all().front().id);
    change.refusal = refusalOf(mesh, target);
    if (change.refusal == ModelRefusal::None && !std::holds_alternative<DeletePart>(command) && !hasFaces(mesh, target))
        change.refusal = ModelRefusal::NoSuchPart;
    if (change.refusal != ModelRefusal::None)
        return;
    PartOperations operations(mesh, target, change, control);
    const Overloaded apply{
        [&](const DuplicatePart& duplication) { operations.duplicate(duplication.name); },
        [&](const DeletePart&) { operations.remove(); },
        [&](const SeparatePart&) { operations.separate(); },
        [&](const CombineParts& combination) { operations.combineWith(combination); },
        [&](const SplitPart& splitting) { operations.split(splitting); },
        [](const auto&) {},
    };
    std::visit(apply, command);
}
} // namespace core
