#include "app/model/command_names.h"

#include "ui/util/error_messages.h"

#include <QFileInfo>
#include <QLocale>

namespace app
{
QString CommandNames::name(const core::ModelCommand& command)
{
    return std::visit([](const auto& each) { return namesOf(each).name; }, command);
}

QString CommandNames::icon(const core::ModelCommand& command)
{
    static const QString icons[] = {
        QStringLiteral("move"),   QStringLiteral("rotate"),       QStringLiteral("scale"),
        QStringLiteral("mirror"), QStringLiteral("recentre"),     QStringLiteral("insert"),
        QStringLiteral("fill"),   QStringLiteral("remesh"),       QStringLiteral("symmetrize"),
        QStringLiteral("reset"),  QStringLiteral("place-on-bed"), QStringLiteral("flatten-base"),
        QStringLiteral("mask")};
    static_assert(std::size(icons) == std::variant_size_v<core::ModelCommand>);
    return icons[command.index()];
}

QString CommandNames::progress(const core::ModelCommand& command)
{
    return std::visit([](const auto& each) { return namesOf(each).progress; }, command);
}

CommandNames::Names CommandNames::namesOf(const core::Move&)
{
    return {tr("Move", "undo step"), tr("Moving the model")};
}

CommandNames::Names CommandNames::namesOf(const core::Rotate&)
{
    return {tr("Rotate", "undo step"), tr("Rotating the model")};
}

CommandNames::Names CommandNames::namesOf(const core::Scale&)
{
    return {tr("Scale", "undo step"), tr("Scaling the model")};
}

CommandNames::Names CommandNames::namesOf(const core::Mirror&)
{
    return {tr("Mirror", "undo step"), tr("Mirroring the model")};
}

CommandNames::Names CommandNames::namesOf(const core::Recentre&)
{
    return {tr("Recentre", "undo step"), tr("Recentring the model")};
}

CommandNames::Names CommandNames::namesOf(const core::Insert&)
{
    return {tr("Insert", "undo step"), tr("Inserting a model")};
}

CommandNames::Names CommandNames::namesOf(const core::Fill&)
{
    return {tr("Fill", "undo step"), tr("Colouring the model")};
}

CommandNames::Names CommandNames::namesOf(const core::MaskOperation& change)
{
    using How = core::MaskOperation::Kind;
    const QString progress = tr("Changing the mask");
    switch (change.how) {
    case How::Invert:
        return {tr("Invert Mask", "undo step"), progress};
    case How::Clear:
        return {tr("Clear Mask", "undo step"), progress};
    case How::Blur:
        return {tr("Blur Mask", "undo step"), progress};
    case How::Sharpen:
        return {tr("Sharpen Mask", "undo step"), progress};
    case How::Grow:
        return {tr("Grow Mask", "undo step"), progress};
    case How::Shrink:
        return {tr("Shrink Mask", "undo step"), progress};
    case How::Cavity:
        return {tr("Mask Cavities", "undo step"), progress};
    case How::Color:
        return {tr("Mask by Colour", "undo step"), progress};
    case How::Part:
        return {tr("Mask Whole Parts", "undo step"), progress};
    }
    return {};
}

CommandNames::Names CommandNames::namesOf(const core::RemeshUniformly&)
{
    return {tr("Remesh", "undo step"), tr("Remeshing the model")};
}

CommandNames::Names CommandNames::namesOf(const core::Symmetrize&)
{
    return {tr("Symmetrize", "undo step"), tr("Making the model symmetric")};
}

CommandNames::Names CommandNames::namesOf(const core::Reset&)
{
    return {tr("Reset", "undo step"), tr("Going back to the start")};
}

CommandNames::Names CommandNames::namesOf(const core::PlaceOnBed&)
{
    return {tr("Place on Bed", "undo step"), tr("Placing the model on the bed")};
}

CommandNames::Names CommandNames::namesOf(const core::FlattenBase&)
{
    return {tr("Flatten Base", "undo step"), tr("Flattening the base")};
}

QString CommandNames::unchanged(const core::ModelCommand& command)
{
    if (std::holds_alternative<core::MaskOperation>(command))
        return tr("The mask is like that already.");
    return std::holds_alternative<core::RemeshUniformly>(command) ? tr("The mesh is as uniform as that already.")
                                                                  : tr("The model is like that already.");
}

QString CommandNames::refusal(const core::ModelChange& change, const QString& inserted)
{
    const QString faces = QLocale().toString(static_cast<qulonglong>(change.faces));
    const QString file = QFileInfo(inserted).fileName();
    switch (change.refusal) {
    case core::ModelRefusal::None:
        return {};
    case core::ModelRefusal::FacesMeet:
        return tr("The model stays as it is, because some of its faces would meet on the program's working grid "
                  "(faces: %1).")
            .arg(faces);
    case core::ModelRefusal::TooFar:
        return tr("The model stays as it is: nothing may lie farther from the origin than four times its size.");
    case core::ModelRefusal::TooLarge:
        return tr("The model stays as it is: it can be between a millionth of a millimetre and ten kilometres large.");
    case core::ModelRefusal::Unsound:
        return ui::ErrorMessages::refusal(inserted, change.report);
    case core::ModelRefusal::Inside:
        return tr("%1 was not inserted, because one model would lie inside the other; it has to be outside, or in a "
                  "void.")
            .arg(file);
    case core::ModelRefusal::Touching:
        return tr("%1 was not inserted, because there it would touch the model.").arg(file);
    case core::ModelRefusal::EmptyHalf:
        return tr("The model stays as it is, because nothing of it lies on the side that was to be kept.");
    case core::ModelRefusal::HalvesMeet:
        return tr("The model stays as it is, because the half and its mirror image would not make one sound surface.");
    case core::ModelRefusal::NoBase:
        return tr("The model stays as it is, because a cut at this height would not leave one sound surface; another "
                  "height may do.");
    case core::ModelRefusal::TooFine:
        return tr("The mesh stays as it is: with edges this short it would need too many triangles (%1).").arg(faces);
    }
    return {};
}
} // namespace app
