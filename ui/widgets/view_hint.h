#pragma once

#include <QLabel>

namespace ui
{
/// A sentence of help at the top of the view, in one line if it fits. Thread: gui.
class ViewHint : public QLabel
{
public:
    ViewHint(const char* name, QWidget* view);

    /// Shows a text, centred in a view of this width.
    void showText(const QString& text, int viewWidth);
};
} // namespace ui
