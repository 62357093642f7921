#include "ui/window/window_geometry.h"

#include "ui/settings/settings.h"

#include <QMainWindow>
#include <QScreen>
#include <QStyle>
#include <QToolBar>

namespace ui
{
namespace
{
constexpr QSize firstSize{1280, 800};
constexpr int barsVersion = 1; ///< of the window's state; 0: there was one palette

/// A window that was never shown does not know its frame; the title bar is the most of it.
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
/// Qt puts a bar that the state does not know below the others, where it has no room.
void restoreBars(QMainWindow* window, const QByteArray& state)
{
    if (!window->restoreState(state, barsVersion) && window->restoreState(state))
        window->insertToolBarBreak(window->findChild<QToolBar*>(QStringLiteral("toolOptions")));
}
} // namespace

void restoreWindowGeometry(QMainWindow* window, const Settings& settings)
{
    window->resize(firstSize);
    window->restoreGeometry(settings.get(&Setting::windowGeometry));
    keepOnScreen(window);
    restoreBars(window, settings.get(&Setting::windowState));
}

void saveWindowGeometry(const QMainWindow& window, Settings& settings)
{
    settings.set(&Setting::windowGeometry, window.saveGeometry());
    settings.set(&Setting::windowState, window.saveState(barsVersion));
}
} // namespace ui
