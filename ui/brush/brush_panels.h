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
    std::function<void()> entered; ///< a number was typed, and Return; the keys belong to the model again
};

/// Adds brush, topology and symmetry to the column. Brush and shapes must outlive the window's children. Thread: gui.
void addBrushPanels(const BrushPanelContext& context, BrushSettings* brush, BrushShapes* shapes);
} // namespace ui
