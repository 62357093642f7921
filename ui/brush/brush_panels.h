#pragma once

#include <functional>

class QMainWindow;
class QMenu;

namespace ui
{
class BrushSettings;
class BrushShapes;

struct BrushPanelContext
{
    QMainWindow* window;
    QMenu* toggles;
    std::function<void()> entered; ///< a number was typed, and Return; the keys belong to the model again
};

/// Brush, topology and symmetry as docks at the window's right, each with an entry in `toggles` that shows and hides
/// it. Brush and shapes must outlive the window's children. Thread: gui.
void addBrushPanels(const BrushPanelContext& context, BrushSettings* brush, BrushShapes* shapes);
} // namespace ui
