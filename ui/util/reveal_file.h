#pragma once

#include <QObject>
#include <QString>

#include <functional>

namespace ui
{
/// Shows the file in the desktop's file manager, or opens its folder if the file manager cannot select files. Returns
/// at once. Calls `refused` with a sentence if there is no file manager, unless `context` has been destroyed. Thread:
/// gui.
void revealFile(const QString& path, QObject* context, const std::function<void(const QString&)>& refused);

/// Opens the file's folder in the desktop's file manager. Calls `refused` with a sentence if there is none. Thread:
/// gui.
void openFolderOf(const QString& path, const std::function<void(const QString&)>& refused);
} // namespace ui
