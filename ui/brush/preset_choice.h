#pragma once

#include "ui/brush/preset_file.h"

namespace ui
{
class BrushSettings;
class BrushShapes;

/// Returns the current brush as a preset without a name. Its radius is a fraction of the model's size. Thread: gui.
core::BrushPreset presetOf(const BrushSettings& brush);
/// Applies the preset's tool and values. Its radius is applied only if each tool has a radius of its own. An alpha file
/// is read first. Returns a message if the preset's alpha image cannot be written to a file; else empty. Precondition:
/// the tool is offered.
QString takePreset(const PresetFile& file, BrushSettings* brush, BrushShapes* shapes);
/// Returns true if the brush still has the values that takePreset() gave it; radius and alpha are not compared.
bool isInHand(const core::BrushPreset& preset, const BrushSettings& brush);
} // namespace ui
