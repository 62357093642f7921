#pragma once

namespace ui
{
/// What a press for the brush does: it sculpts, adds one sphere, picks one colour, or nothing while the pointer shows a
/// place to others.
enum class PointerMode { Sculpt, Add, Pick, Point };
} // namespace ui
