#include "ui/classroom/cover_panel.h"

#include "ui/widgets/spacing.h"

#include <QApplication>
#include <QKeyEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int narrowWidth = 720, lowHeight = 520; ///< pixels; smaller panels get small margins

/// Returns true if the window may handle the key: combinations with Alt (mnemonics of buttons), function keys, Quit.
bool isLeftToTheWindow(const QKeyEvent& key)
{
    const bool isFunctionKey = key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35;
    return key.modifiers().testFlag(Qt::AltModifier) || key.key() == Qt::Key_Alt || isFunctionKey ||
           key.matches(QKeySequence::Quit);
}
} // namespace

/// A scroll area that takes its widget's full size if there is room.
class CardScroll : public QScrollArea
{
public:
    CardScroll(QWidget* content, int width) : m_width(width)
    {
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus);
        setWidget(content);
    }

    /// Sets the available width, pixels.
    void setRoom(int width)
    {
        m_room = width;
        updateGeometry();
    }
    QSize sizeHint() const override
    {
        const QSize hint = widget()->sizeHint();
        const int width = std::min(std::max(m_width, hint.width()), m_room);
        return {width, neededHeight(width)};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        const bool isDone = QScrollArea::eventFilter(watched, event);
        if (watched == widget() && event->type() == QEvent::LayoutRequest) {
            updateGeometry();
            placeBar();
        }
        return isDone;
    }
    void resizeEvent(QResizeEvent* event) override
    {
        QScrollArea::resizeEvent(event);
        placeBar();
    }

private:
    int neededHeight(int width) const
    {
        return widget()->hasHeightForWidth() ? widget()->heightForWidth(width) : widget()->sizeHint().height();
    }
    /// Shows the vertical scroll bar, with a gap beside it, only if the content is too high at full width. (Qt also
    /// keeps a bar that is needed only because the bar itself takes width.)
    void placeBar()
    {
        const bool isWider = widget()->minimumSizeHint().width() > width();
        const int room = height() - (isWider ? horizontalScrollBar()->sizeHint().height() : 0);
        const bool scrolls = neededHeight(width()) > room;
        setVerticalScrollBarPolicy(scrolls ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
        setViewportMargins(0, 0, scrolls ? gap / 2 : 0, 0);
    }

    int m_width, m_room = QWIDGETSIZE_MAX;
};

CoverPanel::CoverPanel(QWidget* over) : QFrame(over), m_over(over), m_column(new QVBoxLayout(this))
{
    m_column->setSizeConstraint(
        QLayout::SetNoConstraint); // the panel has the size of the covered widget, whatever the card's size
    setAutoFillBackground(true);
    over->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { showFocused(now); });
    hide();
}

void CoverPanel::setCard(QWidget* content, QLayout* buttons, int width)
{
    m_scroll = new CardScroll(content, width);
    auto* card = new QFrame;
    card->setFrameShape(QFrame::StyledPanel);
    m_card = new QVBoxLayout(card);
    m_card->setSpacing(gap);
    m_card->addWidget(m_scroll, 1);
    m_card->addLayout(buttons);
    m_column->addWidget(card, 0, Qt::AlignCenter);
}

void CoverPanel::cover()
{
    resize(m_over->size());
    show();
    raise();
}

void CoverPanel::close()
{
    if (isHidden())
        return;
    hide();
    m_over->setFocus();
}

/// Accepts events that no child accepted, so that they do not reach the covered widget.
bool CoverPanel::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride:
        event->setAccepted(!isLeftToTheWindow(*static_cast<QKeyEvent*>(event)));
        return true;
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
    case QEvent::TouchBegin:
    case QEvent::NativeGesture:
        event->accept();
        return true;
    default:
        return QFrame::event(event);
    }
}

bool CoverPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == m_over)
        resize(m_over->size());
    return QFrame::eventFilter(watched, event);
}

/// Reduces the card's margins if the panel is small.
void CoverPanel::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    if (!m_scroll)
        return;
    const bool isNarrow = width() < narrowWidth, isLow = height() < lowHeight;
    const int around = isNarrow || isLow ? 0 : gap, across = (isNarrow ? 1 : 3) * gap, down = (isLow ? 1 : 2) * gap;
    m_column->setContentsMargins(around, around, around, around);
    m_card->setContentsMargins(across, down, across, down);
    m_scroll->setRoom(width() - 2 * (around + across + m_card->parentWidget()->contentsMargins().left()));
}

/// Moves the focus to the next widget of the panel that accepts Tab, in the window's tab order; wraps around.
bool CoverPanel::focusNextPrevChild(bool next)
{
    QWidget* const from = focusWidget() ? focusWidget() : this;
    const auto beside = [next](const QWidget* w) { return next ? w->nextInFocusChain() : w->previousInFocusChain(); };
    for (QWidget* w = beside(from); w != from; w = beside(w)) {
        if (!isAncestorOf(w) || !w->isVisible() || !w->isEnabled() || w->focusProxy() ||
            (w->focusPolicy() & Qt::TabFocus) != Qt::TabFocus)
            continue;
        w->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
        return true;
    }
    return false;
}

/// Scrolls the focused widget into view. Not while a mouse button is down, because the widget would move away from the
/// pointer.
void CoverPanel::showFocused(QWidget* now)
{
    if (m_scroll && now && m_scroll->isAncestorOf(now) && QGuiApplication::mouseButtons() == Qt::NoButton)
        m_scroll->ensureWidgetVisible(now);
}
} // namespace ui
