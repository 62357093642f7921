#pragma once

#include <QFrame>

namespace ui
{
/// A panel that lies over all of a widget, which nobody reaches meanwhile. While the focus
/// is inside, keys are the card's, too: of the window's shortcuts those with Alt, the function keys and Quit are left,
/// and Tab goes round within the panel. Hidden at first. Thread: gui.
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
    bool focusNextPrevChild(bool next) override;

private:
    QWidget* m_over;
};
} // namespace ui
