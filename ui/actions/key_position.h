#pragma once

#include <Qt>

class QKeyEvent;

namespace ui
{
/// Returns the key that stands on a US keyboard where the pressed one is, if that has a letter of another script than
/// Latin, or is in the row of digits and has none: else 0. Of X11, Wayland and Windows. Thread: gui.
Qt::Key keyByPosition(const QKeyEvent& event);
} // namespace ui
