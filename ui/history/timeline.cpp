#include "ui/history/timeline.h"

#include "ui/history/history_panel.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"
#include "ui/widgets/themed_icon.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <cstdlib>
#include <utility>

namespace ui
{
namespace
{
constexpr int playIntervalMs = 400; ///< pause between states during playback; slow enough to see each step
constexpr int statesPerPage = 10;
} // namespace

Timeline::Timeline(QWidget* parent)
    : QWidget(parent)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_text(new QLabel)
    , m_play(new QToolButton)
{
    named(m_slider, "timeline",
          tr("Drag to see the model after each step; Left and Right move by one. Sculpting there removes the later "
             "steps."),
          tr("Timeline"));
    m_slider->setPageStep(statesPerPage);
    m_text->setObjectName(QStringLiteral("timelineText"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_play->setObjectName(QStringLiteral("timelinePlay"));
    m_play->setAutoRaise(true);
    m_play->setCheckable(true);
    m_play->setAccessibleName(tr("Play the steps"));
    m_play->setToolTip(tr("Plays the steps in order, from here or from the first."));
    m_playTimer.setInterval(playIntervalMs);
    connect(m_slider, &QSlider::valueChanged, this, &Timeline::requestState);
    connect(m_play, &QToolButton::clicked, this, &Timeline::setPlaying);
    connect(m_slider, &QSlider::sliderPressed, this, [this] { setPlaying(false); });
    connect(&m_playTimer, &QTimer::timeout, this, &Timeline::playNext);

    auto* row = new QHBoxLayout;
    row->setSpacing(gap);
    row->addWidget(m_play);
    row->addWidget(m_slider, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap / 2);
    column->addLayout(row);
    column->addWidget(m_text);
    setPlaying(false);
    setHistory({});
}

/// Shows a changed history. If anything but this timeline's request changed it, drops the request and stops playing.
void Timeline::setHistory(const History& history)
{
    QStringList names;
    for (const HistoryStep& step : history.steps)
        names << step.name;
    const int before = std::exchange(m_present, history.present);
    const bool hasOtherNames = std::exchange(m_names, names) != names;
    const auto away = [this](int state) { return std::abs(state - m_requested.value_or(state)); };
    const bool isLost =
        // The state moved away from the requested one, so other code changed it
        m_requested && m_present != before && away(m_present) >= away(before);
    if (hasOtherNames || isLost || m_requested == m_present)
        m_requested.reset();
    if (hasOtherNames || isLost)
        setPlaying(false);
    const QSignalBlocker quiet(m_slider);
    m_slider->setRange(history.first, history.last);
    m_slider->setValue(m_requested.value_or(m_present));
    m_slider->setEnabled(history.first < history.last);
    m_play->setEnabled(history.first < history.last);
    showState(nameOf(m_slider->value()));
}

void Timeline::requestState(int state)
{
    m_requested = state;
    showState(nameOf(state));
    Q_EMIT stateRequested(state);
}

QString Timeline::nameOf(int state) const
{
    return state == 0 ? HistoryPanel::tr("Start") : m_names.value(state - 1);
}

void Timeline::showState(const QString& name)
{
    const QLocale locale;
    m_text->setText(tr("%1 of %2: %3", "step, steps, its name")
                        .arg(locale.toString(m_slider->value()), locale.toString(m_names.size()), name));
    m_text->setToolTip(m_text->text());
}

void Timeline::setPlaying(bool isPlaying)
{
    m_play->setChecked(isPlaying);
    m_play->setIcon(themedIcon(isPlaying ? QStringLiteral("pause") : QStringLiteral("play")));
    if (!isPlaying)
        return m_playTimer.stop();
    if (m_slider->value() == m_slider->maximum())
        m_slider->setValue(m_slider->minimum());
    m_playTimer.start();
}

/// Plays the next step. Waits while a requested state has not been reached.
void Timeline::playNext()
{
    if (m_requested)
        return;
    if (m_slider->value() == m_slider->maximum())
        return setPlaying(false);
    m_slider->setValue(m_slider->value() + 1);
}

void Timeline::hideEvent(QHideEvent* event)
{
    setPlaying(false);
    QWidget::hideEvent(event);
}
} // namespace ui
