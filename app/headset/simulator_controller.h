#pragma once

#include "app/headset/simulator.h"
#include "app/headset/simulator_gaze.h"

#include "ui/headset/simulator_controls.h"
#include "vr/frame/headset_report.h"
#include "vr/sculpt/document_port.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>
#include <deque>
#include <memory>
#include <optional>

namespace ui
{
class MainWindow;
class SimulatorWindow;
} // namespace ui

namespace app
{
class Headset;
class SculptWorker;

/// Controls the simulator's window during visits to VR. Sends mouse and keys to the simulated headset, and shows its
/// pictures. Thread: gui.
class SimulatorController : public QObject
{
    Q_OBJECT

public:
    /// Must be made after connectAll(). `window` owns this and the simulator's window.
    SimulatorController(ui::MainWindow* window, SculptWorker* worker, std::unique_ptr<Simulator> simulator);

private:
    /// Indexed by ui::SimulatedHand.
    using Buttons = std::array<ui::SimulatedButtons, ui::simulatedHandCount>;

    void onReport(const vr::HeadsetReport& report);
    void onAvatar(const std::optional<vr::AvatarState>& avatar);
    void tick();
    void queueButtons();
    void move();
    void look();
    core::Ray sightInRoom() const;
    std::optional<ui::SimulatorControls::Surface> surfaceUnderMouse() const;
    ui::SimulatorControls::Following following() const;

    std::unique_ptr<Simulator> m_simulator;
    SculptWorker* m_worker;
    ui::MainWindow* m_main;
    Headset* m_headset;
    ui::SimulatorWindow* m_window;
    QTimer m_timer; ///< runs during a visit
    QElapsedTimer m_clock;
    std::deque<Buttons> m_pendingButtons; ///< button changes not sent yet, in order
    Buttons m_sentButtons;
    int m_picturesSince = 0;               ///< number of pictures since the last button change was sent
    std::optional<vr::AvatarState> m_seen; ///< state of the user in VR in the latest frame
    SimulatorGaze m_gaze;
    std::optional<core::SurfaceHit> m_hit; ///< where the ray under the mouse meets the model; nullopt: nowhere
};
} // namespace app
