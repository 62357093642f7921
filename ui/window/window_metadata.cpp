#include "ui/window/window_metadata.h"

#include "ui/settings/brush_settings.h"
#include "ui/window/main_window.h"
#include "ui/viewport/viewport.h"

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
