// Goes from the present state back to the first: draws each state that needs a frame, then undoes a step. The number of
// frames is known in advance, so each frame gets its final number.

#include "app/document/time_lapse.h"

#include "app/model/model_loader.h"

#include "core/mesh/mesh_builder.h"
#include "core/util/atomic_file.h"
#include "ui/util/error_messages.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>

#include <algorithm>
#include <new>

namespace app
{
namespace
{
constexpr int minDigits = 4;
constexpr int behind[] = {236, 238, 241}; ///< background colour, sRGB

int framesBetween(int first, int last, int every)
{
    return (last - first + every - 1) / every + 1;
}

QByteArray pngOf(const core::ModelThumbnail& picture)
{
    QImage frame(picture.width, picture.height, QImage::Format_RGB888);
    auto pixel = picture.rgba.begin();
    for (int y = 0; y < picture.height; ++y)
        for (uchar *at = frame.scanLine(y), *end = at + 3 * picture.width; at < end; at += 3, ++pixel)
            for (std::size_t i = 0; i < 3; ++i)
                at[i] = static_cast<uchar>((*pixel)[i] + behind[i] * (255 - (*pixel)[3]) / 255);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    frame.save(&buffer, "PNG");
    return bytes;
}

void write(const QString& path, const QByteArray& bytes)
{
    core::AtomicFile file(toPath(path));
    file.write({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    file.commit();
}
} // namespace

QStringList TimeLapse::frameNames(int first, int last, int every)
{
    const int frames = framesBetween(first, last, every);
    const int digits = std::max(minDigits, static_cast<int>(QString::number(frames).size()));
    QStringList names;
    for (int i = 1; i <= frames; ++i)
        names << QStringLiteral("frame-%1.png").arg(i, digits, 10, QLatin1Char('0'));
    return names;
}

QString TimeLapse::obstacle(const QString& folder, const QStringList& frames)
{
    if (!QFileInfo(folder).isDir())
        return tr("%1 is not a folder.").arg(QDir::toNativeSeparators(folder));
    for (const QString& name : frames)
        if (QFileInfo::exists(QDir(folder).filePath(name)))
            return tr("%1 already contains %2, and nothing was overwritten: choose an empty folder.")
                .arg(QDir::toNativeSeparators(folder), name);
    return {};
}

TimeLapseOutcome TimeLapse::run(const TimeLapseRequest& request, const ModelHistory& history,
                                const core::JobControl& control)
{
    const QStringList names = frameNames(history.first, history.present, request.every);
    QStringList written;
    const auto without = [&written](const QString& problem) {
        for (const QString& path : written)
            QFile::remove(path);
        return TimeLapseOutcome{problem, 0};
    };
    const QString noMemory = tr("There is not enough memory for a time-lapse of this model.");
    const QString problem = obstacle(request.folder, names);
    if (!problem.isEmpty())
        return {problem, 0};
    if (!history.mesh)
        return {noMemory, 0};
    try {
        for (int state = history.present; !control.isCancelled(); --state) {
            if (state == history.present || (state - history.first) % request.every == 0) {
                const auto picture = core::drawThumbnail(core::extractMesh(*history.mesh), request.view, control.stop);
                if (!picture)
                    break;
                const QString path =
                    QDir(request.folder).filePath(names[framesBetween(history.first, state, request.every) - 1]);
                if (QFileInfo::exists(path)) // created since the time-lapse began
                    return without(obstacle(request.folder, {QFileInfo(path).fileName()}));
                write(path, pngOf(*picture));
                written << path;
                control.reportProgress(static_cast<double>(written.size()) / static_cast<double>(names.size()));
            }
            if (state == history.first)
                return {{}, static_cast<int>(written.size())};
            auto change = history.change(state - 1);
            if (!change && !control.isCancelled())
                return without(
                    tr("The earlier steps of the model can no longer be read, so they are not in the time-lapse."));
            if (change)
                history.mesh->swap(*change);
        }
    } catch (const core::FileError& error) {
        return without(ui::ErrorMessages::sentence(error));
    } catch (const std::bad_alloc&) {
        return without(noMemory);
    }
    return without({});
}
} // namespace app
