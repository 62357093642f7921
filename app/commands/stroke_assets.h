#pragma once

#include "core/io/stroke/stroke_file.h"

#include <QString>

namespace app
{
/// Reads the images and models that strokes refer to into their settings. Relative paths are resolved against the
/// stroke file, and each file is read once. Throws CommandFailure with the stroke and the reason: a file is not an
/// alpha or brush model, or has changed since the stroke was recorded.
void readStrokeAssets(std::vector<core::FileEntry>& entries, const QString& strokes);
} // namespace app
