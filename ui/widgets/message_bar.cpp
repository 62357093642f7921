#include "ui/widgets/message_bar.h"

#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QApplication>
#include <QBoxLayout>
#include <QEvent>
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

MessageBar::MessageBar(const char* name, const QString& title, QMainWindow* window)
    : QFrame(window)
    , m_rows(new QBoxLayout(QBoxLayout::LeftToRight, this))
    , m_controls(new QHBoxLayout)
    , m_buttons(new QHBoxLayout)
{
    setObjectName(QLatin1StringView(name));
    setAccessibleName(title);
    setAutoFillBackground(true);
    m_rows->setContentsMargins(gap, gap / 2, gap, gap / 2);
    m_rows->setSpacing(gap);
    m_rows->addLayout(m_controls, 1);
    m_rows->addLayout(m_buttons);
    m_controls->setSpacing(gap);
    m_buttons->setSpacing(gap);
    m_buttons->addStretch();
    view()->installEventFilter(this);
    window->installEventFilter(this);
    installEventFilter(this); // to notice later changes of text and font
    show();
    raise();
    place();
}

QWidget* MessageBar::view() const
{
    auto* window = qobject_cast<QMainWindow*>(parentWidget());
    return window->centralWidget() ? window->centralWidget() : window;
}

/// Returns the width in one line of the buttons and the sentence, or of the buttons and the controls if there is no
/// sentence. Computed from the text, because a wrapping label does not report the width of its sentence.
int MessageBar::lineWidth() const
{
    const QMargins margins = m_rows->contentsMargins();
    const int controls =
        m_words ? m_words->fontMetrics().horizontalAdvance(m_words->text()) : m_controls->sizeHint().width();
    return controls + m_rows->spacing() + m_buttons->sizeHint().width() + margins.left() + margins.right();
}

/// Puts the bar below earlier bars. It is as wide as the view without the widget in the view's top right corner, or
/// wider if its contents need it.
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
    const bool isNarrow = lineWidth() > place.width();
    m_rows->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    if (m_words)
        m_words->setWordWrap(isNarrow);
    place.setWidth(std::min(std::max(place.width(), m_rows->minimumSize().width()), window->width()));
    place.setHeight(m_rows->hasHeightForWidth() ? m_rows->heightForWidth(place.width()) : m_rows->sizeHint().height());
    place.moveRight(std::min(place.right(), window->width() - 1));
    setGeometry(place);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event)
{
    const QEvent::Type type = event->type();
    const bool isMoved = watched != this && (type == QEvent::Resize || type == QEvent::Move);
    if (isMoved || type == QEvent::LayoutRequest || type == QEvent::PolishRequest || type == QEvent::FontChange)
        place();
    return QFrame::eventFilter(watched, event);
}

void MessageBar::setMessage(const char* name, const QString& sentence, const QString& tip)
{
    m_words = named(new QLabel(sentence), name, tip);
    m_words->setTextFormat(Qt::PlainText);
    m_controls->addWidget(m_words, 1);
}

void MessageBar::addControl(QWidget* control)
{
    m_controls->addWidget(control);
}

QPushButton* MessageBar::addButton(const char* name, const QString& text, const QString& tip)
{
    auto* button = named(new QPushButton(text), name, tip, QString(text).remove(QLatin1Char('&')));
    button->setAutoDefault(true);
    m_buttons->addWidget(button);
    return button;
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
