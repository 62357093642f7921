#pragma once

#include "app/headset/simulator.h"

#include "ui/headset/simulator_controls.h"
#include "vr/frame/headset_report.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>
#include <deque>

namespace ui
{
class MainWindow;
class SimulatorWindow;
} // namespace ui

namespace app
{
class Headset;

/// The VR simulator's window during visits to VR: brings what mouse and keys do to the simulated headset, and its
/// pictures back. Thread: gui.
class SimulatorController : public QObject
{
    Q_OBJECT

public:
    /// After connectAll(). The window owns it and the simulator's window.
    SimulatorController(ui::MainWindow* window, std::unique_ptr<Simulator> simulator);

private:
    /// By ui::SimulatedHand.
    using Buttons = std::array<ui::SimulatedButtons, ui::simulatedHandCount>;

    void onReport(const vr::HeadsetReport& report);
    void tick();
    void queueButtons();
    void move();

    std::unique_ptr<Simulator> m_simulator;
    Headset* m_headset;
    ui::SimulatorWindow* m_window;
    QTimer m_timer; ///< runs during a visit
    QElapsedTimer m_clock;
    std::deque<Buttons> m_pendingButtons; ///< changes of buttons, not yet sent
    Buttons m_sentButtons;
    int m_picturesSince = 0; ///< since the last was sent
};
} // namespace app
