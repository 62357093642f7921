#include "app/headset/headset_connections.h"

#include "app/document/document.h"
#include "app/headset/avatar.h"
#include "app/headset/headset.h"
#include "app/headset/headset_settings_store.h"
#include "app/headset/runtime_probe.h"
#include "app/worker/sculpt_worker.h"

#include "ui/headset/partner_bar.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "vr/sculpt/sculpt_client.h"

#include <QAction>
#include <QMenu>

namespace app
{
namespace
{
std::shared_ptr<vr::FrameClient> makeClient(const std::shared_ptr<vr::DocumentPort>& port,
                                            const vr::HeadsetSettings& settings)
{
    return std::make_shared<vr::SculptClient>(port, settings);
}

/// Returns the state for the window's actions. A visit that is still starting can be left, too: a runtime may wait for
/// a headset that nobody puts on.
ui::HeadsetState stateOf(const vr::HeadsetReport& report)
{
    return report.isEnded() ? ui::HeadsetState::Out : ui::HeadsetState::In;
}

void connectVisits(ui::MainWindow& window, Headset* headset)
{
    using ui::MainWindow;
    QObject::connect(window.headset(), &ui::HeadsetActions::enterRequested, headset, &Headset::enter);
    QObject::connect(window.headset(), &ui::HeadsetActions::leaveRequested, headset, &Headset::leave);
    QObject::connect(headset, &Headset::leaving, &window,
                     [&window] { window.setHeadset(ui::HeadsetState::Changing, Headset::tr("Leaving VR…")); });
    QObject::connect(headset, &Headset::noticed, &window, &MainWindow::showNotice);
    QObject::connect(headset, &Headset::reported, &window, [&window](const vr::HeadsetReport& report) {
        window.setHeadset(stateOf(report), report.text);
        if (report.isEnded() && !report.text.isEmpty())
            window.showNotice(report.text);
    });
    QObject::connect(headset, &Headset::avatarChanged, window.viewport(),
                     [&window](const std::optional<vr::AvatarState>& avatar) {
                         window.viewport()->showAvatar(avatar ? std::optional(avatarOf(*avatar)) : std::nullopt);
                     });
}

/// Connects the actions by which the desktop user helps the headset user.
void connectPartner(ui::MainWindow& window, Headset* headset)
{
    QObject::connect(window.viewport()->spotlight(), &ui::PointerSpotlight::pointed, &headset->partner(),
                     &PartnerView::point);
    QObject::connect(window.action(QStringLiteral("vr.takeOver")), &QAction::toggled, &headset->partner(),
                     &PartnerView::setTakenOver);
    auto* bar = window.findChild<ui::PartnerBar*>();
    QObject::connect(headset, &Headset::avatarChanged, bar, [bar](const std::optional<vr::AvatarState>& avatar) {
        bar->setAvatar(avatar ? std::optional(avatarOf(*avatar)) : std::nullopt);
    });
}

/// Tells the desktop user when a stroke is refused because the headset user is sculpting. The headset user feels the
/// opposite case as haptics.
void connectRefusals(ui::MainWindow& window, Document& document, SculptWorker& worker)
{
    QObject::connect(&worker.strokes(), &StrokeGate::refused, &window, [&window, &document](Source source) {
        if (source == Source::Desktop && !document.job().isBusy())
            window.showNotice(
                Headset::tr("Somebody is sculpting in the headset: your turn comes when that stroke has ended."));
    });
}

/// Connects the actions for users who cannot reach the same settings in the headset. They take effect at the next
/// visit.
void connectHandednessActions(ui::MainWindow& window, Headset* headset)
{
    QAction* oneHand = window.action(QStringLiteral("vr.oneHand"));
    QAction* leftHanded = window.action(QStringLiteral("vr.leftHanded"));
    const auto show = [=] {
        const vr::WandSettings hands = HeadsetSettingsStore().load().wands;
        oneHand->setChecked(hands.preset == vr::ButtonPreset::OneHand);
        leftHanded->setChecked(hands.sculpting == vr::Side::Left);
        for (QAction* action : {oneHand, leftHanded})
            action->setEnabled(!headset->isActive());
    };
    const auto store = [=] {
        vr::HeadsetSettings settings = HeadsetSettingsStore().load();
        if (oneHand->isChecked() != (settings.wands.preset == vr::ButtonPreset::OneHand))
            settings.wands.preset = oneHand->isChecked() ? vr::ButtonPreset::OneHand : vr::WandSettings().preset;
        settings.wands.sculpting = leftHanded->isChecked() ? vr::Side::Left : vr::Side::Right;
        HeadsetSettingsStore().save(settings);
    };
    QObject::connect(oneHand, &QAction::triggered, headset, store);
    QObject::connect(leftHanded, &QAction::triggered, headset, store);
    for (QObject* place : oneHand->associatedObjects())
        if (auto* menu = qobject_cast<QMenu*>(place))
            QObject::connect(menu, &QMenu::aboutToShow, oneHand, show);
    show();
}
} // namespace

Headset* connectHeadset(ui::MainWindow& window, Document& document, SculptWorker& worker)
{
    auto* headset = new Headset({&document, &worker, &window}, makeClient, &window);
    auto* probe = new RuntimeProbe(&window);
    QObject::connect(window.action(QStringLiteral("vr.status")), &QAction::triggered, probe, [&window, headset, probe] {
        if (headset->isStuck())
            window.showNotice(vr::HeadsetReport::ended(vr::HeadsetEnd::StillNotResponding).text);
        else
            probe->start();
    });
    QObject::connect(probe, &RuntimeProbe::finished, &window, &ui::MainWindow::showNotice);
    connectHandednessActions(window, headset);
    connectVisits(window, headset);
    connectPartner(window, headset);
    connectRefusals(window, document, worker);
    return headset;
}
} // namespace app
