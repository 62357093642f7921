#include "ui/classroom/class_clock.h"

#include "ui/classroom/class_bar.h"
#include "ui/widgets/named.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>
#include <QWindow>

#include <algorithm>

namespace ui
{
namespace
{
constexpr QSize clockWindow{640, 400};
constexpr int nameShare = 7, timeShare = 3, nextShare = 14; ///< of the height; a letter's
constexpr int maxLettersAcross = 12;                        ///< of the time

void setLetters(QLabel* label, int pixels)
{
    QFont font = label->font();
    font.setPixelSize(std::max(pixels, 12));
    label->setFont(font);
}
} // namespace

ClassClock::ClassClock(const QString& title, const QStringList& names, QWidget* window)
    : QWidget(window, Qt::Window)
    , m_names(names)
    , m_pupil(named(new QLabel, "clockPupil"))
    , m_time(named(new QLabel, "clockTime"))
    , m_next(named(new QLabel, "clockNext"))
{
    setObjectName(QStringLiteral("classClock"));
    setWindowTitle(title);
    setContextMenuPolicy(Qt::PreventContextMenu);
    auto* column = new QVBoxLayout(this);
    for (QLabel* label : {m_pupil, m_time, m_next}) {
        label->setTextFormat(Qt::PlainText);
        label->setAlignment(Qt::AlignCenter);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
        column->addWidget(label, label == m_time ? 2 : 1);
    }
    resize(clockWindow);
    setPupil({});
}

void ClassClock::setPupil(const std::optional<QString>& pupil)
{
    m_present = pupil.value_or(QString());
    m_pupil->setText(m_present);
    showNext();
}

void ClassClock::setTime(const std::optional<TurnTime>& time)
{
    if (!time)
        m_time->clear();
    else if (time->seconds > 0)
        m_time->setText(clockText(time->seconds));
    else
        m_time->setText(QStringLiteral("+") + clockText(time->over));
}

void ClassClock::setHadTurn(const QStringList& pupils)
{
    m_hadTurn = pupils;
    showNext();
}

void ClassClock::showNext()
{
    const auto next = std::ranges::find_if(
        m_names, [this](const QString& name) { return name != m_present && !m_hadTurn.contains(name); });
    m_next->setText(next == m_names.end() ? QString() : tr("Next: %1").arg(*next));
}

void ClassClock::toggle()
{
    if (isVisible())
        return hide();
    const QList<QScreen*> screens = QGuiApplication::screens();
    const auto other =
        std::ranges::find_if(screens, [this](const QScreen* screen) { return screen != parentWidget()->screen(); });
    if (other == screens.end())
        return show();
    setGeometry((*other)->geometry());
    showFullScreen();
}

void ClassClock::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        hide();
}

void ClassClock::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    setLetters(m_pupil, height() / nameShare);
    setLetters(m_time, std::min(height() / timeShare, 2 * width() / maxLettersAcross));
    setLetters(m_next, height() / nextShare);
}
} // namespace ui
