#pragma once

#include <QFrame>
#include <QList>

class QAction;

namespace ui
{
class Actions;
class BrushSettings;
class PresetList;
class Viewport;

/// A popup at the pointer with the most used controls: tools, radius, strength, some commands, and presets as pictures.
/// Choosing a tool or a preset, or clicking outside, closes the popup. Thread: gui.
class BrushPalette : public QFrame
{
    Q_OBJECT

public:
    /// Shows those of the actions that are visible. Nothing is owned. Precondition: `brush` and `presets` outlive the
    /// palette.
    BrushPalette(BrushSettings* brush, PresetList* presets, const QList<QAction*>& tools,
                 const QList<QAction*>& commands, QWidget* parent = nullptr);

    /// Opens the palette centred at a screen position, moved as far as needed to keep all of it on the screen.
    void openAt(const QPoint& place);

private:
    QWidget* makeButtons(const QList<QAction*>& actions);
    QWidget* makePresets(PresetList* presets);
};

/// Opens a palette on the action brush.palette or a right click: at the pointer, or in the middle of the view if the
/// pointer is outside. The arguments are not owned.
void connectBrushPalette(QWidget* window, Viewport* viewport, BrushSettings* brush, PresetList* presets,
                         const Actions& actions);
} // namespace ui
