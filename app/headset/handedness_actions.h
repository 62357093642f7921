#pragma once

namespace ui
{
class MainWindow;
}

namespace app
{
class Headset;

/// The VR menu's two words about hands, for who could not reach the panel in the headset that says the same: they hold
/// from the next visit on. Gui thread.
void wireHeadsetHands(ui::MainWindow& window, Headset* headset);
} // namespace app
