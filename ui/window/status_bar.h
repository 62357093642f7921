#pragma once

#include <QStatusBar>

namespace ui
{
/// A status bar that elides its message where the widgets at the right begin. Thread: gui.
class StatusBar : public QStatusBar
{
public:
    using QStatusBar::QStatusBar;

protected:
    void paintEvent(QPaintEvent* event) override;
};
} // namespace ui
