#include "preferences_actions.h"

#include "actions.h"
#include "preferences_dialog.h"
#include "settings.h"
#include "theme.h"
#include "viewport.h"

#include <QAction>

namespace ui
{
void connectPreferences(const Actions& actions, Settings* settings, Viewport* viewport, QWidget* window)
{
    viewport->setHabits(settings->preferences().hand);
    auto* theme = new Theme(settings->preferences().theme, window);
    QObject::connect(actions.get(QStringLiteral("edit.preferences")), &QAction::triggered, window, [=] {
        auto* dialog = new PreferencesDialog(settings->preferences(), window);
        QObject::connect(dialog, &PreferencesDialog::changed, window, [=](const Preferences& preferences) {
            settings->setPreferences(preferences);
            theme->choose(preferences.theme);
            viewport->setHabits(preferences.hand);
        });
        dialog->open();
    });
}
} // namespace ui
