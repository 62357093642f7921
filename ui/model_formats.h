#pragma once

#include <QStringList>

namespace ui
{
/// Of the files that models are read from and written to: lower case, without dot.
QStringList modelEndings();
/// "STL, OBJ, PLY": for sentences.
QString modelFormats();
/// A file of that name holds all of a document: GLB.
bool isDocumentFormat(const QString& path);
} // namespace ui
