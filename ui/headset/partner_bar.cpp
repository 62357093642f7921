#include "ui/headset/partner_bar.h"

#include "ui/actions/actions.h"
#include "ui/brush/brush_caption.h"
#include "ui/settings/brush_settings.h"
#include "ui/util/number_format.h"
#include "ui/viewport/viewport.h"

#include "core/stroke/tool.h"

#include <QAction>
#include <QLocale>
#include <QMainWindow>

#include <cmath>

namespace ui
{
PartnerBar::PartnerBar(const Parts& parts, QMainWindow* window)
    : QToolBar(tr("Partner"), window)
    , m_parts(parts)
    , m_caption(new BrushCaption)
{
    setObjectName(QStringLiteral("partnerBar"));
    setMovable(false);
    toggleViewAction()->setVisible(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_captionCell = addWidget(m_caption);
    addAction(parts.actions->get(QStringLiteral("vr.point")));
    addAction(parts.actions->get(QStringLiteral("vr.takeOver")));
    connect(parts.brush, &BrushSettings::changed, this, &PartnerBar::updateCaption);
    connect(parts.viewport, &Viewport::appearanceChanged, this, &PartnerBar::updateCaption);
    window->addToolBarBreak();
    window->addToolBar(this);
    setVisible(false);
    updateCaption();
}

QString PartnerBar::figures(double mm)
{
    constexpr double whole = 100;
    return mm >= whole ? number(static_cast<std::uint64_t>(std::llround(mm))) : QLocale().toString(mm, 'g', 3);
}

void PartnerBar::setWorn(bool isWorn)
{
    m_isWorn = isWorn;
    if (!isWorn)
        m_radius.reset();
    setVisible(isWorn);
    updateCaption();
}

void PartnerBar::setAvatar(const std::optional<HeadsetAvatar>& avatar)
{
    if (!avatar || avatar->radius <= 0)
        return;
    m_radius = avatar->radius;
    updateCaption();
}

void PartnerBar::setTime(const std::optional<TurnTime>& time)
{
    m_time = time;
    updateCaption();
}

void PartnerBar::setVisible(bool)
{
    QToolBar::setVisible(m_isWorn);
}

void PartnerBar::updateCaption()
{
    m_captionCell->setVisible(m_parts.viewport->appearance().caption);
    if (!m_isWorn)
        return;
    const std::string_view tool = core::name(m_parts.brush->tool());
    const QAction* action = m_parts.actions->get(
        QStringLiteral("tool.%1").arg(QLatin1StringView(tool.data(), static_cast<qsizetype>(tool.size()))));
    CaptionText words{action->icon(), Actions::plain(action->text()), {}, {}, m_time && m_time->isNearEnd};
    words.radius = tr("%1 mm").arg(figures(m_radius.value_or(m_parts.brush->value(core::Parameter::Radius))));
    if (m_time)
        words.time = m_time->seconds == 0 ? tr("Time is up") : durationText(60.0 * minutesOf(m_time->seconds));
    m_caption->setText(words);
}
} // namespace ui
