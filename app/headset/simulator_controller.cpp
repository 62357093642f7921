#include "app/headset/simulator_controller.h"

#include "app/headset/headset.h"

#include "ui/headset/simulator_view.h"
#include "ui/headset/simulator_window.h"
#include "ui/window/main_window.h"
#include "vr/openxr/wand_state.h"

#include <QJsonArray>

#include <utility>

namespace app
{
namespace
{
using Eigen::Isometry3d;
using ui::SimulatedHand;

constexpr int tickMs = 16; ///< milliseconds: about a frame of the simulated headset
/// A press is sent when the one before it was certainly seen by a frame: the next picture may be of one that had begun
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

std::size_t indexOf(SimulatedHand hand)
{
    return static_cast<std::size_t>(hand);
}
} // namespace

SimulatorController::SimulatorController(ui::MainWindow* window, std::unique_ptr<Simulator> simulator)
    : QObject(window)
    , m_simulator(std::move(simulator))
    , m_headset(window->findChild<Headset*>())
    , m_window(new ui::SimulatorWindow(window))
{
    m_timer.setInterval(tickMs);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SimulatorController::tick);
    connect(m_headset, &Headset::reported, this, &SimulatorController::onReport);
    connect(m_window, &ui::SimulatorWindow::closed, m_headset, &Headset::leave);
    connect(m_window->view(), &ui::SimulatorView::buttonsChanged, this, &SimulatorController::queueButtons);
}

/// The window is there from a visit's first word to its last, unless it is closed, which ends the visit.
void SimulatorController::onReport(const vr::HeadsetReport& report)
{
    if (report.isEnded()) {
        m_timer.stop();
        m_window->hide();
    } else if (!m_timer.isActive()) {
        m_pendingButtons.clear();
        m_sentButtons = {};
        m_picturesSince = minPicturesApart;
        m_window->begin();
        m_clock.start();
        m_timer.start();
        move();
    }
}

void SimulatorController::tick()
{
    m_window->view()->advance(static_cast<double>(m_clock.restart()) / 1000);
    if (const QImage picture = m_simulator->picture(); !picture.isNull()) {
        ++m_picturesSince;
        m_window->view()->setPicture(picture);
    }
    move();
}

void SimulatorController::queueButtons()
{
    const ui::SimulatorControls& controls = m_window->view()->controls();
    m_pendingButtons.push_back({controls.buttons(SimulatedHand::Left), controls.buttons(SimulatedHand::Right)});
}

/// Head and wands are as they are now. Buttons go one change after the other, each for a frame at least: a click may be
/// quicker than a frame that is drawn in software.
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
            buttons.pad = controls.buttons(hand).pad; // a thumb that slides
        add(wand, buttons);
        step[hand == SimulatedHand::Left ? QStringLiteral("left") : QStringLiteral("right")] = wand;
    }
    m_simulator->apply(step);
}
} // namespace app
