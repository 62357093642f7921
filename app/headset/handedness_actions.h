#pragma once

namespace ui
{
class MainWindow;
}

namespace app
{
class Headset;

/// Connects the two handedness actions of the VR menu, for users who cannot reach the same setting in the headset. They
/// apply from the next visit on. Thread: gui.
void connectHandednessActions(ui::MainWindow& window, Headset* headset);
} // namespace app
