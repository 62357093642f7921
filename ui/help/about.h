#pragma once

class QWidget;

namespace ui
{
/// Shows a dialog with the program's purpose and version. Returns at once.
void showAbout(QWidget* parent);
} // namespace ui
