#pragma once

#include <QStringList>

namespace ui
{
/// Returns the extensions of readable model files: lower case, without dot.
QStringList modelEndings();
/// Returns the extensions of model files that can also be written.
QStringList writtenEndings();
/// Return the formats for use in a sentence: "STL, OBJ, PLY", or "STL, OBJ, PLY and others".
QString modelFormats();
QString writtenFormats();
/// Returns "html" and "pdf", the extensions of class reports.
QStringList reportEndings();
/// Returns the extension of class files.
QString classEnding();
/// Returns true if the file's extension is that of class files.
bool isClassFile(const QString& path);
/// Returns true if a model can be written under this name, by its extension.
bool isWritten(const QString& path);
/// Returns true if a file of this name can store a whole document: GLB.
bool isDocumentFormat(const QString& path);
} // namespace ui
