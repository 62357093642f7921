#include "window_notes.h"

#include "brush_settings.h"
#include "main_window.h"
#include "viewport.h"

#include <QAction>

namespace ui
{
void addNotes(const MainWindow& window, core::DocumentNotes& notes)
{
    notes.view = window.viewport()->camera().saved();
    notes.brush = window.brush()->stroke();
}

void takeNotes(MainWindow& window, const core::DocumentNotes& notes)
{
    if (notes.brush)
        window.brush()->take(*notes.brush);
    if (!notes.view)
        return;
    window.action(QStringLiteral("view.orthographic"))->setChecked(notes.view->orthographic);
    window.viewport()->setView(*notes.view);
}
} // namespace ui
