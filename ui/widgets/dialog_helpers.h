#pragma once

#include <QString>

class QDialog;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui
{
// Helper functions of the small dialogs. Thread: gui.

inline constexpr int dialogMargin = 16, dialogGap = 8; ///< pixels, on the window's spacing grid

/// Sets up a dialog with one column that fits its contents, and that is deleted when closed. Returns the column.
QVBoxLayout* beginDialog(QDialog* dialog, const char* name, const QString& title);

/// Adds a page to the dialog's column and returns the page's layout. The page scrolls if the screen is too low for it.
QVBoxLayout* addScrolledPage(QVBoxLayout* column);

/// Returns a label that wraps the sentences at `width` pixels.
QLabel* dialogText(const QString& sentences, int width);

/// Adds the last row with Cancel and the accepting button, which is the default. Returns the accepting button.
QPushButton* addDialogButtons(QDialog* dialog, const QString& verb);
} // namespace ui
