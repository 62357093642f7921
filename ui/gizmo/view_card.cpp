#include "ui/gizmo/view_card.h"

#include "ui/widgets/spacing.h"

#include <QEvent>

namespace ui
{
ViewCard::ViewCard(QWidget* view, const char* name) : QFrame(view)
{
    setObjectName(QLatin1StringView(name));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    hide();
    view->installEventFilter(this);
}

bool ViewCard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void ViewCard::showEvent(QShowEvent* event)
{
    QFrame::showEvent(event);
    place();
    raise();
}

void ViewCard::place()
{
    adjustSize();
    move(parentWidget()->width() - width() - gap, parentWidget()->height() - height() - gap);
}
} // namespace ui
