#pragma once

#include <QIcon>

namespace ui
{
/// Returns the icon :/icons/<name>.svg in the palette's text colour, sharp at every size and pixel ratio. Follows
/// changes of the palette. Empty if there is no such file.
QIcon themedIcon(const QString& name);
} // namespace ui
