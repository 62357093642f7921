#include "app/model/command_names.h"

#include "ui/util/error_messages.h"

#include <QFileInfo>
#include <QLocale>

namespace app
{
namespace
{
struct Names
{
    QString name, progress;
};

Names namesOf(const core::Move&)
{
    return {CommandNames::tr("Move", "undo step"), CommandNames::tr("Moving the model")};
}

Names namesOf(const core::Rotate&)
{
    return {CommandNames::tr("Rotate", "undo step"), CommandNames::tr("Rotating the model")};
}

Names namesOf(const core::Scale&)
{
    return {CommandNames::tr("Scale", "undo step"), CommandNames::tr("Scaling the model")};
}

Names namesOf(const core::Mirror&)
{
    return {CommandNames::tr("Mirror", "undo step"), CommandNames::tr("Mirroring the model")};
}

Names namesOf(const core::Recentre&)
{
    return {CommandNames::tr("Recentre", "undo step"), CommandNames::tr("Recentring the model")};
}

Names namesOf(const core::Insert&)
{
    return {CommandNames::tr("Insert", "undo step"), CommandNames::tr("Inserting a model")};
}

Names namesOf(const core::Fill&)
{
    return {CommandNames::tr("Fill", "undo step"), CommandNames::tr("Colouring the model")};
}

Names namesOf(const core::MaskOperation& change)
{
    using How = core::MaskOperation::Kind;
    const QString progress = CommandNames::tr("Changing the mask");
    switch (change.how) {
    case How::Invert:
        return {CommandNames::tr("Invert Mask", "undo step"), progress};
    case How::Clear:
        return {CommandNames::tr("Clear Mask", "undo step"), progress};
    case How::Blur:
        return {CommandNames::tr("Blur Mask", "undo step"), progress};
    case How::Sharpen:
        return {CommandNames::tr("Sharpen Mask", "undo step"), progress};
    case How::Grow:
        return {CommandNames::tr("Grow Mask", "undo step"), progress};
    case How::Shrink:
        return {CommandNames::tr("Shrink Mask", "undo step"), progress};
    case How::Cavity:
        return {CommandNames::tr("Mask Cavities", "undo step"), progress};
    case How::Color:
        return {CommandNames::tr("Mask by Colour", "undo step"), progress};
    case How::Part:
        return {CommandNames::tr("Mask Whole Parts", "undo step"), progress};
    }
    return {};
}

Names namesOf(const core::RemeshUniformly&)
{
    return {CommandNames::tr("Remesh", "undo step"), CommandNames::tr("Remeshing the model")};
}

Names namesOf(const core::Symmetrize&)
{
    return {CommandNames::tr("Symmetrize", "undo step"), CommandNames::tr("Making the model symmetric")};
}

Names namesOf(const core::Reset&)
{
    return {CommandNames::tr("Reset", "undo step"), CommandNames::tr("Going back to the start")};
}

Names namesOf(const core::PlaceOnBed&)
{
    return {CommandNames::tr("Place on Bed", "undo step"), CommandNames::tr("Placing the model on the bed")};
}

Names namesOf(const core::FlattenBase&)
{
    return {CommandNames::tr("Flatten Base", "undo step"), CommandNames::tr("Flattening the base")};
}
} // namespace

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
