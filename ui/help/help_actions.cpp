#include "ui/help/help_actions.h"

#include "ui/actions/actions.h"
#include "ui/actions/command_palette.h"
#include "ui/help/about.h"
#include "ui/help/guide_window.h"
#include "ui/help/start_page.h"

#include <QAction>
#include <QMainWindow>

namespace ui
{
namespace
{
/// Opens the guide. Its window is created at first use and then reused.
void openGuide(const Actions& actions, QWidget* window)
{
    auto* guide = window->findChild<GuideWindow*>();
    (guide ? guide : new GuideWindow(actions, window))->openPage({});
}
} // namespace

StartPage* connectHelp(const Actions& actions, Settings* settings, QMainWindow* window)
{
    auto* start = new StartPage(actions, settings, window->centralWidget());
    QObject::connect(start, &StartPage::guideRequested, window, [&actions, window] { openGuide(actions, window); });
    const auto on = [&](const char* id, auto what) {
        QObject::connect(actions.get(QLatin1StringView(id)), &QAction::triggered, window, what);
    };
    on("help.start", [start] { start->open(); });
    on("help.guide", [&actions, window] { openGuide(actions, window); });
    on("help.keys", [&actions, window] { (new CommandPalette(actions, window))->open(); });
    on("help.about", [window] { showAbout(window); });
    return start;
}
} // namespace ui
