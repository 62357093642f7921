#pragma once

#include <functional>

namespace ui
{
class BrushSettings;
class BrushShapes;
class SideColumn;

struct BrushPanelContext
{
    SideColumn* column;
    /// Called after a number was typed and confirmed; returns the keyboard focus to the view.
    std::function<void()> entered;
};

/// Adds the panels for brush, topology and symmetry to the column. Precondition: `brush` and `shapes` outlive the
/// window's children. Thread: gui.
void addBrushPanels(const BrushPanelContext& context, BrushSettings* brush, BrushShapes* shapes);
} // namespace ui
