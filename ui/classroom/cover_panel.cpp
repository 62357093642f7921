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
constexpr int narrowWidth = 720, lowHeight = 520; ///< pixels, below which margins are small

/// Returns whether the key is left to the window. Alt leads to the buttons of the panel, and of the window.
bool isLeftToTheWindow(const QKeyEvent& key)
{
    const bool isFunctionKey = key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35;
    return key.modifiers().testFlag(Qt::AltModifier) || key.key() == Qt::Key_Alt || isFunctionKey ||
           key.matches(QKeySequence::Quit);
}
} // namespace

/// A scroll area as large as its widget where there is room.
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

    /// Sets how much room there is across, in pixels.
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
    /// Shows the upright bar, and a gap beside it, if the whole width makes it necessary. (Qt's own choice keeps a bar
    /// that only the narrower width beside it needs.)
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
        QLayout::SetNoConstraint); // it is as large as the widget below, whatever the card needs
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

/// Takes the events that no child takes, which would reach the widget below.
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

/// Leaves the card its margins only where there is room for them.
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

/// Moves the focus round within the panel: to the next in the window's order that takes it by Tab, as Qt does.
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

/// Brings what has the focus into sight; while a mouse button is down it would move away under the pointer.
void CoverPanel::showFocused(QWidget* now)
{
    if (m_scroll && now && m_scroll->isAncestorOf(now) && QGuiApplication::mouseButtons() == Qt::NoButton)
        m_scroll->ensureWidgetVisible(now);
}
} // namespace ui
