#pragma once

#include "core/stroke/stroke.h"

#include <QColor>

namespace ui
{
/// Returns the colour of the cursor's ring, which shows the effect of the next stroke: one colour for each tool, and
/// one for all inverted tools.
QColor cursorColor(const core::StrokeSettings& stroke);
} // namespace ui
