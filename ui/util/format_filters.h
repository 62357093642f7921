#pragma once

#include <QStringList>

namespace ui
{
/// Of the files that models are read from: lower case, without dot.
QStringList modelEndings();
/// Of those that they are written to, too.
QStringList writtenEndings();
/// "STL, OBJ, PLY", or "STL, OBJ, PLY and others": for sentences.
QString modelFormats();
QString writtenFormats();
/// Returns "html" and "pdf", the endings of class reports.
QStringList reportEndings();
/// Returns the ending of the files of classes.
QString classEnding();
/// Returns whether a file is a class's, by its ending.
bool isClassFile(const QString& path);
/// Whether a model can be written under that name, by its ending.
bool isWritten(const QString& path);
/// A file of that name holds all of a document: GLB.
bool isDocumentFormat(const QString& path);
} // namespace ui
