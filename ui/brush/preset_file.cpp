#include "ui/brush/preset_file.h"

#include "ui/util/error_messages.h"
#include "ui/util/stroke_file_messages.h"

#include "core/preset/brush_picture.h"
#include "core/util/atomic_file.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace ui
{
namespace
{
struct PresetFiles
{
    Q_DECLARE_TR_FUNCTIONS(ui::PresetFiles)
};

constexpr int maxStem = 40; ///< characters of a file name without its suffix

std::filesystem::path toPath(const QString& path)
{
    return std::filesystem::path(path.toStdU16String());
}

/// Reads a preset. Qt resources are read here, because core cannot open them.
core::BrushPreset read(const QString& path)
{
    if (!path.startsWith(u':'))
        return core::readBrush(toPath(path));
    QFile resource(path);
    if (!resource.open(QIODevice::ReadOnly))
        throw core::StrokeFileError(core::StrokeFileError::Kind::CannotRead);
    return core::parseBrush(resource.readAll().toStdString());
}

QByteArray imageOf(const core::BrushPreset& preset)
{
    return QByteArray::fromBase64(QByteArray::fromStdString(preset.alphaImage));
}

/// Returns the path to which the preset's alpha image is extracted, so that strokes and settings can name a file. The
/// path is in the user's data, in a folder named by the hash of the image.
QString extractedPath(const core::BrushPreset& preset, const QByteArray& image)
{
    const QByteArray hash = QCryptographicHash::hash(image, QCryptographicHash::Sha256).toHex().left(16);
    QString stem = QFileInfo(QString::fromStdString(preset.alpha.file)).completeBaseName().left(maxStem);
    stem.remove(u'/').remove(u'\\');
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
           QStringLiteral("/brushes/alphas/%1/%2.png").arg(QString::fromLatin1(hash), stem);
}

QString writeBytes(const QString& path, std::string_view bytes)
{
    try {
        core::AtomicFile file(toPath(path));
        file.write(bytes);
        file.commit();
    } catch (const core::FileError& error) {
        return ErrorMessages::sentence(error);
    }
    return {};
}
} // namespace

QStringList bundledPresets()
{
    QStringList paths;
    for (const char* name : {"clay-buildup", "raked-clay", "carve", "swell", "panel", "fine-line", "ridge", "polish",
                             "plane-off", "big-move", "horn", "pores", "scales", "cracks", "weave", "rough-stone"})
        paths << QStringLiteral(":/brushes/%1.json").arg(QLatin1StringView(name));
    return paths;
}

PresetFile readPreset(const QString& path)
{
    try {
        return {path, std::make_shared<const core::BrushPreset>(read(path)), {}};
    } catch (const core::StrokeFileError& error) {
        return {path, nullptr, StrokeFileMessages::sentence(QDir::toNativeSeparators(path), error) + u'.'};
    } catch (const std::bad_alloc&) {
        return {path, nullptr, PresetFiles::tr("%1: there is not enough memory for this preset.").arg(path)};
    }
}

QString alphaPath(const PresetFile& file)
{
    const core::BrushPreset& preset = *file.preset;
    if (preset.alphaImage.empty())
        return QFileInfo(file.path).dir().filePath(QString::fromStdString(preset.alpha.file));
    return extractedPath(preset, imageOf(preset));
}

BrushFile<core::Alpha> alphaOf(const PresetFile& file)
{
    const QString path = alphaPath(file);
    if (file.preset->alphaImage.empty())
        return readAlpha(path);
    QByteArray image = imageOf(*file.preset);
    QBuffer buffer(&image);
    buffer.open(QIODevice::ReadOnly);
    BrushFile<core::Alpha> alpha = decodeAlpha(&buffer, path);
    if (!alpha.what)
        alpha.problem = PresetFiles::tr("%1: the alpha in this preset cannot be used: %2", "a sentence that says why")
                            .arg(file.path, alpha.problem);
    return alpha;
}

QString layAlphaDown(const PresetFile& file)
{
    const QString path = alphaPath(file);
    if (file.preset->alphaImage.empty() || QFile::exists(path))
        return {};
    QFileInfo(path).dir().mkpath(QStringLiteral(".")); // if this fails, writeBytes() reports it
    return writeBytes(path, imageOf(*file.preset).toStdString());
}

QString embedAlpha(core::BrushPreset& preset, const QString& from)
{
    if (preset.stroke.alpha && preset.stroke.alpha->isBuiltIn())
        return {};
    std::shared_ptr<const core::Alpha> alpha = preset.stroke.alpha;
    if (!alpha) {
        if (preset.alpha.file.empty() || !preset.alphaImage.empty())
            return {};
        const BrushFile<core::Alpha> file =
            readAlpha(QFileInfo(from).dir().filePath(QString::fromStdString(preset.alpha.file)));
        if (!file.what)
            return file.problem;
        alpha = file.what;
    }
    const QImage image(alpha->pixels().data(), alpha->width(), alpha->height(), alpha->width(),
                       QImage::Format_Grayscale8);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    preset.stroke.alpha = nullptr;
    preset.alpha.file = QFileInfo(QString::fromStdString(alpha->source())).fileName().toStdString();
    preset.alphaImage = bytes.toBase64().toStdString();
    return {};
}

QString writePreset(const core::BrushPreset& preset, const QString& path)
{
    return writeBytes(path, core::toJson(preset));
}

QImage presetImage(const PresetFile& file, int pixels, const std::stop_token& stop)
{
    constexpr double ballSize = 100, newShare = 0.1;
    core::StrokeSettings stroke = file.preset->stroke;
    stroke.radius = ballSize * file.preset->radiusShare.value_or(newShare);
    if (!file.preset->alpha.file.empty())
        stroke.alpha = alphaOf(file).what;
    const auto picture = core::drawBrush(stroke, pixels, stop);
    if (!picture)
        return {};
    return QImage(picture->rgba.data()->data(), picture->width, picture->height, QImage::Format_RGBA8888_Premultiplied)
        .copy();
}
} // namespace ui
