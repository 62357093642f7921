#pragma once

#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"

#include <QString>
#include <QStringList>

class QIODevice;

namespace ui
{
/// A part of the brush that was read from a file, or the reason why the file was refused.
template <class What> struct BrushFile
{
    std::shared_ptr<const What> what; ///< null: the file was refused
    QString problem;
};

/// Reads a grey image as an alpha: white is full strength; black and transparent pixels are 0. If all pixels are black
/// and some are transparent, opacity is used instead of brightness. Refuses SVG, and images with a side longer than
/// core::Alpha::maxSide pixels without decoding them. Thread: any.
BrushFile<core::Alpha> readAlpha(const QString& path);
/// Reads an alpha from a device. `path`: name used in error messages and as the alpha's source. Thread: any.
BrushFile<core::Alpha> decodeAlpha(QIODevice* device, const QString& path);
/// Returns the names of the alphas that are part of the program.
QStringList builtInAlphaNames();
/// Returns the suffixes of the image files that readAlpha() accepts.
QStringList alphaEndings();

/// Reads the shape of a brush from a model file. Cost: proportional to the model's size. Thread: any.
BrushFile<core::BrushModel> readBrushModel(const QString& path);
/// Makes the shape of a brush from a mesh. `path`: the mesh's file, or its name in error messages.
BrushFile<core::BrushModel> brushModelOf(const core::TriangleMesh& mesh, const QString& path);
} // namespace ui
