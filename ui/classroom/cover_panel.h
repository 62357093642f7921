#pragma once

#include <QFrame>

namespace ui
{
/// A panel that lies over all of a widget, which nobody reaches meanwhile. Hidden at first. Thread: gui.
class CoverPanel : public QFrame
{
    Q_OBJECT

public:
    explicit CoverPanel(QWidget* over);

    /// Gives the keys back to the widget below.
    void close();

protected:
    /// Shows it on top, as large as the widget below.
    void cover();
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* m_over;
};
} // namespace ui
