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

constexpr int ticksApart = 16; ///< milliseconds: about a frame of the simulated headset
/// A press is told when that before it was seen by a frame for certain: the next picture may be of one that had begun
/// before.
constexpr int picturesApart = 2;

QJsonObject poseOf(const Isometry3d& pose)
{
    const core::Vec3 place = pose.translation();
    const Eigen::Quaterniond turn(pose.linear());
    return {{QStringLiteral("position"), QJsonArray{place.x(), place.y(), place.z()}},
            {QStringLiteral("rotation"), QJsonArray{turn.x(), turn.y(), turn.z(), turn.w()}}};
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

SimulatorDesk::SimulatorDesk(ui::MainWindow* window, std::unique_ptr<Simulator> simulator)
    : QObject(window)
    , m_simulator(std::move(simulator))
    , m_headset(window->findChild<Headset*>())
    , m_window(new ui::SimulatorWindow(window))
{
    m_timer.setInterval(ticksApart);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &SimulatorDesk::tick);
    connect(m_headset, &Headset::reported, this, &SimulatorDesk::take);
    connect(m_window, &ui::SimulatorWindow::closed, m_headset, &Headset::leave);
    connect(m_window->view(), &ui::SimulatorView::buttonsChanged, this, &SimulatorDesk::noteButtons);
}

/// The window is there from a visit's first word to its last, unless it is closed, which ends the visit.
void SimulatorDesk::take(const vr::HeadsetReport& report)
{
    if (report.isEnded()) {
        m_timer.stop();
        m_window->hide();
    } else if (!m_timer.isActive()) {
        m_waiting.clear();
        m_told = {};
        m_picturesSince = picturesApart;
        m_window->begin();
        m_clock.start();
        m_timer.start();
        move();
    }
}

void SimulatorDesk::tick()
{
    m_window->view()->advance(static_cast<double>(m_clock.restart()) / 1000);
    takePicture();
    move();
}

void SimulatorDesk::takePicture()
{
    const QImage picture = m_simulator->picture();
    if (picture.isNull())
        return;
    ++m_picturesSince;
    m_window->view()->setPicture(picture);
}

void SimulatorDesk::noteButtons()
{
    const ui::SimulatorControls& controls = m_window->view()->controls();
    m_waiting.push_back({controls.buttons(SimulatedHand::Left), controls.buttons(SimulatedHand::Right)});
}

/// Head and wands are as they are now. Buttons go one change after the other, each for a frame at least: a click may be
/// quicker than a frame that is drawn in software.
void SimulatorDesk::move()
{
    const ui::SimulatorControls& controls = m_window->view()->controls();
    if (!m_waiting.empty() && m_picturesSince >= picturesApart) {
        m_told = m_waiting.front();
        m_waiting.pop_front();
        m_picturesSince = 0;
    }
    QJsonObject step{{QStringLiteral("over"), 1}, {QStringLiteral("head"), poseOf(controls.head())}};
    for (const SimulatedHand hand : {SimulatedHand::Left, SimulatedHand::Right}) {
        const Isometry3d grip = controls.tip(hand) * Eigen::Translation3d(0, 0, vr::tipReach);
        QJsonObject wand = poseOf(grip);
        ui::SimulatedButtons buttons = m_told[indexOf(hand)];
        if (buttons.touchesPad && !buttons.pressesPad)
            buttons.pad = controls.buttons(hand).pad; // a thumb that slides
        add(wand, buttons);
        step[hand == SimulatedHand::Left ? QStringLiteral("left") : QStringLiteral("right")] = wand;
    }
    m_simulator->obey(step);
}
} // namespace app
