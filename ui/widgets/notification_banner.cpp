#include "ui/widgets/notification_banner.h"

#include "ui/widgets/view_card.h"

#include <QEvent>

#include <algorithm>
#include <array>

namespace ui
{
namespace
{
constexpr int distance = 16; ///< pixels from the parent's edges
constexpr int between = 8;   ///< pixels from the sibling
/// Duration of a message, milliseconds: a fixed part, and a part per character.
constexpr int baseMs = 2500, msPerCharacter = 60;
} // namespace

NotificationBanner::NotificationBanner(QWidget* parent) : QLabel(parent)
{
    setObjectName(QStringLiteral("banner"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setAlignment(Qt::AlignCenter);
    setStyleSheet(QStringLiteral("background: rgba(28, 30, 33, 225); color: white; border: 1px solid rgba(255, 255, "
                                 "255, 45); border-radius: 8px; padding: 8px 16px;"));
    hide();
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &QLabel::hide);
    parent->installEventFilter(this);
}

void NotificationBanner::stayAbove(QWidget* sibling)
{
    m_sibling = sibling;
    sibling->installEventFilter(this);
}

void NotificationBanner::showMessage(const QString& sentence)
{
    setText(sentence);
    place();
    show();
    raise();
    m_timer.start(baseMs + msPerCharacter * static_cast<int>(sentence.size()));
}

bool NotificationBanner::eventFilter(QObject* watched, QEvent* event)
{
    constexpr std::array placing{QEvent::Resize, QEvent::Move, QEvent::Show, QEvent::Hide};
    if (std::ranges::count(placing, event->type()) > 0)
        place();
    return QLabel::eventFilter(watched, event);
}

void NotificationBanner::place()
{
    const int max = std::max(parentWidget()->width() - 2 * distance, 100);
    const int oneLine = fontMetrics().horizontalAdvance(text()) + 2 * 16 + 4;
    const int width = std::min(oneLine, max);
    const int height = heightForWidth(width);
    setGeometry((parentWidget()->width() - width) / 2, parentWidget()->height() - height - distance, width, height);
    if (m_sibling && !m_sibling->isHidden())
        moveAbove(m_sibling->geometry());
    const QList<ViewCard*> cards = parentWidget()->findChildren<ViewCard*>();
    for (ViewCard* card : cards)
        card->installEventFilter(this);
    for (qsizetype i = 0; i < cards.size(); ++i) // above one it may meet another
        for (const ViewCard* card : cards)
            if (card->isVisible())
                moveAbove({card->mapTo(parentWidget(), QPoint()), card->size()});
}

void NotificationBanner::moveAbove(const QRect& other)
{
    if (geometry().adjusted(-between, -between, between, between).intersects(other))
        move(x(), other.top() - between - height());
}
} // namespace ui
