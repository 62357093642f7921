#include "vr/openxr/active_runtime.h"

#include <QDir>
#include <QFileInfo>
#include <QStringList>
#include <QSysInfo>

namespace vr
{
/// Looks in the folders of the XDG Base Directory Specification, then in /etc. A manifest for the processor comes
/// first, as loaders of OpenXR 1.1 have it.
QString systemManifest()
{
    const auto variable = [](const char* name, const QString& otherwise) {
        const QString value = qEnvironmentVariable(name);
        return value.isEmpty() ? otherwise : value;
    };
    QStringList folders{variable("XDG_CONFIG_HOME", QDir::homePath() + QStringLiteral("/.config"))};
    folders += variable("XDG_CONFIG_DIRS", QStringLiteral("/etc/xdg")).split(u':', Qt::SkipEmptyParts);
    folders << QStringLiteral("/etc");
    const QStringList processors{QStringLiteral(".") + QSysInfo::buildCpuArchitecture(), QString()};
    const QString name = QStringLiteral("%1/openxr/1/active_runtime%2.json");
    for (const QString& folder : folders)
        for (const QString& processor : processors)
            if (const QString path = name.arg(folder, processor);
                QFileInfo(path).isSymLink() || QFileInfo::exists(path))
                return path;
    return {};
}
} // namespace vr
