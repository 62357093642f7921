#include "app/headset/handedness_actions.h"

#include "app/headset/headset.h"
#include "app/headset/headset_settings.h"

#include "ui/window/main_window.h"

#include <QAction>
#include <QMenu>

namespace app
{
void connectHandednessActions(ui::MainWindow& window, Headset* headset)
{
    QAction* oneHand = window.action(QStringLiteral("vr.oneHand"));
    QAction* leftHanded = window.action(QStringLiteral("vr.leftHanded"));
    const auto show = [=] {
        const vr::WandSettings hands = HeadsetSettings().load().wands;
        oneHand->setChecked(hands.preset == vr::ButtonPreset::OneHand);
        leftHanded->setChecked(hands.sculpting == vr::Side::Left);
        for (QAction* action : {oneHand, leftHanded})
            action->setEnabled(!headset->isActive());
    };
    const auto store = [=] {
        vr::HeadsetSettings settings = HeadsetSettings().load();
        if (oneHand->isChecked() != (settings.wands.preset == vr::ButtonPreset::OneHand))
            settings.wands.preset = oneHand->isChecked() ? vr::ButtonPreset::OneHand : vr::WandSettings().preset;
        settings.wands.sculpting = leftHanded->isChecked() ? vr::Side::Left : vr::Side::Right;
        HeadsetSettings().save(settings);
    };
    QObject::connect(oneHand, &QAction::triggered, headset, store);
    QObject::connect(leftHanded, &QAction::triggered, headset, store);
    for (QObject* place : oneHand->associatedObjects())
        if (auto* menu = qobject_cast<QMenu*>(place))
            QObject::connect(menu, &QMenu::aboutToShow, oneHand, show);
    show();
}
} // namespace app
