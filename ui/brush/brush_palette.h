#pragma once

#include <QFrame>
#include <QList>

class QAction;

namespace ui
{
class Actions;
class BrushSettings;
class Viewport;

/// A small window at the pointer with the things that a hand wants most: tools, radius, strength and some
/// commands. It goes when a tool is chosen, or with a click beside it. Thread: gui.
class BrushPalette : public QFrame
{
    Q_OBJECT

public:
    /// Shows the visible ones of the actions. None is owned; `brush` must outlive the palette.
    BrushPalette(BrushSettings* brush, const QList<QAction*>& tools, const QList<QAction*>& commands,
                 QWidget* parent = nullptr);

    /// Opens it with its middle at that place of the screen, or as near as it is whole.
    void openAt(const QPoint& place);

private:
    QWidget* makeButtons(const QList<QAction*>& actions);
};

/// brush.palette and a click of the right button open a palette at the pointer, or in the middle of the view if the
/// pointer is elsewhere. None is owned.
void connectBrushPalette(QWidget* window, Viewport* viewport, BrushSettings* brush, const Actions& actions);
} // namespace ui
