#pragma once

#include "core/stroke/stroke.h"

#include <QColor>

namespace ui
{
/// Of the cursor's ring, which says what the next stroke does: a colour a tool, and one for all that is inverted.
QColor cursorColor(const core::StrokeSettings& stroke);
} // namespace ui
