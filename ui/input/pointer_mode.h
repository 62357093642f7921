#pragma once

namespace ui
{
/// Effect of a press for the brush: sculpts, adds one ball, picks one colour, or only points (the pointer's place is
/// shown in VR).
enum class PointerMode { Sculpt, Add, Pick, Point };
} // namespace ui
