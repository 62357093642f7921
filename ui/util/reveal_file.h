#pragma once

#include <QObject>
#include <QString>

#include <functional>

namespace ui
{
/// Shows the file in the desktop's program for files, or its folder where that program cannot point at files. Returns
/// at once; `refused` is called, with a sentence, where there is no such program, unless `context` is gone.
/// Thread: gui.
void revealFile(const QString& path, QObject* context, const std::function<void(const QString&)>& refused);
} // namespace ui
