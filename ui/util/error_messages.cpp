#include "ui/util/error_messages.h"

#include "ui/util/file_fault_messages.h"
#include "ui/util/format_filters.h"
#include "ui/util/number_format.h"
#include "ui/util/path_display.h"

#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "core/print/print_check.h"

#include <QDir>
#include <QLocale>
#include <QStringList>

#include <cmath>
#include <limits>

namespace ui
{
namespace
{
using core::FileErrorKind;

QString nativePath(const std::filesystem::path& path)
{
    return QDir::toNativeSeparators(displayName(path));
}

QString bytes(std::uint64_t n)
{
    return QLocale().formattedDataSize(static_cast<qint64>(n));
}

QString systemReason(const core::FileError& error)
{
    return error.systemError == 0 ? QString() : QStringLiteral(" (%1)").arg(qt_error_string(error.systemError));
}

QString token(const core::FileError& error)
{
    return QString::fromLatin1(error.token);
}

/// Returns "STL" for a.stl, and also for its backup a.stl~1.
QString formatOf(const std::filesystem::path& path)
{
    return displayName(path.extension()).sliced(1).section(u'~', 0, 0).toUpper();
}

/// Returns the names in quotes and how many parts have others or none; only the number if there are no names.
QString namedParts(std::size_t count, const std::vector<std::string>& names)
{
    if (names.empty())
        return number(count);
    QStringList quoted;
    for (const std::string& name : names)
        quoted << ErrorMessages::tr("\"%1\"", "the name of a part").arg(QString::fromStdString(name));
    const QString list = quoted.join(ErrorMessages::tr(", ", "between the parts of a model that are left out"));
    const std::size_t more = count - names.size();
    return more == 0 ? list : ErrorMessages::tr("%1 and %2 more", "names of parts").arg(list, number(more));
}

/// Returns the kinds of content that were left out although other programs would show them.
QStringList leftOut(const core::ReadRemarks& remarks)
{
    QStringList left;
    if (remarks.beams > 0)
        left << ErrorMessages::tr("beams of a lattice (%1)").arg(number(remarks.beams));
    if (remarks.animations > 0)
        left << ErrorMessages::tr("animations (%1)").arg(number(remarks.animations));
    if (remarks.subdivisions > 0)
        left << ErrorMessages::tr("the subdivision of surfaces (%1)").arg(number(remarks.subdivisions));
    if (remarks.hiddenObjects > 0)
        left
            << ErrorMessages::tr("objects that are hidden or not in the scene (%1)").arg(number(remarks.hiddenObjects));
    if (remarks.unreadNodes > 0)
        left << ErrorMessages::tr("unsupported surfaces (%1)").arg(number(remarks.unreadNodes));
    return left;
}

/// Returns why the token is not the number expected at its place.
QString notThatNumber(const core::FileError& error, const QString& where)
{
    bool isNumber = false;
    const double value = QByteArray::fromStdString(error.token).toDouble(&isNumber);
    if (isNumber && std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()))
        return ErrorMessages::tr("%1: \"%2\" is not a whole number that is valid here.").arg(where, token(error));
    if (!error.token.empty())
        return ErrorMessages::tr("%1: \"%2\" is not a finite number.").arg(where, token(error));
    return error.place.unit == core::FilePlace::Unit::Line
               ? ErrorMessages::tr("%1: a number is missing here, or is not finite.").arg(where)
               : ErrorMessages::tr("%1: a coordinate is not a finite number.").arg(where);
}
} // namespace

QString ErrorMessages::sentence(const core::FileError& error)
{
    for (const QString& words : {reading(error), content(error), writing(error)})
        if (!words.isEmpty())
            return words;
    return tr("%1 cannot be used.").arg(nativePath(error.path));
}

QString ErrorMessages::faults(const core::MeshReport& report)
{
    QStringList faults;
    const auto add = [&faults](std::uint64_t count, const QString& fault) {
        if (count > 0)
            faults << fault.arg(number(count));
    };
    add(report.openEdges.count, tr("open edges: %1"));
    add(report.nonManifoldEdges.count, tr("edges of more than two faces: %1"));
    add(report.nonManifoldVertices.count, tr("points at which parts merely touch: %1"));
    add(report.misorientedEdges.count, tr("edges between faces that face different ways: %1"));
    add(report.degenerateFaces.count, tr("faces without area: %1"));
    add(report.intersections.count, tr("pairs of faces that intersect: %1"));
    if (faults.isEmpty())
        faults << tr("it is inside out, or its shells are wrongly nested");
    return faults.join(tr(", ", "between the faults of a model"));
}

QString ErrorMessages::refusal(const QString& file, const core::MeshReport& report)
{
    return tr("%1 cannot be sculpted yet, because its surface does not bound a solid (%2).").arg(file, faults(report));
}

QString ErrorMessages::brushRefusal(const QString& file, const core::MeshReport& report)
{
    return tr("%1 cannot be a brush's shape, because its surface does not bound a solid (%2).")
        .arg(file, faults(report));
}

QString ErrorMessages::unitDoubt(double volume)
{
    const QString size = QLocale().toString(std::abs(volume), 'g', 2);
    switch (core::unitDoubtOf(volume)) {
    case core::UnitDoubt::Inches:
        return tr("The model has only %1 mm³: slicers may read it as inches.").arg(size);
    case core::UnitDoubt::Metres:
        return tr("The model has only %1 mm³: slicers may read it as metres.").arg(size);
    case core::UnitDoubt::None:
        break;
    }
    return {};
}

QString ErrorMessages::tooFine(const QString& file, quint64 faces)
{
    return tr("%1 cannot be sculpted yet, because some of its faces would intersect after rounding to the program's "
              "grid (faces: %2).")
        .arg(file, number(faces));
}

QString ErrorMessages::tooLarge(const QString& file)
{
    return tr("%1: at that size the coordinates overflow.").arg(file);
}

QString ErrorMessages::remarks(const QString& file, const core::ReadRemarks& remarks)
{
    QStringList left, clauses;
    if (remarks.materials)
        left << tr("materials");
    if (remarks.textures)
        left << tr("textures");
    if (remarks.poses)
        left << tr("poses");
    if (remarks.repeatedCorners > 0)
        left << tr("corners that faces name twice (%1)").arg(number(remarks.repeatedCorners));
    if (remarks.facesOfFewer > 0)
        left << tr("faces without three different corners (%1)").arg(number(remarks.facesOfFewer));
    if (remarks.unannounced)
        left << tr("values that its header does not announce");
    if (remarks.bytesBehind > 0)
        left << tr("data after the end of the model (%1)").arg(bytes(remarks.bytesBehind));
    if (remarks.negativeParts > 0)
        left << tr("parts that a slicer would cut out of the model (%1)")
                    .arg(namedParts(remarks.negativeParts, remarks.negativeNames));
    if (remarks.otherParts > 0)
        left << tr("modifiers and supports of a slicer (%1)").arg(namedParts(remarks.otherParts, remarks.otherNames));
    if (remarks.otherModels > 0)
        left << tr("further models in its package (%1)").arg(number(remarks.otherModels));
    if (remarks.curves)
        left << tr("the curvature of edges and triangles");
    left << leftOut(remarks);
    if (!left.isEmpty())
        clauses << tr("left out: %1", "materials, textures")
                       .arg(left.join(tr(", ", "between the parts of a model that are left out")));
    if (remarks.announcedTriangles)
        clauses << tr("it announces %1 triangles and contains %2")
                       .arg(number(*remarks.announcedTriangles), number(remarks.containedTriangles));
    if (remarks.objects > 1)
        clauses << tr("%n objects are one model now", nullptr, static_cast<int>(remarks.objects));
    return clauses.isEmpty() ? QString() : QStringLiteral("%1: %2.").arg(file, clauses.join(QStringLiteral("; ")));
}

QString ErrorMessages::shortfall(core::Shortfall shortfall)
{
    const QString sentences[] = {
        QString(),
        tr("Nothing happened here: the surface would have intersected itself."),
        tr("The brush stopped: surfaces touch, and they may not join here."),
        tr("The brush stopped at the edge of the workspace."),
        tr("The brush is too large for this much detail. Continue with another stroke."),
        tr("Nothing was added, because it would be inside the model."),
        tr("Nothing was added, because it would be too close to the surface."),
        tr("Nothing was added, because it would reach beyond the workspace."),
        tr("Nothing was added, because the brush's shape would intersect itself at that size."),
        tr("Nothing was added, because the mask protects the surface there.")};
    static_assert(std::size(sentences) == static_cast<std::size_t>(core::Shortfall::Masked) + 1);
    return sentences[static_cast<std::size_t>(shortfall)];
}

QString ErrorMessages::asymmetric()
{
    return tr("The model is not symmetric here: both sides were changed, but they are not exact mirror images.");
}

QString ErrorMessages::sequentialSectors()
{
    return tr("The sectors meet here, or the model differs between them: they were changed one after the other and are "
              "not exact copies.");
}

QString ErrorMessages::notADrawing(const QString& path)
{
    return tr("%1: drawings are written as PDF, SVG or PNG; the file extension decides which.")
        .arg(QDir::toNativeSeparators(path));
}

QString ErrorMessages::notAReport(const QString& path)
{
    return tr("%1: class reports are written as HTML or PDF; the file extension decides which.")
        .arg(QDir::toNativeSeparators(path));
}

QString ErrorMessages::notABook(const QString& path)
{
    return tr("%1: sheets are written as one PDF; the name has to end in .pdf.").arg(QDir::toNativeSeparators(path));
}

QString ErrorMessages::notAPicture(const QString& path)
{
    return tr("%1 contains no image that can be read.").arg(QDir::toNativeSeparators(path));
}

QString ErrorMessages::missingReference(const QString& path)
{
    return tr("The reference image %1 no longer exists.").arg(QDir::toNativeSeparators(path));
}

QString ErrorMessages::name(core::Parameter parameter)
{
    const QString names[] = {tr("Radius"), tr("Strength"), tr("Falloff"), tr("Detail"), tr("Spacing")};
    static_assert(std::size(names) == static_cast<std::size_t>(core::Parameter::Spacing) + 1);
    return names[static_cast<std::size_t>(parameter)];
}

QString ErrorMessages::range(core::Parameter parameter, double min, double max)
{
    const auto figure = [](double value) { return QLocale().toString(value, 'g', 3); };
    const bool isLength = core::info(parameter).unit == core::Unit::Millimetres;
    return (isLength ? tr("%1: from %2 to %3 mm with this model.") : tr("%1: from %2 to %3."))
        .arg(name(parameter), figure(min), figure(max));
}

/// Returns the message for a problem found before the file's content is parsed, else an empty text.
QString ErrorMessages::reading(const core::FileError& error)
{
    const QString path = nativePath(error.path);
    switch (error.kind) {
    case FileErrorKind::NotFound:
        return tr("%1: there is no such file or folder.").arg(path);
    case FileErrorKind::NotReadable:
        return tr("%1 cannot be read%2.").arg(path, systemReason(error));
    case FileErrorKind::NotAFile:
        return tr("%1 is not a file but a folder or a device.").arg(path);
    case FileErrorKind::FolderNotReadable:
        return tr("%1: this folder cannot be read%2.").arg(path, systemReason(error));
    case FileErrorKind::NoModel:
        return tr("%1: this folder contains no models (%2).").arg(path, modelFormats());
    case FileErrorKind::Empty:
        return tr("%1 is empty.").arg(path);
    case FileErrorKind::TooLarge:
        return tr("%1 is too large: it has %2, and at most %3 are read.")
            .arg(path, bytes(error.found), bytes(error.expected));
    case FileErrorKind::UnknownFormat:
        if (error.token == "blend")
            return tr("%1 is Blender's own file, which only Blender reads as it is: save it as GLB there.").arg(path);
        if (error.token == "ogex")
            return tr("%1 is OpenGEX, which is not read: save it as GLB.").arg(path);
        if (error.token.starts_with("x3d") || error.token == "wrl")
            return tr("%1 is X3D in its binary, packed or VRML encoding, which is not read: save it as XML (.x3d) or "
                      "GLB.")
                .arg(path);
        return error.token.empty()
                   ? tr("%1 has no known file extension: use one of %2.").arg(path, modelFormats())
                   : tr("%1: the format \"%2\" is not known; %3 can be used.").arg(path, token(error), modelFormats());
    case FileErrorKind::NotWhatItsEndingSays:
        return error.token.empty() ? tr("%1 is not a valid %2 file.").arg(path, formatOf(error.path))
                                   : tr("%1 is not a valid %2 file; it looks like %3.")
                                         .arg(path, formatOf(error.path),
                                              error.token == "text" ? tr("plain text") : token(error).toUpper());
    case FileErrorKind::Utf16:
        return tr("%1 is text in UTF-16, which is not read: save it as UTF-8.").arg(path);
    default:
        return {};
    }
}

QString ErrorMessages::content(const core::FileError& error)
{
    const QString where = nativePath(error.path) + at(error);
    switch (error.kind) {
    case FileErrorKind::CutOff:
        if (error.token == "vertices")
            return tr("%1: the file is incomplete; %2 vertices are announced, but it has room for %3.")
                .arg(where, number(error.expected), number(error.found));
        if (error.token == "faces")
            return tr("%1: the file is incomplete; %2 faces are announced, but it has room for %3.")
                .arg(where, number(error.expected), number(error.found));
        return error.expected == 0 ? tr("%1: the file is incomplete; it ends here.").arg(where)
                                   : tr("%1: the file is incomplete; %2 are expected, but it has %3.")
                                         .arg(where, bytes(error.expected), bytes(error.found));
    case FileErrorKind::CountMismatch:
        if (error.token == "faces")
            return tr("%1: %2 faces are announced, but the file has %3.")
                .arg(where, number(error.expected), number(error.found));
        return tr("%1: %2 elements are announced, but the file has room for %3.")
            .arg(where, number(error.expected), number(error.found));
    case FileErrorKind::Malformed:
        return FileFaultMessages::sentence(error, where);
    case FileErrorKind::NotANumber:
        return notThatNumber(error, where);
    case FileErrorKind::IndexOutOfRange:
        return tr("%1: a face refers to vertex %2, but there are only %3 vertices.")
            .arg(where, token(error), number(error.expected));
    case FileErrorKind::OutsideFolder:
        return tr("%1 refers to \"%2\", which is not in its folder; files elsewhere are not read.")
            .arg(where, token(error));
    case FileErrorKind::UnpacksTooLarge:
        return tr("%1 was not read: unpacked it is larger than %2, which is too much for a file of its size.")
            .arg(where, bytes(error.expected));
    case FileErrorKind::TooManyElements:
        return tr("%1: too many %2; at most %3 are allowed.").arg(where, token(error), number(error.expected));
    case FileErrorKind::ReaderRefused:
        return error.token.empty() ? tr("%1 breaks the rules of the format %2; the importer does not say where.")
                                         .arg(where, formatOf(error.path))
                                   : tr("%1 cannot be read; the importer says: \"%2\".").arg(where, token(error));
    case FileErrorKind::ReaderDied:
        return tr("%1 was not read: the process that reads it ended unexpectedly.").arg(where);
    case FileErrorKind::ReaderTooSlow:
        return tr("%1 was not read: it took longer than the limit of %2 seconds for a file of its size.")
            .arg(where, number(error.expected));
    case FileErrorKind::ReaderOutOfMemory:
        return tr("%1 was not read: it needs more memory than the limit of %2 for a file of its size.")
            .arg(where, bytes(error.expected));
    case FileErrorKind::NoFaces:
        return error.expected == 0 ? tr("%1 contains no faces.").arg(where)
                                   : tr("%1 contains no faces, except those of slicer parts that are not printed (%2): "
                                        "negative volumes, modifiers and supports, which are left out.")
                                         .arg(where, number(error.expected));
    default:
        return {};
    }
}

QString ErrorMessages::writing(const core::FileError& error)
{
    const QString path = nativePath(error.path), reason = systemReason(error);
    switch (error.kind) {
    case FileErrorKind::NotWritten:
        return tr("%1 was not written: %2 is only read; %3 can be written.")
            .arg(path, token(error).toUpper(), writtenFormats());
    case FileErrorKind::TooFar:
        return tr("%1 was not written: so far from the origin its coordinates are too coarse for the model's detail. "
                  "Recentre the model.")
            .arg(path);
    case FileErrorKind::NoFolder:
        return tr("%1 cannot be written: the folder %2 does not exist.")
            .arg(path, nativePath(error.path.parent_path()));
    case FileErrorKind::NotWritable:
        return tr("%1 cannot be written: it is not allowed%2.").arg(path, reason);
    case FileErrorKind::DiskFull:
        return tr("%1 was not written: the disk is full.").arg(path);
    case FileErrorKind::WriteFailed:
        return tr("%1 was not written%2.").arg(path, reason);
    default:
        return {};
    }
}

QString ErrorMessages::at(const core::FileError& error)
{
    switch (error.place.unit) {
    case core::FilePlace::Unit::None:
        return {};
    case core::FilePlace::Unit::Line:
        return tr(", line %1").arg(number(error.place.number));
    case core::FilePlace::Unit::Byte:
        return tr(", byte %1").arg(number(error.place.number));
    }
    return {};
}
} // namespace ui
