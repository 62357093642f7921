#pragma once

class QWidget;

namespace ui
{
/// What this program is, and its version. Returns at once.
void showAbout(QWidget* parent);
} // namespace ui
