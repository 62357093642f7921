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

/// The VR simulator's window during visits to VR: brings what mouse and keys do to the simulated headset, and its
/// pictures back. Thread: gui.
class SimulatorController : public QObject
{
    Q_OBJECT

public:
    /// After connectAll(). The window owns it and the simulator's window.
    SimulatorController(ui::MainWindow* window, SculptWorker* worker, std::unique_ptr<Simulator> simulator);

private:
    /// By ui::SimulatedHand.
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
    std::deque<Buttons> m_pendingButtons; ///< changes of buttons, not yet sent
    Buttons m_sentButtons;
    int m_picturesSince = 0;               ///< since the last was sent
    std::optional<vr::AvatarState> m_seen; ///< of the user in VR, last
    SimulatorGaze m_gaze;
    std::optional<core::SurfaceHit> m_hit; ///< of the model, under the mouse
};
} // namespace app
