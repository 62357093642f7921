#include "ui/files/slicer.h"

#include <QStandardPaths>

namespace ui
{
QString installedSlicer()
{
    return QStandardPaths::findExecutable(QStringLiteral("prusa-slicer"));
}
} // namespace ui
