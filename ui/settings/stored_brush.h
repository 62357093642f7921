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

/// Returns the group of the settings that has what the tool has of its own: "tool/pull/".
QString groupOf(core::Tool tool);

/// Gives the brush the stored values of all tools, except alphas and the radius. A tool that has none stored has those
/// that were stored for all tools once. Thread: gui.
void restoreBrush(const Settings& settings, BrushSettings* brush);
/// Stores them, and those of Pull for programs that know only one: they begin with that tool.
void storeBrush(const BrushSettings& brush, Settings* settings);
} // namespace ui
