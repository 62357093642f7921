#pragma once

namespace ui
{
class Actions;
class BrushSettings;

/// Joins the actions of the Sculpt menu with the brush, both ways: what is triggered changes it, what changes is
/// checked. Both must outlive the window of the actions. Thread: gui.
void connectBrush(const Actions& actions, BrushSettings* brush);
} // namespace ui
