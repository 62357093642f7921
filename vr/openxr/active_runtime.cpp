#include "vr/openxr/active_runtime.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

namespace vr
{
QString ActiveRuntime::manifest()
{
    const QString chosen = qEnvironmentVariable("XR_RUNTIME_JSON");
    return chosen.isEmpty() ? systemManifest() : chosen;
}

QString ActiveRuntime::libraryOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject manifest = QJsonDocument::fromJson(file.readAll()).object();
    const QString library =
        manifest[QStringLiteral("runtime")].toObject()[QStringLiteral("library_path")].toString().replace(u'\\', u'/');
    const bool hasFolder = library.contains(u'/');
    return hasFolder ? QFileInfo(path).absoluteDir().absoluteFilePath(library) : library;
}

QString ActiveRuntime::faultOf(const QString& path, const QString& reason)
{
    if (path.isEmpty())
        //: %1: a name from OpenXR, such as XR_ERROR_RUNTIME_UNAVAILABLE
        return tr("No OpenXR runtime is set up on this computer (%1). Install SteamVR, Monado or the headset's own "
                  "program, make it the active OpenXR runtime there, then ask again.")
            .arg(reason);
    const QString remedy = tr("Make SteamVR, Monado or the headset's own program the active OpenXR runtime again, then "
                              "ask again.");
    const auto text = [&](const QString& fault) { return fault + u' ' + remedy; };
    if (!QFileInfo(path).isReadable())
        //: %1: a file's path; %2: a name from OpenXR
        return text(
            tr("The file of the active OpenXR runtime, %1, is missing or cannot be read (%2).").arg(path, reason));
    const QString library = libraryOf(path);
    if (library.isEmpty())
        //: %1: a file's path; %2: a name from OpenXR
        return text(tr("The file of the active OpenXR runtime, %1, names no runtime (%2).").arg(path, reason));
    if (library.contains(u'/') && !QFileInfo::exists(library))
        //: %1: a file's path; %2: a name from OpenXR; %3: the path of a program library
        return text(tr("The active OpenXR runtime is not where its file %1 says: there is no %3 (%2).")
                        .arg(path, reason, library));
    return {};
}
} // namespace vr
