#include "ui/classroom/cover_panel.h"

#include <QKeyEvent>

namespace ui
{
namespace
{
/// Says of a key that the window has it. Alt leads to the buttons of the panel, and of the window.
bool isLeftToTheWindow(const QKeyEvent& key)
{
    const bool isFunctionKey = key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35;
    return key.modifiers().testFlag(Qt::AltModifier) || key.key() == Qt::Key_Alt || isFunctionKey ||
           key.matches(QKeySequence::Quit);
}
} // namespace

CoverPanel::CoverPanel(QWidget* over) : QFrame(over), m_over(over)
{
    setAutoFillBackground(true);
    over->installEventFilter(this);
    hide();
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

/// Goes round: nobody leaves the panel by Tab. The next in the window's order that has the focus by Tab, as Qt does.
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
} // namespace ui
