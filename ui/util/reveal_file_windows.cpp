// Source: Microsoft Learn, "SHOpenFolderAndSelectItems function".
#include "ui/util/reveal_file.h"

#include <QDir>
#include <QFileInfo>

#include <windows.h>

#include <objbase.h>
#include <shlobj.h>

namespace ui
{
namespace
{
/// Returns whether Explorer shows the file, selected in its folder. Qt has prepared COM for the gui thread.
bool selectInExplorer(const QString& path)
{
    const std::wstring name = QDir::toNativeSeparators(QFileInfo(path).absoluteFilePath()).toStdWString();
    PIDLIST_ABSOLUTE const item = ILCreateFromPathW(name.c_str());
    if (!item)
        return false;
    const bool isShown = SUCCEEDED(SHOpenFolderAndSelectItems(item, 0, nullptr, 0));
    ILFree(item);
    return isShown;
}
} // namespace

void revealFile(const QString& path, QObject*, const std::function<void(const QString&)>& refused)
{
    if (!selectInExplorer(path))
        openFolderOf(path, refused);
}
} // namespace ui
