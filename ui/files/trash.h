#pragma once

#include <QString>

namespace ui
{
/// Moves a file to the user's trash. Returns false if there is no trash for it; the file is then unchanged. Thread:
/// any.
bool moveToTrash(const QString& path);
} // namespace ui
