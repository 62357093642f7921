#include "app/model/command_names.h"

#include "ui/model/primitive_messages.h"
#include "ui/util/error_messages.h"

#include <QFileInfo>
#include <QLocale>

namespace app
{
namespace
{
struct Names
{
    QString name, progress, icon; ///< `icon`: file name in resources/icons
};

QString nameOf(const core::MaskOperation& change)
{
    const QString names[] = {
        CommandNames::tr("Invert Mask", "undo step"),      CommandNames::tr("Clear Mask", "undo step"),
        CommandNames::tr("Blur Mask", "undo step"),        CommandNames::tr("Sharpen Mask", "undo step"),
        CommandNames::tr("Grow Mask", "undo step"),        CommandNames::tr("Shrink Mask", "undo step"),
        CommandNames::tr("Mask Cavities", "undo step"),    CommandNames::tr("Mask by Colour", "undo step"),
        CommandNames::tr("Mask Whole Pieces", "undo step")};
    static_assert(std::size(names) == static_cast<std::size_t>(core::MaskOperation::Kind::Part) + 1);
    return names[static_cast<std::size_t>(change.how)];
}

Names namesOf(const core::CombineParts& combination)
{
    switch (combination.operation) {
    case core::SetOperation::Union:
        return {CommandNames::tr("Join", "undo step"), CommandNames::tr("Joining the parts"),
                QStringLiteral("part-union")};
    case core::SetOperation::Difference:
        return {CommandNames::tr("Subtract", "undo step"), CommandNames::tr("Subtracting the parts"),
                QStringLiteral("part-subtract")};
    case core::SetOperation::Intersection:
        break;
    }
    return {CommandNames::tr("Intersect", "undo step"), CommandNames::tr("Intersecting the parts"),
            QStringLiteral("part-intersect")};
}

/// Names the change after what it does most visibly: a turn or a scaling about a centre may also move.
Names namesOf(const core::Transform& transform)
{
    if (transform.scale != core::Vec3::Ones())
        return {CommandNames::tr("Scale", "undo step"), CommandNames::tr("Scaling the model"), QStringLiteral("scale")};
    if (transform.rotation != Eigen::Quaterniond::Identity())
        return {CommandNames::tr("Rotate", "undo step"), CommandNames::tr("Rotating the model"),
                QStringLiteral("rotate")};
    return {CommandNames::tr("Move", "undo step"), CommandNames::tr("Moving the model"), QStringLiteral("move")};
}

QString nameOf(const core::Insert& insertion)
{
    switch (insertion.combination) {
    case core::Insert::Combination::Apart:
    case core::Insert::Combination::Part:
        break;
    case core::Insert::Combination::Join:
        return CommandNames::tr("Join", "undo step");
    case core::Insert::Combination::Subtract:
        return CommandNames::tr("Subtract", "undo step");
    case core::Insert::Combination::Intersect:
        return CommandNames::tr("Intersect", "undo step");
    }
    return CommandNames::tr("Insert", "undo step");
}

Names namesOf(const core::ModelCommand& command)
{
    const auto* hide = std::get_if<core::Hide>(&command);
    const auto* combination = std::get_if<core::CombineParts>(&command);
    const auto* insertion = std::get_if<core::Insert>(&command);
    const auto* mask = std::get_if<core::MaskOperation>(&command);
    const auto* transform = std::get_if<core::Transform>(&command);
    const auto* maskArea = std::get_if<core::MaskArea>(&command);
    const Names names[] = {
        {CommandNames::tr("Move", "undo step"), CommandNames::tr("Moving the model"), QStringLiteral("move")},
        {CommandNames::tr("Rotate", "undo step"), CommandNames::tr("Rotating the model"), QStringLiteral("rotate")},
        {CommandNames::tr("Scale", "undo step"), CommandNames::tr("Scaling the model"), QStringLiteral("scale")},
        {CommandNames::tr("Mirror", "undo step"), CommandNames::tr("Mirroring the model"), QStringLiteral("mirror")},
        {CommandNames::tr("Recentre", "undo step"), CommandNames::tr("Recentring the model"),
         QStringLiteral("recentre")},
        {insertion ? nameOf(*insertion) : QString(), CommandNames::tr("Inserting a model"),
         insertion && insertion->primitive ? QStringLiteral("primitive") : QStringLiteral("insert")},
        {CommandNames::tr("Fill", "undo step"), CommandNames::tr("Colouring the model"), QStringLiteral("fill")},
        {CommandNames::tr("Remesh", "undo step"), CommandNames::tr("Remeshing the model"), QStringLiteral("remesh")},
        {CommandNames::tr("Symmetrize", "undo step"), CommandNames::tr("Making the model symmetric"),
         QStringLiteral("symmetrize")},
        {CommandNames::tr("Reset", "undo step"), CommandNames::tr("Going back to the start"), QStringLiteral("reset")},
        {CommandNames::tr("Place on Bed", "undo step"), CommandNames::tr("Placing the model on the bed"),
         QStringLiteral("place-on-bed")},
        {CommandNames::tr("Flatten Base", "undo step"), CommandNames::tr("Flattening the base"),
         QStringLiteral("flatten-base")},
        {mask ? nameOf(*mask) : QString(), CommandNames::tr("Changing the mask"), QStringLiteral("mask")},
        {CommandNames::tr("Edit Part", "undo step"), CommandNames::tr("Changing the list of parts"),
         QStringLiteral("rename")},
        {CommandNames::tr("Show or Hide Parts", "undo step"), CommandNames::tr("Changing the list of parts"),
         QStringLiteral("part-shown")},
        {CommandNames::tr("Duplicate", "undo step"), CommandNames::tr("Duplicating the part"),
         QStringLiteral("duplicate")},
        {CommandNames::tr("Delete", "undo step"), CommandNames::tr("Deleting the part"), QStringLiteral("trash")},
        {CommandNames::tr("Separate", "undo step"), CommandNames::tr("Separating the part"),
         QStringLiteral("part-separate")},
        combination ? namesOf(*combination) : Names(),
        {hide && hide->showsAll() ? CommandNames::tr("Show All", "undo step") : CommandNames::tr("Hide", "undo step"),
         CommandNames::tr("Hiding and showing"), QStringLiteral("part-hidden")},
        {CommandNames::tr("Trim", "undo step"), CommandNames::tr("Trimming the model"), QStringLiteral("area-trim")},
        {maskArea && maskArea->isErasing ? CommandNames::tr("Unmask Area", "undo step")
                                         : CommandNames::tr("Mask Area", "undo step"),
         CommandNames::tr("Changing the mask"), QStringLiteral("mask")},
        {CommandNames::tr("Hide Area", "undo step"), CommandNames::tr("Hiding and showing"),
         QStringLiteral("part-hidden")},
        {CommandNames::tr("Split Off", "undo step"), CommandNames::tr("Splitting the part"),
         QStringLiteral("area-split")},
        transform ? namesOf(*transform) : Names()};
    static_assert(std::size(names) == std::variant_size_v<core::ModelCommand>);
    return names[command.index()];
}
/// Returns the sentence for a refusal that concerns parts.
QString refusalOfParts(core::ModelRefusal refusal)
{
    switch (refusal) {
    case core::ModelRefusal::NoSuchPart:
        return CommandNames::tr("The model stays as it is: it has no such part, or the part is empty.");
    case core::ModelRefusal::NotEditable:
        return CommandNames::tr(
            "The model stays as it is, because a part is hidden or locked. Show and unlock it first.");
    case core::ModelRefusal::LastPart:
        return CommandNames::tr("The last part cannot be deleted.");
    case core::ModelRefusal::OnePiece:
        return CommandNames::tr("The part is in one piece already, so nothing was separated.");
    case core::ModelRefusal::TooManyParts:
        return CommandNames::tr("The model stays as it is: it may have %Ln parts at most.", nullptr,
                                static_cast<int>(core::PartList::maxParts));
    case core::ModelRefusal::AllMasked:
        return CommandNames::tr("The part stays as it is, because all of it is masked or hidden.");
    case core::ModelRefusal::NoOtherPart:
        return CommandNames::tr("A part can only be combined with others. Choose at least one more.");
    case core::ModelRefusal::PartsApart:
        return CommandNames::tr("The parts do not overlap, so nothing was subtracted.");
    default:
        return {};
    }
}
} // namespace

QString CommandNames::name(const core::ModelCommand& command)
{
    return namesOf(command).name;
}

QString CommandNames::switching(bool shows)
{
    return shows ? tr("Show", "undo step") : tr("Hide", "undo step");
}

QString CommandNames::icon(const core::ModelCommand& command)
{
    return namesOf(command).icon;
}

QString CommandNames::progress(const core::ModelCommand& command)
{
    return namesOf(command).progress;
}

QString CommandNames::unchanged(const core::ModelCommand& command)
{
    if (const QString cut = shortening(command); !cut.isEmpty())
        return cut;
    if (std::holds_alternative<core::MaskOperation>(command))
        return tr("The mask is like that already.");
    if (const auto* const hide = std::get_if<core::Hide>(&command))
        return hide->showsAll() ? tr("Nothing is hidden.") : tr("Nothing is masked, so nothing was hidden.");
    if (const auto* const maskArea = std::get_if<core::MaskArea>(&command))
        return maskArea->isErasing
                   ? tr("Nothing is masked in the area.")
                   : tr("Nothing was masked: none of the model is in the area, or it is masked already.");
    if (std::holds_alternative<core::HideArea>(command))
        return tr("Nothing was hidden: none of the model is in the area.");
    if (std::holds_alternative<core::SplitPart>(command))
        return tr("Nothing was split off: all of the part is on one side of the cut.");
    if (std::holds_alternative<core::Trim>(command))
        return tr("Nothing was cut away: none of the model is on that side of the cut.");
    if (const auto* insertion = std::get_if<core::Insert>(&command);
        insertion && insertion->combination == core::Insert::Combination::Subtract)
        return tr("There is nothing to subtract: the models do not overlap.");
    return std::holds_alternative<core::RemeshUniformly>(command) ? tr("The mesh is as uniform as that already.")
                                                                  : tr("The model is like that already.");
}

QString CommandNames::shortening(const core::ModelCommand& command)
{
    const auto* const edit = std::get_if<core::EditPart>(&command);
    return edit && core::shortened(edit->name) != edit->name ? tr("The name was too long, so its end was cut off.")
                                                             : QString();
}

QString CommandNames::problem(const core::PrimitiveResult& primitive)
{
    return ui::PrimitiveMessages::problem(primitive);
}

QString CommandNames::refusal(const core::ModelChange& change, const QString& inserted)
{
    const QString faces = QLocale().toString(static_cast<qulonglong>(change.faces));
    const QString file = inserted.isEmpty() ? tr("The shape") : QFileInfo(inserted).fileName();
    switch (change.refusal) {
    case core::ModelRefusal::None:
        return {};
    case core::ModelRefusal::FacesMeet:
        return tr("The model stays as it is, because some of its faces would intersect after rounding to the program's "
                  "grid (faces: %1).")
            .arg(faces);
    case core::ModelRefusal::Folded:
        return tr("The model stays as it is, because its surface would pass through itself (faces: %1). Turn or "
                  "move it less, or blur the mask.")
            .arg(faces);
    case core::ModelRefusal::TooFar:
        return tr("The model stays as it is: nothing may be farther from the origin than four times its size.");
    case core::ModelRefusal::TooLarge:
        return tr("The model stays as it is: its size must be between a millionth of a millimetre and ten kilometres.");
    case core::ModelRefusal::Unsound:
        return ui::ErrorMessages::refusal(inserted, change.report);
    case core::ModelRefusal::Inside:
        return tr("%1 was not inserted, because one model would be inside the other. It must be outside, or in a "
                  "hollow.")
            .arg(file);
    case core::ModelRefusal::Touching:
        return tr("%1 was not inserted, because there it would touch the model.").arg(file);
    case core::ModelRefusal::NothingLeft:
        return tr("The model stays as it is, because nothing of it would be left.");
    case core::ModelRefusal::Uncut:
        return tr("The model stays as it is, because the surfaces nearly coincide and no sound cut was found; another "
                  "place may do.");
    case core::ModelRefusal::Primitive:
        return problem(change.primitive);
    case core::ModelRefusal::EmptyHalf:
        return tr("The model stays as it is, because no part of it is on the side to keep.");
    case core::ModelRefusal::HalvesMeet:
        return tr("The model stays as it is, because the half and its mirror image would not make one sound surface.");
    case core::ModelRefusal::NoBase:
        return tr("The model stays as it is, because a cut at this height would not leave one sound surface; another "
                  "height may do.");
    case core::ModelRefusal::TooFine:
        return tr("The mesh stays as it is: with edges this short it would need too many triangles (%1).").arg(faces);
    case core::ModelRefusal::NoOutline:
        return tr("The model stays as it is, because the curve does not go around an area.");
    case core::ModelRefusal::NoCut:
        return tr(
            "The model stays as it is, because the cut would not leave one sound surface; a cut elsewhere may do.");
    default:
        return refusalOfParts(change.refusal);
    }
}
} // namespace app
