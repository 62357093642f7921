#include "ui/preferences/preferences_actions.h"

#include "ui/actions/actions.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/settings.h"
#include "ui/settings/stored_brush.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/side_column.h"
#include "ui/widgets/theme.h"

#include <QAction>
#include <QMainWindow>

namespace ui
{
namespace
{
void resetBrush(BrushSettings* brush, const Settings& settings)
{
    restoreBrush(settings, brush);
    brush->setRadiusShare(settings.get(&Setting::radiusShare));
}
} // namespace

void connectPreferences(const PreferencesContext& context)
{
    const auto [window, column, actions, settings, brush, viewport] = context;
    auto* theme = new Theme(settings->get<Preferences>().theme, window);
    const auto applySettings = [=] {
        const Preferences preferences = settings->get<Preferences>();
        theme->choose(preferences.theme);
        viewport->setReducesMotion(preferences.reducesMotion);
        viewport->input()->setInputPreferences(preferences.effectiveInput());
        actions->setKeys(preferences.keys);
    };
    applySettings();
    settings->onReset([=, bars = window->saveState(), panels = column->panelStates()] {
        applySettings();
        resetBrush(brush, *settings);
        window->restoreState(bars);
        column->setPanelStates(panels);
    });
    QObject::connect(actions->get(QStringLiteral("edit.preferences")), &QAction::triggered, window, [=] {
        auto* dialog = new PreferencesDialog(settings->get<Preferences>(), *actions, window);
        QObject::connect(dialog, &PreferencesDialog::changed, window, [=](const Preferences& preferences) {
            settings->set(preferences);
            applySettings();
        });
        QObject::connect(dialog, &PreferencesDialog::resetRequested, window, [=] {
            settings->reset();
            dialog->setPreferences(settings->get<Preferences>());
        });
        dialog->open();
    });
}
} // namespace ui
