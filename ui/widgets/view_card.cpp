#include "ui/widgets/view_card.h"

#include "ui/widgets/spacing.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>

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

void ViewCard::keyPressEvent(QKeyEvent* event)
{
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isReturn)
        return QFrame::keyPressEvent(event);
    if (auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget()); button && isAncestorOf(button))
        return button->click();
    parentWidget()->setFocus();
    Q_EMIT entered();
}

void ViewCard::place()
{
    adjustSize();
    move(parentWidget()->width() - width() - gap, parentWidget()->height() - height() - gap);
}
} // namespace ui
