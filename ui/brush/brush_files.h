#pragma once

#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"

#include <QString>
#include <QStringList>

class QIODevice;

namespace ui
{
/// What a file is to the brush, or one sentence with file and reason why it is nothing.
template <class What> struct BrushFile
{
    std::shared_ptr<const What> what; ///< null: refused
    QString problem;
};

/// An image in grey: bright is much; where it is transparent, nothing; a black shape on transparent ground is taken for
/// white. Of more than core::Alpha::maxSide pixels a side nothing is decoded; SVG is refused. Any thread.
BrushFile<core::Alpha> readAlpha(const QString& path);
/// Reads an alpha from a device; `path`: what the sentence and the alpha call it.
BrushFile<core::Alpha> decodeAlpha(QIODevice* device, const QString& path);
/// Names of the alphas that come with the program.
QStringList builtInAlphaNames();
/// Of files that readAlpha takes.
QStringList alphaEndings();

/// By the readers of all models. Takes as long as the model is large; any thread.
BrushFile<core::BrushModel> readBrushModel(const QString& path);
/// Of a model that is there already; `path`: its file, or what a sentence calls it.
BrushFile<core::BrushModel> brushModelOf(const core::TriangleMesh& mesh, const QString& path);
} // namespace ui
