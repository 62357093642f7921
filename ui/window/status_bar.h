#pragma once

#include <QStatusBar>

namespace ui
{
/// A status bar that elides its message where the widgets at the right begin, and does not keep a window from becoming
/// narrow. Thread: gui.
class StatusBar : public QStatusBar
{
public:
    StatusBar() { setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); }

protected:
    void paintEvent(QPaintEvent* event) override;
};
} // namespace ui
