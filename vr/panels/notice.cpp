#include "panel_builder.h"
#include "panel_content.h"
#include "panel_theme.h"
#include "text_fit.h"

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
constexpr double widest = 760; ///< of its text
constexpr int mostLines = 3;
constexpr double distance = 0.9; ///< metres: beyond the hands
constexpr double fadeIn = 0.15, fadeOut = 0.6;             ///< seconds
constexpr double leastStay = 2.5, secondsPerLetter = 0.06; ///< a slow reader's
} // namespace

PanelLayout Notice::layout() const
{
    const FittedText shown = fitted(text, widest, {.height = theme::bodyHeight, .leastHeight = theme::leastHeight, .lines = mostLines});
    PanelBuilder builder(PanelKind::Notice, std::ceil(shown.width) + 2 * theme::margin, distance);
    const double height = shown.lineSpacing() * static_cast<double>(shown.lines.size());
    builder.add(builder.nextRow(height), TextLook{.text = text, .alignment = Qt::AlignCenter, .lines = mostLines});
    return builder.finished();
}

double noticeOpacity(const Notice& notice, double age)
{
    const double stays = std::max(leastStay, secondsPerLetter * static_cast<double>(notice.text.size()));
    return std::clamp(std::min(age / fadeIn, (fadeIn + stays + fadeOut - age) / fadeOut), 0.0, 1.0);
}
} // namespace vr
