#include "ui/util/reveal_file.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

namespace ui
{
namespace
{
struct RevealFile
{
    Q_DECLARE_TR_FUNCTIONS(ui::RevealFile)
};
} // namespace

void openFolderOf(const QString& path, const std::function<void(const QString&)>& refused)
{
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
        refused(RevealFile::tr("No file manager was found; the file is in %1.").arg(QDir::toNativeSeparators(folder)));
}
} // namespace ui
