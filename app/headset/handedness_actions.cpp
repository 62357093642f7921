#include "app/headset/handedness_actions.h"

#include "app/headset/headset.h"
#include "app/headset/headset_settings.h"

#include "ui/window/main_window.h"

#include <QAction>
#include <QMenu>

namespace app
{
void wireHeadsetHands(ui::MainWindow& window, Headset* headset)
{
    QAction* oneHand = window.action(QStringLiteral("vr.oneHand"));
    QAction* leftHanded = window.action(QStringLiteral("vr.leftHanded"));
    const auto show = [=] {
        const vr::WandSettings hands = HeadsetSettings().choice().wands;
        oneHand->setChecked(hands.preset == vr::ButtonPreset::OneHand);
        leftHanded->setChecked(hands.sculpting == vr::Side::Left);
        for (QAction* action : {oneHand, leftHanded})
            action->setEnabled(!headset->isIn());
    };
    const auto choose = [=] {
        vr::HeadsetSettings choice = HeadsetSettings().choice();
        if (oneHand->isChecked() != (choice.wands.preset == vr::ButtonPreset::OneHand))
            choice.wands.preset = oneHand->isChecked() ? vr::ButtonPreset::OneHand : vr::WandSettings().preset;
        choice.wands.sculpting = leftHanded->isChecked() ? vr::Side::Left : vr::Side::Right;
        HeadsetSettings().setChoice(choice);
    };
    QObject::connect(oneHand, &QAction::triggered, headset, choose);
    QObject::connect(leftHanded, &QAction::triggered, headset, choose);
    for (QObject* place : oneHand->associatedObjects())
        if (auto* menu = qobject_cast<QMenu*>(place))
            QObject::connect(menu, &QMenu::aboutToShow, oneHand, show);
    show();
}
} // namespace app
