#pragma once

#include <QIcon>

namespace ui
{
/// The drawing :/icons/<name>.svg in the palette's text colour, sharp at every size and ratio; it follows the palette.
/// An empty icon if there is no such drawing.
QIcon themedIcon(const QString& name);
} // namespace ui
