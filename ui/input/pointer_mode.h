#pragma once

namespace ui
{
/// Effect of a press for the brush: sculpts, adds one ball, picks one colour, chooses one part, only points (the
/// pointer's place is shown in VR), or moves the view as beside the model, because handles are over it.
enum class PointerMode { Sculpt, Add, Pick, ChoosePart, Point, Handles };
} // namespace ui
