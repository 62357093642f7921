#include "ui/files/trash.h"

#include <QFile>

namespace ui
{
/// Qt asks the shell for the recycle bin only, and fails where a drive has none.
bool moveToTrash(const QString& path)
{
    return QFile::moveToTrash(path);
}
} // namespace ui
