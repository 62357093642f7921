#pragma once

#include <QFrame>

class QLayout;
class QVBoxLayout;

namespace ui
{
class CardScroll;

/// A panel that lies over all of a widget, which nobody reaches meanwhile, with a card in its middle. While the focus
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
    /// Makes the card: `content`, which scrolls where it has no room, and `buttons` below, which stay in sight.
    /// `width`: pixels that the content takes where there is room; more, if its own hint is larger.
    void setCard(QWidget* content, QLayout* buttons, int width);
    /// Shows it on top, as large as the widget below.
    void cover();
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void showFocused(QWidget* now);

    QWidget* m_over;
    QVBoxLayout *m_column, *m_card = nullptr; ///< around the card, and in it
    CardScroll* m_scroll = nullptr;
};
} // namespace ui
