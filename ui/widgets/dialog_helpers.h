#pragma once

#include <QString>

class QDialog;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui
{
// Functions that the small dialogs share. Thread: gui.

inline constexpr int dialogMargin = 16, dialogGap = 8; ///< of the window's spacing grid

/// Makes it a dialog of one column that is as large as what stands in it, and that deletes itself when it closes.
QVBoxLayout* beginDialog(QDialog* dialog, const char* name, const QString& title);

/// Adds a page to the dialog's column and returns the layout of that. It scrolls on a screen that is too low for it.
QVBoxLayout* addScrolledPage(QVBoxLayout* column);

/// Sentences that break at `width`.
QLabel* dialogText(const QString& sentences, int width);

/// Adds the last row: Cancel, and the accepting button, which is the default.
QPushButton* addDialogButtons(QDialog* dialog, const QString& verb);
} // namespace ui
