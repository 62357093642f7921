#pragma once

#include <QLabel>

namespace ui
{
/// A sentence of help at the top of the view, in one line if it fits between the corners. Thread: gui.
class ViewHint : public QLabel
{
public:
    /// Side of the square at the view's upper right that stays free for the cube that turns the view, pixels.
    static constexpr int corner = 96;

    ViewHint(const char* name, QWidget* view);

    /// Shows a text, centred in a view of this width.
    void showText(const QString& text, int viewWidth);
};
} // namespace ui
