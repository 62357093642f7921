#include "ui/classroom/turn_countdown.h"

#include "ui/classroom/class_bar.h"
#include "ui/widgets/spacing.h"

#include <QEvent>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int lastSeconds = 60;
constexpr int minLetters = 32, maxLetters = 140; ///< pixels
constexpr int narrowLetters = 12;                ///< smallest letters in a narrow view, pixels
constexpr int viewShare = 10;                    ///< letter height as a divisor of the view's height: 10 means 1/10
} // namespace

TurnCountdown::TurnCountdown(QWidget* over) : QLabel(over)
{
    setObjectName(QStringLiteral("turnCountdown"));
    setTextFormat(Qt::PlainText);
    setAlignment(Qt::AlignCenter);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAutoFillBackground(true);
    setMargin(gap);
    over->installEventFilter(this);
    hide();
}

void TurnCountdown::setTime(const std::optional<TurnTime>& time)
{
    const bool isShown = time && time->seconds < lastSeconds;
    if (isShown) {
        setText(time->seconds > 0 ? clockText(time->seconds)
                                  : tr("Time is up") + QStringLiteral("  +") + clockText(time->over));
        place();
        raise();
    }
    setVisible(isShown);
}

/// Places the text at the middle of the upper edge, where it covers least of the model.
void TurnCountdown::place()
{
    QFont letters = font();
    letters.setBold(true);
    letters.setPixelSize(std::clamp(parentWidget()->height() / viewShare, minLetters, maxLetters));
    while (letters.pixelSize() > narrowLetters &&
           QFontMetrics(letters).horizontalAdvance(text()) + 2 * margin() > parentWidget()->width())
        letters.setPixelSize(letters.pixelSize() - 1);
    setFont(letters);
    adjustSize();
    move((parentWidget()->width() - width()) / 2, gap);
}

bool TurnCountdown::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == parentWidget())
        place();
    return QLabel::eventFilter(watched, event);
}
} // namespace ui
