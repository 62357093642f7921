#include "app/platform/desktop.h"

#include <QDir>
#include <QStandardPaths>

namespace app
{
/// Each process of a user has a desktop, even one that nobody sees.
bool hasDisplay()
{
    return true;
}

void preferX11() {}

/// XDG_STATE_HOME counts on Windows, too, where a class or a test sets it.
QString stateFolder()
{
    const QString state = qEnvironmentVariable("XDG_STATE_HOME");
    return QDir::isAbsolutePath(state) ? state : QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
}
} // namespace app
