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
constexpr double lessonWidth = 940, wayHeight = 92, leafWidth = 84, countWidth = 120, markSign = 52, noteHeight = 44;
constexpr double lessonDistance = 0.6; ///< metres from which the panel is read: arm's length
/// Fraction of the width that is used: painted letters may be a little wider than measured here.
constexpr double wrapShare = 0.95;
constexpr int linesPerPage = 7, maxMarks = 4;

/// Wraps the text at the normal size, so that the letters of all pages have the same height.
FittedText wrappedText(const QString& text, double width)
{
    return fitted(text, width, {.height = theme::bodyHeight, .minHeight = theme::bodyHeight, .lines = 10'000});
}

int pageCountOf(const FittedText& text)
{
    return std::max(1, (static_cast<int>(text.lines.size()) + linesPerPage - 1) / linesPerPage);
}
} // namespace

void LessonPanel::addTitle(PanelBuilder& builder) const
{
    const FittedText shown =
        fitted(title, builder.innerWidth(),
               {.height = theme::titleHeight, .minHeight = theme::titleHeight, .lines = 3, .weight = QFont::DemiBold});
    builder.add(builder.nextRow(shown.lineSpacing() * static_cast<double>(shown.lines.size())),
                TextLook{.text = title, .role = TextRole::Title, .lines = static_cast<int>(shown.lines.size())});
    //: %1: a lesson's name; %2 of %3: its step
    const QString place = step < steps ? tr("%1: step %2 of %3").arg(lesson).arg(step + 1).arg(steps) : lesson;
    builder.add(builder.nextRow(noteHeight), TextLook{.text = place, .role = TextRole::Faint});
}

void LessonPanel::addText(PanelBuilder& builder) const
{
    const FittedText all = wrappedText(text, wrapShare * builder.innerWidth());
    const int pages = pageCountOf(all), shown = std::clamp(page, 0, pages - 1);
    const double spacing = all.lineSpacing();
    const auto count = static_cast<int>(all.lines.size());
    const QRectF area = builder.nextRow(spacing * std::min(count, linesPerPage));
    for (int i = 0; i < linesPerPage && shown * linesPerPage + i < count; ++i)
        builder.add(QRectF(area.left(), area.top() + i * spacing, area.width(), spacing),
                    TextLook{.text = all.lines[static_cast<std::size_t>(shown * linesPerPage + i)]});
    if (pages == 1)
        return;
    const std::vector<QRectF> places = cells(builder.nextRow(theme::row), {0, leafWidth, countWidth, leafWidth});
    builder.add(places[1], {{.icon = QStringLiteral("previous")}, ShowLessonPage{shown - 1}, shown > 0});
    builder.add(places[2], TextLook{tr("%1 / %2").arg(shown + 1).arg(pages), TextRole::Number, Qt::AlignCenter});
    builder.add(places[3], {{.icon = QStringLiteral("next")}, ShowLessonPage{shown + 1}, shown + 1 < pages});
}

/// Adds the requirements of the step. A sign shows which are met, because the colour of the text alone is not enough.
/// If there are too many, those not met are shown first.
void LessonPanel::addMarks(PanelBuilder& builder) const
{
    QList<LessonMark> shownMarks = marks;
    if (marks.size() > maxMarks)
        std::ranges::stable_partition(shownMarks, [](const LessonMark& mark) { return !mark.holds; });
    for (qsizetype i = 0; i < std::min<qsizetype>(marks.size(), maxMarks); ++i) {
        const LessonMark& mark = shownMarks[i];
        const FittedText shown = fitted(mark.text, builder.innerWidth() - markSign - theme::gap,
                                        {.height = theme::bodyHeight, .minHeight = theme::minHeight, .lines = 2});
        const std::vector<QRectF> places =
            cells(builder.nextRow(shown.lineSpacing() * static_cast<double>(shown.lines.size())), {markSign, 0});
        builder.add(places[0], TextLook{.text = mark.holds ? QStringLiteral("✓") : QStringLiteral("○"),
                                        .alignment = Qt::AlignCenter});
        builder.add(places[1],
                    TextLook{.text = mark.text, .role = mark.holds ? TextRole::Body : TextRole::Faint, .lines = 2});
    }
}

void LessonPanel::addButtons(PanelBuilder& builder) const
{
    const std::vector<QRectF> places = evenCells(builder.nextRow(wayHeight), 4);
    builder.add(places[0], {{.text = isPlaying ? tr("Pause") : tr("Show Me")}, LessonRequest::Play, canPlay});
    builder.add(places[1], {{.text = tr("Try It")}, LessonRequest::TryIt, step < steps});
    builder.add(places[2], {{.text = tr("Back")}, LessonRequest::Back, step > 0});
    builder.add(places[3], {{.text = step + 1 < steps ? tr("Next") : tr("Finish")}, LessonRequest::Next, step < steps});
}

PanelLayout LessonPanel::layout() const
{
    PanelBuilder builder(PanelKind::Lesson, lessonWidth, lessonDistance);
    addTitle(builder);
    addText(builder);
    builder.skip(theme::gap);
    addMarks(builder);
    builder.skip(theme::gap);
    addButtons(builder);
    return builder.finished();
}
} // namespace vr
