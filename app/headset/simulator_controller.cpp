#include "app/headset/simulator_controller.h"

#include "app/headset/headset.h"
#include "app/headset/headset_settings_store.h"
#include "app/worker/sculpt_worker.h"

#include "ui/headset/simulator_view.h"
#include "ui/headset/simulator_window.h"
#include "ui/settings/brush_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "vr/openxr/wand_state.h"

#include <QJsonArray>

#include <algorithm>
#include <utility>

namespace app
{
namespace
{
using Eigen::Isometry3d;
using ui::SimulatedHand;

constexpr int tickMs = 16; ///< ms; about one frame of the simulated headset
/// A button change is sent two pictures after the previous one: the first picture may be of a frame that had begun
/// before.
constexpr int minPicturesApart = 2;

QJsonObject poseOf(const Isometry3d& pose)
{
    const core::Vec3 position = pose.translation();
    const Eigen::Quaterniond rotation(pose.linear());
    return {{QStringLiteral("position"), QJsonArray{position.x(), position.y(), position.z()}},
            {QStringLiteral("rotation"), QJsonArray{rotation.x(), rotation.y(), rotation.z(), rotation.w()}}};
}

void add(QJsonObject& wand, const ui::SimulatedButtons& buttons)
{
    wand[QStringLiteral("trigger")] = buttons.trigger;
    wand[QStringLiteral("squeeze")] = buttons.squeezes;
    wand[QStringLiteral("menu")] = buttons.pressesMenu;
    wand[QStringLiteral("pad")] = QJsonArray{buttons.pad.x(), buttons.pad.y()};
    wand[QStringLiteral("pad_touch")] = buttons.touchesPad;
    wand[QStringLiteral("pad_press")] = buttons.pressesPad;
}

vr::Side sideOf(SimulatedHand hand)
{
    return hand == SimulatedHand::Left ? vr::Side::Left : vr::Side::Right;
}

std::size_t indexOf(SimulatedHand hand)
{
    return static_cast<std::size_t>(hand);
}
} // namespace

SimulatorController::SimulatorController(ui::MainWindow* window, SculptWorker* worker,
                                         std::unique_ptr<Simulator> simulator)
    : QObject(window)
    , m_simulator(std::move(simulator))
    , m_worker(worker)
    , m_main(window)
    , m_headset(window->findChild<Headset*>())
    , m_window(new ui::SimulatorWindow(window))
{
    m_timer.setInterval(tickMs);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SimulatorController::tick);
    connect(m_headset, &Headset::reported, this, &SimulatorController::onReport);
    connect(m_headset, &Headset::avatarChanged, this, &SimulatorController::onAvatar);
    connect(worker, &SculptWorker::answeredSimulator, this,
            [this](const std::optional<core::SurfaceHit>& hit) { m_hit = hit; });
    connect(m_window, &ui::SimulatorWindow::closed, m_headset, &Headset::leave);
    connect(m_window->view(), &ui::SimulatorView::headTurned, this, [this] { m_gaze.cancel(); });
    connect(m_window->view(), &ui::SimulatorView::buttonsChanged, this, &SimulatorController::queueButtons);
}

/// Shows the window from the first report of a visit to its last. Closing the window ends the visit.
void SimulatorController::onReport(const vr::HeadsetReport& report)
{
    if (report.isEnded()) {
        m_timer.stop();
        m_window->hide();
    } else if (!m_timer.isActive()) {
        m_pendingButtons.clear();
        m_sentButtons = {};
        m_picturesSince = minPicturesApart;
        m_seen.reset();
        m_hit.reset();
        m_gaze = {};
        m_window->begin();
        m_clock.start();
        m_timer.start();
        move();
    }
}

/// When a panel opens at the hand moved by the mouse, gives the mouse to the other hand, which can point at the panel.
/// Otherwise a hand over the model would move the panel out of view.
void SimulatorController::onAvatar(const std::optional<vr::AvatarState>& avatar)
{
    const auto carriesPanel = [side = sideOf(m_window->view()->controls().hand())](const auto& seen) {
        return seen && std::ranges::count(seen->panels, side, &vr::PanelTarget::carrier) > 0;
    };
    const bool isOpened = carriesPanel(avatar) && !carriesPanel(m_seen);
    m_seen = avatar;
    if (isOpened)
        m_window->view()->changeHand();
}

void SimulatorController::tick()
{
    const double seconds = static_cast<double>(m_clock.restart()) / 1000;
    m_window->view()->advance(seconds);
    if (m_seen && m_seen->head) {
        const bool isAtOnce = m_main->viewport()->reducesMotion();
        m_window->view()->turnHead(
            m_gaze.step(m_seen->panels, *m_seen->head, ui::SimulatorControls::sideTangent, isAtOnce ? 0 : seconds), 0);
    }
    if (const QImage picture = m_simulator->picture(); !picture.isNull()) {
        ++m_picturesSince;
        m_window->view()->setPicture(picture);
    }
    look();
    move();
}

/// Asks for the surface under the mouse, and moves the wand to the latest known surface of model or panels.
void SimulatorController::look()
{
    if (!m_seen || !m_seen->head)
        return;
    const core::Ray sight = sightInRoom();
    const Eigen::Affine3d toModel = m_seen->model.inverse();
    m_worker->ask(Source::Simulator, {toModel * sight.origin, toModel.linear() * sight.direction});
    const bool isRay = m_main->brush()->stroke().brush == core::BrushShape::Ray;
    m_window->view()->meet(surfaceUnderMouse(), following(), isRay);
}

/// Returns the ray under the mouse in room space, which differs from the simulator's space after the user has recentred
/// it.
core::Ray SimulatorController::sightInRoom() const
{
    const ui::SimulatorControls& controls = m_window->view()->controls();
    const Eigen::Affine3d toRoom = m_seen->head->matrix() * controls.head().inverse();
    const core::Ray sight = controls.sight();
    return {toRoom * sight.origin, toRoom.linear() * sight.direction};
}

/// Returns the nearest of model and panels under the mouse; nothing if there is none.
std::optional<ui::SimulatorControls::Surface> SimulatorController::surfaceUnderMouse() const
{
    using Surface = ui::SimulatorControls::Surface;
    const ui::SimulatorControls& controls = m_window->view()->controls();
    const core::Ray sight = sightInRoom();
    std::optional<Surface> nearest;
    if (m_hit)
        nearest = Surface{(m_seen->model * m_hit->position - sight.origin).norm(), false};
    for (const vr::PanelTarget& panel : m_seen->panels) {
        const bool isCarried = panel.carrier && sideOf(controls.hand()) == *panel.carrier;
        const std::optional<vr::PlanePoint> point = vr::intersect(sight, panel.pose);
        if (!isCarried && point && (2 * point->at.cwiseAbs() - panel.size).maxCoeff() <= 0 &&
            (!nearest || point->distance < nearest->distance))
            nearest = Surface{point->distance, true};
    }
    return nearest;
}

/// Returns how the wand follows the surface. It does not follow while something is grabbed, because that moves with the
/// hand.
ui::SimulatorControls::Following SimulatorController::following() const
{
    using Following = ui::SimulatorControls::Following;
    const ui::SimulatorControls& controls = m_window->view()->controls();
    if (controls.buttons(SimulatedHand::Left).squeezes || controls.buttons(SimulatedHand::Right).squeezes)
        return Following::Not;
    if (controls.buttons(controls.hand()).trigger == 0)
        return Following::Freely;
    const bool sculpts = sideOf(controls.hand()) == HeadsetSettingsStore().load().wands.sculpting;
    return sculpts && !core::isDragTool(m_main->brush()->tool()) ? Following::WithTheMouse : Following::Not;
}

void SimulatorController::queueButtons()
{
    const ui::SimulatorControls& controls = m_window->view()->controls();
    m_pendingButtons.push_back({controls.buttons(SimulatedHand::Left), controls.buttons(SimulatedHand::Right)});
}

/// Sends the present poses of head and wands. Button changes are sent one at a time, each for at least one frame,
/// because a click may be shorter than a frame drawn in software.
void SimulatorController::move()
{
    const ui::SimulatorControls& controls = m_window->view()->controls();
    if (!m_pendingButtons.empty() && m_picturesSince >= minPicturesApart) {
        m_sentButtons = m_pendingButtons.front();
        m_pendingButtons.pop_front();
        m_picturesSince = 0;
    }
    QJsonObject step{{QStringLiteral("over"), 1}, {QStringLiteral("head"), poseOf(controls.head())}};
    for (const SimulatedHand hand : {SimulatedHand::Left, SimulatedHand::Right}) {
        const Isometry3d grip = controls.tip(hand) * Eigen::Translation3d(0, 0, vr::tipReach);
        QJsonObject wand = poseOf(grip);
        ui::SimulatedButtons buttons = m_sentButtons[indexOf(hand)];
        if (buttons.touchesPad && !buttons.pressesPad)
            buttons.pad = controls.buttons(hand).pad; // the thumb slides on the touchpad
        add(wand, buttons);
        step[hand == SimulatedHand::Left ? QStringLiteral("left") : QStringLiteral("right")] = wand;
    }
    m_simulator->apply(step);
}
} // namespace app
