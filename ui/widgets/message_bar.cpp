#include "ui/widgets/message_bar.h"

#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int maxNameWidth = 240;
} // namespace

QPushButton* addButton(QToolBar* bar, QPushButton* button)
{
    button->setAutoDefault(true);
    auto* cell = new QWidget;
    auto* row = new QHBoxLayout(cell);
    row->setContentsMargins(0, gap / 2, gap, gap / 2);
    row->addWidget(button);
    bar->addWidget(cell);
    return button;
}

MessageBar::MessageBar(const char* name, const QString& title, QMainWindow* window) : QToolBar(title, window)
{
    setObjectName(QLatin1StringView(name));
    setMovable(false);
    setAutoFillBackground(true);
    setContextMenuPolicy(Qt::PreventContextMenu);
    view()->installEventFilter(this);
    window->installEventFilter(this);
    installEventFilter(this); // its words and their font come later
    show();
    raise();
    place();
}

QWidget* MessageBar::view() const
{
    auto* window = qobject_cast<QMainWindow*>(parentWidget());
    return window->centralWidget() ? window->centralWidget() : window;
}

/// Stands below the bars that came before, as wide as the view but for what stands in its right corner, or wider where
/// that is too narrow.
void MessageBar::place()
{
    const QWidget* window = parentWidget();
    QRect place(view()->mapTo(window, QPoint()), view()->size());
    constexpr QPoint intoCorner(-4 * gap, 4 * gap);
    if (const QWidget* corner = view()->childAt(view()->rect().topRight() + intoCorner))
        place.setWidth(corner->x() - gap);
    for (const MessageBar* bar : window->findChildren<MessageBar*>(Qt::FindDirectChildrenOnly)) {
        if (bar == this)
            break;
        if (!bar->isHidden())
            place.setTop(bar->geometry().bottom() + 1);
    }
    place.setHeight(sizeHint().height());
    const int missing = std::max(0, std::min(sizeHint().width(), window->width()) - place.width());
    place.adjust(0, 0, missing, 0);
    place.moveRight(std::min(place.right(), window->width() - 1));
    setGeometry(place);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event)
{
    const QEvent::Type type = event->type();
    const bool isOwn = watched == this && (type == QEvent::PolishRequest || type == QEvent::FontChange);
    if (isOwn || (watched != this && (type == QEvent::Resize || type == QEvent::Move || type == QEvent::LayoutRequest)))
        place();
    return QToolBar::eventFilter(watched, event);
}

void MessageBar::setMessage(const char* name, const QString& sentence, const QString& tip)
{
    auto* words = named(new QLabel(sentence), name, tip);
    words->setTextFormat(Qt::PlainText);
    words->setContentsMargins(gap, 0, gap, 0);
    words->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(words);
}

QPushButton* MessageBar::addButton(const char* name, const QString& text, const QString& tip)
{
    return ui::addButton(this, named(new QPushButton(text), name, tip, QString(text).remove(QLatin1Char('&'))));
}

QString MessageBar::shortened(const QString& fileName) const
{
    return fontMetrics().elidedText(fileName, Qt::ElideMiddle, maxNameWidth);
}

void MessageBar::dismiss()
{
    const auto* window = qobject_cast<QMainWindow*>(parentWidget());
    if (isAncestorOf(QApplication::focusWidget()) && window->centralWidget())
        window->centralWidget()->setFocus();
    hide();
    for (MessageBar* bar : parentWidget()->findChildren<MessageBar*>(Qt::FindDirectChildrenOnly))
        bar->place();
    deleteLater();
}
} // namespace ui
