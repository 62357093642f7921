#pragma once

#include <QFrame>
#include <QList>

class QAction;

namespace ui
{
class Actions;
class BrushSettings;
class PresetShelf;
class Viewport;

/// A small window at the pointer with the things that a hand wants most: tools, radius, strength, some commands, and
/// the presets as pictures. It goes when a tool or a preset is chosen, or with a click beside it. Thread: gui.
class BrushPalette : public QFrame
{
    Q_OBJECT

public:
    /// Shows the visible ones of the actions. None is owned; `brush` and `presets` must outlive the palette.
    BrushPalette(BrushSettings* brush, PresetShelf* presets, const QList<QAction*>& tools,
                 const QList<QAction*>& commands, QWidget* parent = nullptr);

    /// Opens it with its middle at that place of the screen, or as near as it is whole.
    void openAt(const QPoint& place);

private:
    QWidget* makeButtons(const QList<QAction*>& actions);
    QWidget* makePresets(PresetShelf* presets);
};

/// brush.palette and a click of the right button open a palette at the pointer, or in the middle of the view if the
/// pointer is elsewhere. None is owned.
void connectBrushPalette(QWidget* window, Viewport* viewport, BrushSettings* brush, PresetShelf* presets,
                         const Actions& actions);
} // namespace ui
