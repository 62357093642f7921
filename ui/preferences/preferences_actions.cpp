#include "ui/preferences/preferences_actions.h"

#include "ui/actions/actions.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/settings/brush_settings.h"
#include "ui/settings/settings.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/theme.h"

#include <QAction>
#include <QMainWindow>

namespace ui
{
namespace
{
void resetBrush(BrushSettings* brush, const Settings& settings)
{
    for (const core::Parameter parameter : storedParameters)
        brush->setValue(parameter, settings.value(parameter));
    brush->setRadiusShare(settings.radiusShare());
}
} // namespace

void connectPreferences(const PreferencesPlace& place)
{
    const auto [window, actions, settings, brush, viewport] = place;
    auto* theme = new Theme(settings->preferences().theme, window);
    const auto takeUp = [=] {
        const Preferences preferences = settings->preferences();
        theme->choose(preferences.theme);
        viewport->setCalm(preferences.isCalm);
        viewport->setHabits(preferences.habits());
        actions->setKeys(preferences.keys);
    };
    takeUp();
    settings->onReset([=, panels = window->saveState()] {
        takeUp();
        resetBrush(brush, *settings);
        window->restoreState(panels);
    });
    QObject::connect(actions->get(QStringLiteral("edit.preferences")), &QAction::triggered, window, [=] {
        auto* dialog = new PreferencesDialog(settings->preferences(), *actions, window);
        QObject::connect(dialog, &PreferencesDialog::changed, window, [=](const Preferences& preferences) {
            settings->setPreferences(preferences);
            takeUp();
        });
        QObject::connect(dialog, &PreferencesDialog::resetRequested, window, [=] {
            settings->reset();
            dialog->setPreferences(settings->preferences());
        });
        dialog->open();
    });
}
} // namespace ui
