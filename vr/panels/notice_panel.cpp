#include "vr/panels/panel_builder.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_theme.h"
#include "vr/panels/text_fit.h"

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
constexpr double noticeWidth = 700; ///< largest width of the text, dmm
constexpr int noticeLines = 6;
/// Distance from which the notice is read, metres: nearer than the clay, which must not hide it.
constexpr double noticeDistance = 0.5;
constexpr double fadeIn = 0.15, fadeOut = 0.6;       ///< times of fading, seconds
constexpr double toBeSeen = 1, minReadingTime = 1.5; ///< time to notice the panel, and least time to read it, seconds
constexpr double perLetter = 0.06,
                 perHanLetter = 0.2; ///< seconds per letter of a slow reader; a Han letter is a word or half of one

double readingTime(const QString& text)
{
    const auto han = std::ranges::count_if(text, [](QChar letter) { return letter.script() == QChar::Script_Han; });
    return perHanLetter * static_cast<double>(han) + perLetter * static_cast<double>(text.size() - han);
}
} // namespace

PanelLayout NoticePanel::layout() const
{
    const FittedText shown =
        fitted(text, noticeWidth, {.height = theme::bodyHeight, .minHeight = theme::minHeight, .lines = noticeLines});
    PanelBuilder builder(PanelKind::Notice, std::ceil(shown.width) + 2 * theme::margin, noticeDistance);
    const double height = shown.lineSpacing() * static_cast<double>(shown.lines.size());
    builder.add(builder.nextRow(height), TextLook{.text = text, .alignment = Qt::AlignCenter, .lines = noticeLines});
    return builder.finished();
}

double noticeOpacity(const NoticePanel& notice, double age)
{
    const double stays = toBeSeen + std::max(minReadingTime, readingTime(notice.text));
    return std::clamp(std::min(age / fadeIn, (fadeIn + stays + fadeOut - age) / fadeOut), 0.0, 1.0);
}
} // namespace vr
