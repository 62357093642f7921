#include "panel_builder.h"
#include "panel_content.h"
#include "panel_theme.h"

#include <cmath>

namespace vr
{
namespace
{
constexpr double width = 940, nameWidth = 300, buttonHeight = 92;
constexpr double distance = 0.6; ///< metres: at arm's length
constexpr double feelHeight = 6 * (theme::row + theme::gap); ///< both pages are as high
constexpr double raiseStep = 0.02, levelStep = 0.05;
} // namespace

SettingsPanel SettingsPanel::after(const PanelAction& action) const
{
    SettingsPanel panel = *this;
    if (const auto* shown = std::get_if<SettingsPage>(&action))
        panel.page = *shown;
    return panel;
}

QString SettingsPanel::nameOf(Sensation sensation)
{
    switch (sensation) {
    case Sensation::Contact: return tr("First contact");
    case Sensation::Texture: return tr("Sculpting");
    case Sensation::Fusion: return tr("Surfaces join");
    case Sensation::Refusal: return tr("Refusal");
    case Sensation::MenuStep: return tr("Menus");
    case Sensation::Hold: return tr("Holding a button");
    }
    return {};
}

void SettingsPanel::addGeneral(PanelBuilder& builder) const
{
    builder.addChoice(tr("Buttons"), nameWidth,
                      {{tr("Paper"), {}, Preset::Paper, preset == Preset::Paper}, {tr("Studio"), {}, Preset::Studio, preset == Preset::Studio}});
    builder.addChoice(tr("Sculpting hand"), nameWidth,
                      {{tr("Left"), {}, ChooseHand{Side::Left}, sculpting == Side::Left},
                       {tr("Right"), {}, ChooseHand{Side::Right}, sculpting == Side::Right}});
    const int centimetres = static_cast<int>(std::lround(raised * 100));
    //: %1: a number, perhaps with a sign
    const QString height = tr("%1 cm").arg(QString::number(centimetres).prepend(centimetres > 0 ? QStringLiteral("+") : QString()));
    builder.addSlider({tr("Raise model"), height, SliderLook{.least = -mostRaised, .most = mostRaised, .step = raiseStep}, {PanelSlider::Height, raised}},
                      nameWidth);
    builder.addSwitch(tr("Performance"), nameWidth, {showsPerformance ? tr("On") : tr("Off"), showsPerformance}, ShowPerformance{!showsPerformance});
    constexpr double generalHeight = 4 * (theme::row + theme::gap) + buttonHeight + theme::gap;
    builder.skip(feelHeight - generalHeight);
    const std::vector<QRectF> last = evenCells(builder.nextRow(buttonHeight), 2);
    builder.add(last[0], {{.text = tr("Recentre"), .icon = QStringLiteral("recentre")}, PanelCommand::Recentre});
    builder.add(last[1], {{.text = tr("Leave VR"), .icon = QStringLiteral("quit")}, PanelCommand::LeaveVr});
}

void SettingsPanel::addFeel(PanelBuilder& builder) const
{
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const auto slider = static_cast<PanelSlider>(static_cast<std::size_t>(PanelSlider::Contact) + i);
        const QString value = tr("%1 %").arg(std::lround(levels[i] * 100));
        builder.addSlider({nameOf(static_cast<Sensation>(i)), value, SliderLook{.step = levelStep}, {slider, levels[i]}}, nameWidth);
    }
}

PanelLayout SettingsPanel::layout() const
{
    PanelBuilder builder(PanelKind::Settings, width, distance);
    builder.addTitle({tr("Settings")}, {{{.icon = QStringLiteral("panel-close"), .isFlat = true}, ShowPanel{PanelKind::Settings, false}}});
    builder.addChoice({}, 0, {{tr("General"), {}, SettingsPage::General, page == SettingsPage::General},
                              {tr("Vibration"), {}, SettingsPage::Feel, page == SettingsPage::Feel}});
    builder.skip(theme::gap);
    if (page == SettingsPage::General)
        addGeneral(builder);
    else
        addFeel(builder);
    return builder.finished();
}
} // namespace vr
