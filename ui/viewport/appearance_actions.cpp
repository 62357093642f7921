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
    bool ViewAppearance::*what;
};
constexpr Switch switches[] = {{"view.wireframe", &ViewAppearance::wireframe},
                               {"view.flat", &ViewAppearance::flat},
                               {"view.cavity", &ViewAppearance::cavity},
                               {"view.tint", &ViewAppearance::tint},
                               {"view.symmetryPlane", &ViewAppearance::symmetryPlane},
                               {"view.ground", &ViewAppearance::ground},
                               {"view.scaleBar", &ViewAppearance::scaleBar},
                               {"view.navigationCube", &ViewAppearance::navigationCube},
                               {"view.caption", &ViewAppearance::caption}};

/// Connects actions with the viewport's appearance, and stores each change in the settings.
class AppearanceActions
{
public:
    AppearanceActions(const Actions& actions, Viewport* viewport, Settings* settings)
        : m_actions(actions)
        , m_viewport(viewport)
        , m_settings(settings)
    {}

    void addSwitches() const
    {
        for (const Switch& row : switches) {
            QAction* action = m_actions.get(QLatin1StringView(row.id));
            const auto show = [action, viewport = m_viewport, what = row.what] {
                action->setChecked(viewport->appearance().*what);
            };
            show();
            m_settings->onReset(show);
            connect(action, [what = row.what](ViewAppearance& appearance, bool on) { appearance.*what = on; });
        }
    }

    template <class T, std::size_t count>
    void addChoices(const QString& family, const std::array<Named<T>, count>& choices, T ViewAppearance::*what) const
    {
        auto* group = new QActionGroup(m_viewport);
        for (const Named<T>& choice : choices) {
            QAction* action = m_actions.get(family + QLatin1StringView(choice.key));
            group->addAction(action);
            const auto show = [action, viewport = m_viewport, what, value = choice.value] {
                action->setChecked(viewport->appearance().*what == value);
            };
            show();
            m_settings->onReset(show);
            connect(action, [what, value = choice.value](ViewAppearance& appearance, bool on) {
                if (on)
                    appearance.*what = value;
            });
        }
    }

private:
    template <class Change> void connect(QAction* action, Change change) const
    {
        QObject::connect(action, &QAction::toggled, m_viewport,
                         [viewport = m_viewport, settings = m_settings, change](bool on) {
                             ViewAppearance appearance = viewport->appearance();
                             change(appearance, on);
                             viewport->setAppearance(appearance);
                             settings->set(appearance);
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

void addAppearanceActions(const Actions& actions, Viewport* viewport, Settings* settings, QMenu* viewMenu)
{
    const auto applySettings = [=] { viewport->setAppearance(settings->get<ViewAppearance>()); };
    applySettings();
    settings->onReset(applySettings);
    const AppearanceActions appearanceActions(actions, viewport, settings);
    appearanceActions.addSwitches();
    appearanceActions.addChoices(QStringLiteral("material."), materials, &ViewAppearance::material);
    appearanceActions.addChoices(QStringLiteral("background."), backgrounds, &ViewAppearance::background);
    viewMenu->addSeparator();
    addMenu(actions, MenuId::Material, "material-clay", viewMenu);
    addMenu(actions, MenuId::Background, "background-theme", viewMenu);
    addMenu(actions, MenuId::Reference, "reference", viewMenu);
}
} // namespace ui
