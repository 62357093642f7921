#pragma once

namespace ui
{
class SideColumn;
class Turntable;

/// Adds a panel with the turntable's switch, direction and speed to the column. The turntable is not owned.
void addTurntablePanel(SideColumn* column, Turntable* turntable);
} // namespace ui
