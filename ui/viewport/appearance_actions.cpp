#include "ui/viewport/appearance_actions.h"

#include "ui/actions/actions.h"
#include "ui/settings/settings.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/themed_icon.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace ui
{
namespace
{
struct Switch
{
    const char* id;
    bool ViewLook::*what;
};
constexpr Switch switches[] = {{"view.wireframe", &ViewLook::wireframe},
                               {"view.flat", &ViewLook::flat},
                               {"view.ground", &ViewLook::ground},
                               {"view.scaleBar", &ViewLook::scaleBar},
                               {"view.caption", &ViewLook::caption}};

/// Shows it, and keeps it for the next start.
class Looks
{
public:
    Looks(const Actions& actions, Viewport* viewport, Settings* settings)
        : m_actions(actions)
        , m_viewport(viewport)
        , m_settings(settings)
    {}

    void addSwitches() const
    {
        for (const Switch& row : switches) {
            QAction* action = m_actions.get(QLatin1StringView(row.id));
            const auto show = [action, viewport = m_viewport, what = row.what] {
                action->setChecked(viewport->look().*what);
            };
            show();
            m_settings->onReset(show);
            connect(action, [what = row.what](ViewLook& look, bool on) { look.*what = on; });
        }
    }

    template <class T, std::size_t count>
    void addChoices(const QString& family, const std::array<Named<T>, count>& choices, T ViewLook::*what) const
    {
        auto* group = new QActionGroup(m_viewport);
        for (const Named<T>& choice : choices) {
            QAction* action = m_actions.get(family + QLatin1StringView(choice.key));
            group->addAction(action);
            const auto show = [action, viewport = m_viewport, what, value = choice.value] {
                action->setChecked(viewport->look().*what == value);
            };
            show();
            m_settings->onReset(show);
            connect(action, [what, value = choice.value](ViewLook& look, bool on) {
                if (on)
                    look.*what = value;
            });
        }
    }

private:
    template <class Change> void connect(QAction* action, Change change) const
    {
        QObject::connect(action, &QAction::toggled, m_viewport,
                         [viewport = m_viewport, settings = m_settings, change](bool on) {
                             ViewLook look = viewport->look();
                             change(look, on);
                             viewport->setLook(look);
                             settings->setLook(look);
                         });
    }

    const Actions& m_actions;
    Viewport* m_viewport;
    Settings* m_settings;
};

void addMenu(const Actions& actions, MenuId which, const char* icon, QMenu* to)
{
    QMenu* menu = to->addMenu(themedIcon(QLatin1StringView(icon)), actions.menuTitle(which));
    actions.fill(menu, which);
}
} // namespace

void addLooks(const Actions& actions, Viewport* viewport, Settings* settings, QMenu* viewMenu)
{
    const auto takeUp = [=] { viewport->setLook(settings->look()); };
    takeUp();
    settings->onReset(takeUp);
    const Looks looks(actions, viewport, settings);
    looks.addSwitches();
    looks.addChoices(QStringLiteral("material."), materials, &ViewLook::material);
    looks.addChoices(QStringLiteral("background."), backgrounds, &ViewLook::background);
    viewMenu->addSeparator();
    addMenu(actions, MenuId::Material, "material-clay", viewMenu);
    addMenu(actions, MenuId::Background, "background-theme", viewMenu);
    addMenu(actions, MenuId::Reference, "reference", viewMenu);
}
} // namespace ui
