#pragma once

#include "core/io/stroke/stroke_file.h"

#include <QString>

namespace app
{
/// Reads the images and models that strokes need into their settings; paths start from the stroke file. Each file is
/// read once. Throws CommandFailure, with the stroke and the reason: a file that is no alpha or no brush, or not what
/// it was when the stroke was recorded.
void readStrokeAssets(std::vector<core::FileEntry>& entries, const QString& strokes);
} // namespace app
