#pragma once

class QComboBox;

namespace ui
{
class BrushSettings;
class BrushShapes;

// Lists that show what the brush has and change it: none or a ball, ours, files that were chosen before, and a file to
// be chosen. Both arguments must outlive them. Thread: gui.

/// With a picture each. Off while the tool uses no alpha.
QComboBox* alphaChooser(BrushSettings* brush, BrushShapes* shapes);
/// Of Stamp, and of what Add Ball adds.
QComboBox* modelChooser(BrushSettings* brush, BrushShapes* shapes);
} // namespace ui
