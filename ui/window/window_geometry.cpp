#include "ui/window/window_geometry.h"

#include "ui/settings/settings.h"
#include "ui/widgets/side_column.h"

#include <QMainWindow>
#include <QScreen>
#include <QStyle>

namespace ui
{
namespace
{
constexpr QSize firstSize{1280, 800};
constexpr int barsVersion = 2; ///< version of the stored state of the bars; a state of another version is ignored

/// Shrinks the window to fit the screen. A window that was never shown does not know its frame, so the height of a
/// title bar is assumed.
void keepOnScreen(QMainWindow* window)
{
    if (window->isMaximized() || window->isFullScreen())
        return;
    const QRect available = window->screen()->availableGeometry();
    const int title = window->style()->pixelMetric(QStyle::PM_TitleBarHeight);
    if (window->width() > available.width() || window->height() > available.height() - title)
        window->setGeometry(
            {available.topLeft() + QPoint(0, title), window->size().boundedTo(available.size() - QSize(0, title))});
}
} // namespace

void restoreWindowGeometry(QMainWindow* window, SideColumn* column, const Settings& settings)
{
    window->resize(firstSize);
    window->restoreGeometry(settings.get(&Setting::windowGeometry));
    keepOnScreen(window);
    window->restoreState(settings.get(&Setting::windowState), barsVersion);
    column->setPanelStates(settings.get(&Setting::panels));
}

void saveWindowGeometry(const QMainWindow& window, const SideColumn& column, Settings& settings)
{
    settings.set(&Setting::windowGeometry, window.saveGeometry());
    settings.set(&Setting::windowState, window.saveState(barsVersion));
    settings.set(&Setting::panels, column.panelStates());
}
} // namespace ui
