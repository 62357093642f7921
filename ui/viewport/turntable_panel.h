#pragma once

class QDockWidget;

namespace ui
{
class Turntable;

/// A dock with the turntable's switch, direction and speed. The turntable is not owned.
QDockWidget* makeTurntablePanel(Turntable* turntable);
} // namespace ui
