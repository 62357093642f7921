#include "vr/sculpt/part_requests.h"

#include "vr/sculpt/shape_tool.h"

#include "core/operations/plane_cut.h"
#include "core/util/overloaded.h"

namespace vr
{
namespace
{
/// Returns the command after which a part is shown, or is hidden, and all others are as before.
core::ShowParts shown(const PartsPanel& panel, const ShowPart& change)
{
    core::ShowParts show;
    for (const PartRow& row : panel.parts)
        if (row.part.id == change.part ? change.isShown : row.part.isVisible)
            show.visible.push_back(row.part.id);
    return show;
}

/// Returns the request after which a part's name, lock and tag are as `edit` makes them; none if the part is gone or
/// nothing changes.
template <class Edit>
std::optional<DocumentRequest> edited(const PartsPanel& panel, core::PartId part, const Edit& edit)
{
    const PartRow* row = panel.find(part);
    if (!row)
        return std::nullopt;
    core::Part changed = row->part;
    edit(changed);
    if (changed == row->part)
        return std::nullopt;
    const auto position = static_cast<std::size_t>(row - panel.parts.data());
    return ChangePart{part, core::EditPart{changed.name, changed.isLocked, changed.tag, position}};
}

/// Names the active part. If another part has the name, a number is appended.
std::optional<DocumentRequest> named(const PartsPanel& panel, const QString& name)
{
    if (!panel.find(panel.active))
        return std::nullopt;
    std::vector<core::Part> others;
    for (const PartRow& row : panel.parts) {
        others.push_back(row.part);
        if (row.part.id == panel.active)
            others.back().name.clear();
    }
    return edited(panel, panel.active, [&](core::Part& part) {
        part.name = core::PartList(std::move(others)).freeName(name.toStdString());
    });
}

std::optional<DocumentRequest> requestOf(const PartsPanel& panel, PanelCommand command)
{
    switch (command) {
    case PanelCommand::IsolatePart:
        return IsolatePart{};
    case PanelCommand::ShowAllParts:
        return ChangePart{panel.active, core::Hide{core::Hide::What::NoPart}};
    case PanelCommand::DuplicatePart:
        return ChangePart{panel.active, core::DuplicatePart{panel.nameOfCopy().toStdString()}};
    case PanelCommand::DeletePart:
        return ChangePart{panel.active, core::DeletePart{}};
    case PanelCommand::ApplyPreview:
        return EndPreview{true};
    case PanelCommand::CancelPreview:
        return EndPreview{false};
    default:
        return std::nullopt;
    }
}

/// Joins the shape with the active part, or makes it a part of its own with its name, as the panel says.
DocumentRequest inserted(const PartsPanel& panel, core::Insert shape)
{
    shape.combination = panel.makesPart ? core::Insert::Combination::Part : core::Insert::Combination::Join;
    if (panel.makesPart)
        shape.name = PartsPanel::nameOf(shape.primitive->kind).toStdString();
    return ChangePart{panel.active, std::move(shape)};
}
} // namespace

std::optional<DocumentRequest> requestOf(const PartsPanel& panel, const PanelAction& action)
{
    using Request = std::optional<DocumentRequest>;
    const core::Overloaded request{
        [&](PanelCommand command) { return requestOf(panel, command); },
        [](const ChoosePart& chosen) { return Request(ActivatePart{chosen.part}); },
        [&](const ShowPart& change) {
            return Request(ChangePart{change.part, shown(panel, change)});
        },
        [&](const LockPart& change) {
            return edited(panel, change.part, [&](core::Part& part) { part.isLocked = change.isLocked; });
        },
        [&](const NamePart& chosen) { return named(panel, chosen.name); },
        [&](const TagPart& chosen) {
            return edited(panel, panel.active, [&](core::Part& part) { part.tag = chosen.tag; });
        },
        [&](const CombineMarked& chosen) {
            if (panel.preview)
                return Request(PreviewInstead{chosen.operation});
            return Request(PreviewParts{panel.active, core::CombineParts{chosen.operation, panel.others()}});
        },
        [](const auto&) { return Request(); },
    };
    return std::visit(request, action);
}

DocumentRequest tubeRequest(const core::Primitive& tube, const PartsPanel& panel, const BrushState& brush)
{
    core::Insert insert;
    insert.place = core::Insert::Place::AsItIs;
    insert.primitive = tube;
    insert.symmetry = brush.stroke.symmetry;
    return inserted(panel, std::move(insert));
}

DocumentRequest requestAt(const TipUse& use, const PartsPanel& panel, const BrushState& brush,
                          const ModelPlacement& placement)
{
    const core::Vec3 forward = placement.directionToModel(use.tip.forward());
    if (use.task == HandTask::PlaceShape)
        return inserted(panel, shapeAt(panel.shape, use.tip, brush, placement));
    if (use.task == HandTask::Cut) {
        const core::Trim cut =
            core::trimBeyond(placement.toModel(use.tip.position), forward, use.box, brush.stroke.symmetry);
        return ChangePart{panel.active, panel.makesPart ? core::ModelCommand(core::SplitPart{cut.area, {}})
                                                        : core::ModelCommand(cut)};
    }
    return PickPart{{placement.toModel(use.tip.position - tipReach * use.tip.forward()), forward}};
}

core::Symmetry imageOfCut(const TipUse& use, const BrushState& brush, const ModelPlacement& placement)
{
    const core::Symmetry symmetry = brush.stroke.symmetry;
    const core::MirroredPlane image = core::mirroredPlane(
        placement.toModel(use.tip.position), placement.directionToModel(use.tip.forward()), use.box, symmetry);
    return image == core::MirroredPlane::Other ? symmetry : core::Symmetry::None;
}
} // namespace vr
