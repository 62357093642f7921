#include "ui/classroom/cover_panel.h"

#include <QEvent>

namespace ui
{
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

/// Takes the events that no button takes, which would reach the widget below.
bool CoverPanel::event(QEvent* event)
{
    switch (event->type()) {
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
} // namespace ui
