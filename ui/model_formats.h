#pragma once

#include <QStringList>

namespace ui
{
/// Of the files that models are read from and written to: lower case, without dot.
QStringList modelEndings();
/// "STL, OBJ, PLY": for sentences.
QString modelFormats();
} // namespace ui
