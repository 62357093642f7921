#pragma once

#include <QString>

namespace core
{
enum class Tool;
}

namespace ui
{
class BrushSettings;
class Settings;

/// Returns the settings group with the tool's own values: "tool/pull/".
QString groupOf(core::Tool tool);

/// Restores the stored values of all tools, except alphas and the radius itself. A tool without stored values gets
/// those that older versions stored once for all tools. Thread: gui.
void restoreBrush(const Settings& settings, BrushSettings* brush);
/// Stores the values of all tools. Also stores those of Pull as the common values of older versions, which start with
/// that tool.
void storeBrush(const BrushSettings& brush, Settings* settings);
} // namespace ui
