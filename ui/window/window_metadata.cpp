#include "ui/window/window_metadata.h"

#include "ui/reference/reference_images.h"
#include "ui/settings/brush_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QAction>

namespace ui
{
void addMetadata(const MainWindow& window, core::DocumentMetadata& metadata)
{
    metadata.view = window.viewport()->camera().saved();
    metadata.brush = window.brush()->stroke();
    if (const auto* references = window.findChild<ReferenceImages*>()) // none without OpenGL
        metadata.references = references->saved();
}

void applyMetadata(MainWindow& window, const core::DocumentMetadata& metadata)
{
    if (auto* references = window.findChild<ReferenceImages*>())
        references->setSaved(metadata.references);
    if (metadata.brush)
        window.brush()->apply(*metadata.brush);
    if (!metadata.view)
        return;
    window.action(QStringLiteral("view.orthographic"))->setChecked(metadata.view->orthographic);
    window.viewport()->navigation()->setView(*metadata.view);
}
} // namespace ui
