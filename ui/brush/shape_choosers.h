#pragma once

class QComboBox;

namespace ui
{
class BrushSettings;
class BrushShapes;

// Combo boxes that show and change the brush's shape. Entries: none (or a ball), shapes of the program, recent files,
// and an entry that asks for a file. Precondition: the arguments outlive the box. Thread: gui.

/// Returns a box of alphas with pictures. The box is disabled if the tool uses no alpha.
QComboBox* alphaChooser(BrushSettings* brush, BrushShapes* shapes);
/// Returns a box of models for Stamp and for the command Add Ball.
QComboBox* modelChooser(BrushSettings* brush, BrushShapes* shapes);
} // namespace ui
