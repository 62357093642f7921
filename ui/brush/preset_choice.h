#pragma once

#include "ui/brush/preset_file.h"

namespace ui
{
class BrushSettings;
class BrushShapes;

/// Returns the brush in the hand as a preset without a name. Its radius is a share of the model's size. Thread: gui.
core::BrushPreset presetOf(const BrushSettings& brush);
/// Takes the preset's tool with its values; the radius where each tool has its own. An alpha that is a file takes
/// effect when it was read. Returns one sentence if that file cannot be laid down. Precondition: the tool is offered.
QString takePreset(const PresetFile& file, BrushSettings* brush, BrushShapes* shapes);
/// Whether the brush still is what takePreset() made of it, except radius and alpha.
bool isInHand(const core::BrushPreset& preset, const BrushSettings& brush);
} // namespace ui
