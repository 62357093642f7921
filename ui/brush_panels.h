#pragma once

#include <functional>

class QMainWindow;
class QMenu;

namespace ui
{
class BrushSettings;

/// Brush, topology and symmetry as docks at the window's right, each with an entry in `toggles` that shows and hides it.
/// `entered`: a number was typed, and Return; the keys belong to the model again. The brush must outlive the window's
/// children. Gui thread.
void addBrushPanels(QMainWindow* window, BrushSettings* brush, QMenu* toggles, const std::function<void()>& entered);
} // namespace ui
