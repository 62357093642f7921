#include "ui/brush/brush_files.h"

#include "ui/util/error_messages.h"

#include "core/io/mesh_io.h"
#include "core/util/file_error.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QLocale>

#include <algorithm>
#include <new>

namespace ui
{
namespace
{
struct BrushFiles
{
    Q_DECLARE_TR_FUNCTIONS(ui::BrushFiles)
};

template <class What> BrushFile<What> refused(const QString& sentence)
{
    return {nullptr, sentence};
}

/// Returns shadeOf(pixel) of each premultiplied pixel, row by row without padding.
template <class Shade> std::vector<std::uint8_t> shadesOf(const QImage& image, Shade shadeOf)
{
    std::vector<std::uint8_t> shades;
    shades.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        std::transform(row, row + image.width(), std::back_inserter(shades),
                       [&](QRgb pixel) { return static_cast<std::uint8_t>(shadeOf(pixel)); });
    }
    return shades;
}

/// Returns true for SVG, which is refused: its text needs fonts, which are missing in a program without a window.
bool isDrawing(const QByteArray& format)
{
    return format == "svg" || format == "svgz";
}

bool isBlack(const std::vector<std::uint8_t>& shades)
{
    return std::ranges::none_of(shades, [](std::uint8_t shade) { return shade > 0; });
}

bool hasHoles(const QImage& image)
{
    return std::ranges::any_of(shadesOf(image, [](QRgb pixel) { return 255 - qAlpha(pixel); }),
                               [](std::uint8_t hole) { return hole > 0; });
}

QString faultOf(const QString& path, const core::BrushModel::Made& made)
{
    using Fault = core::BrushModel::Fault;
    switch (made.fault) {
    case Fault::None:
        break;
    case Fault::Unsound:
        return ErrorMessages::brushRefusal(path, made.report);
    case Fault::TooFlat:
        return BrushFiles::tr("%1 is too flat for a brush shape.").arg(path);
    case Fault::TooSmall:
        return BrushFiles::tr("%1 is too small for a brush shape.").arg(path);
    case Fault::TooManyFaces:
        return BrushFiles::tr("%1 has too many triangles for a brush shape: at most %2 are allowed. Export it with "
                              "fewer triangles first.")
            .arg(path, QLocale().toString(static_cast<qulonglong>(core::BrushModel::maxFaces)));
    }
    return {};
}
} // namespace

QStringList builtInAlphaNames()
{
    QStringList names;
    for (const std::string_view name : core::builtInAlphas())
        names << QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    return names;
}

QStringList alphaEndings()
{
    QStringList endings;
    for (const QByteArray& ending : QImageReader::supportedImageFormats())
        if (!isDrawing(ending))
            endings << QLatin1StringView(ending);
    return endings;
}

BrushFile<core::Alpha> readAlpha(const QString& path)
{
    if (!QFileInfo::exists(path))
        return refused<core::Alpha>(BrushFiles::tr("%1: there is no such file.").arg(path));
    QFile file(path);
    file.open(QIODevice::ReadOnly); // if this fails, decodeAlpha() reports it
    return decodeAlpha(&file, path);
}

BrushFile<core::Alpha> decodeAlpha(QIODevice* device, const QString& path)
{
    QImageReader reader(device);
    reader.setAutoTransform(true);
    reader.setDecideFormatFromContent(true);
    if (!reader.canRead() || isDrawing(reader.format()))
        return refused<core::Alpha>(BrushFiles::tr("%1 is not an image that can be read.").arg(path));
    const QSize size = reader.size();
    if (std::max(size.width(), size.height()) > core::Alpha::maxSide)
        return refused<core::Alpha>(BrushFiles::tr("%1 has %2 × %3 pixels: an alpha may have %4 on a side at most.")
                                        .arg(path)
                                        .arg(size.width())
                                        .arg(size.height())
                                        .arg(core::Alpha::maxSide));
    const QImage image = reader.read().convertToFormat(QImage::Format_ARGB32_Premultiplied);
    if (image.isNull() || std::max(image.width(), image.height()) > core::Alpha::maxSide)
        return refused<core::Alpha>(BrushFiles::tr("%1: this image is damaged.").arg(path));
    std::vector<std::uint8_t> shades = shadesOf(image, [](QRgb pixel) { return qGray(pixel); });
    if (isBlack(shades) && hasHoles(image))
        shades = shadesOf(image, [](QRgb pixel) { return qAlpha(pixel); });
    if (isBlack(shades))
        return refused<core::Alpha>(BrushFiles::tr("%1 is all black: the brush would do nothing.").arg(path));
    return {std::make_shared<core::Alpha>(image.width(), image.height(), std::move(shades), path.toStdString()), {}};
}

BrushFile<core::BrushModel> brushModelOf(const core::TriangleMesh& mesh, const QString& path)
{
    const core::BrushModel::Made made = core::BrushModel::of(mesh, path.toStdString());
    return {made.model, faultOf(path, made)};
}

BrushFile<core::BrushModel> readBrushModel(const QString& path)
{
    try {
        return brushModelOf(core::readMesh(std::filesystem::path(path.toStdU16String())), path);
    } catch (const core::FileError& error) {
        return refused<core::BrushModel>(ErrorMessages::sentence(error));
    } catch (const std::bad_alloc&) {
        return refused<core::BrushModel>(BrushFiles::tr("%1: there is not enough memory for this model.").arg(path));
    }
}
} // namespace ui
