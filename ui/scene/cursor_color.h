#pragma once

#include "core/stroke/stroke.h"

#include <QColor>

namespace ui
{
/// Returns the colour of the cursor's ring, which shows what the next stroke does: one for each tool, and one for all
/// inverted tools.
QColor cursorColor(const core::StrokeSettings& stroke);
} // namespace ui
