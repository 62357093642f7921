#include "ui/files/trash.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

namespace ui
{
namespace
{
/// Returns true if the user's trash folder exists or can be created. If it cannot, Qt 6.4 would use the working
/// directory as trash.
bool hasTrash()
{
#ifdef Q_OS_MACOS
    return true;
#else
    return QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                         QStringLiteral("/Trash"));
#endif
}
} // namespace

bool moveToTrash(const QString& path)
{
    return hasTrash() && QFile::moveToTrash(path);
}
} // namespace ui
