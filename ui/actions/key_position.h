#pragma once

#include <Qt>

class QKeyEvent;

namespace ui
{
/// Returns the key at the same position of a US keyboard. Applies if the pressed key types a letter of a non-Latin
/// script, or if it is in the digit row and types no digit; otherwise returns 0. Supports X11, Wayland and Windows.
/// Thread: gui.
Qt::Key keyByPosition(const QKeyEvent& event);
} // namespace ui
