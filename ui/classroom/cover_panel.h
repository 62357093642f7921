#pragma once

#include <QFrame>

class QLayout;
class QVBoxLayout;

namespace ui
{
class CardScroll;

/// A panel that covers another widget completely and blocks its input, with a card in the middle. While the panel has
/// the focus, it consumes all keys except combinations with Alt, function keys and Quit; Tab cycles within the panel.
/// Hidden at first. Thread: gui.
class CoverPanel : public QFrame
{
    Q_OBJECT

public:
    explicit CoverPanel(QWidget* over);

    /// Hides the panel and gives the focus back to the covered widget.
    void close();

protected:
    /// Builds the card: `content`, which scrolls if there is too little room, above `buttons`, which are always
    /// visible. `width`: preferred width of the content in pixels, unless its size hint is wider.
    void setCard(QWidget* content, QLayout* buttons, int width);
    /// Shows the panel above the widget, with the same size.
    void cover();
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void showFocused(QWidget* now);

    QWidget* m_over;
    QVBoxLayout *m_column, *m_card = nullptr; ///< layout around the card; layout in the card
    CardScroll* m_scroll = nullptr;
};
} // namespace ui
