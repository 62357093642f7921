#pragma once

class QDockWidget;

namespace ui
{
class TurntableMotor;

/// A dock with the turntable's switch, direction and speed. The turntable is not owned.
QDockWidget* makeTurntablePanel(TurntableMotor* turntable);
} // namespace ui
