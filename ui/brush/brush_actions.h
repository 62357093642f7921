#pragma once

namespace ui
{
class Actions;
class BrushSettings;

/// Connects the actions of the Sculpt menu to the brush: triggering an action changes the brush, and changes of the
/// brush update the check marks. Precondition: `actions` and `brush` outlive the window. Thread: gui.
void connectBrush(const Actions& actions, BrushSettings* brush);
} // namespace ui
