#pragma once

#include <QSinglePointEvent>

namespace ui
{
/// Returns the event as one of a mouse or a pen that presses, moves or releases; null if it is none.
inline const QSinglePointEvent* pointerEventIn(const QEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::TabletMove:
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
        return static_cast<const QSinglePointEvent*>(&event);
    default:
        return nullptr;
    }
}

/// Returns whether the event presses a button. Qt calls a double click an update.
inline bool isPress(const QSinglePointEvent& event)
{
    return event.isBeginEvent() || event.type() == QEvent::MouseButtonDblClick;
}
} // namespace ui
