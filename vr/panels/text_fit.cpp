#include "vr/panels/text_fit.h"

#include "vr/panels/panel_theme.h"

#include <QFontMetricsF>
#include <QTextLayout>

#include <algorithm>
#include <cmath>

namespace vr
{
namespace
{
constexpr double rounding = 1e-6; ///< added to a number of lines before it is rounded down: tolerates rounding errors

QFont fontOf(double height, QFont::Weight weight)
{
    QFont font;
    font.setPixelSize(std::max(1, static_cast<int>(std::ceil(height))));
    font.setWeight(weight);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

/// Breaks the text between words only. A word that is too wide makes its line too wide.
std::vector<QString> wrapped(const QString& text, const QFont& font, double width)
{
    QTextLayout layout(text, font);
    QTextOption option;
    option.setWrapMode(QTextOption::WordWrap);
    layout.setTextOption(option);
    std::vector<QString> lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        lines.push_back(text.mid(line.textStart(), line.textLength()));
    }
    layout.endLayout();
    return lines;
}

double spacingOf(const QFont& font)
{
    return font.pixelSize() * theme::lineSpacing;
}

/// Returns the number of lines that fit into the style's largest block height: 1 to style.lines.
std::size_t maxLines(const QFont& font, const TextStyle& style)
{
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>(style.maxBlockHeight / spacingOf(font) + rounding), 1, style.lines));
}

double widest(const std::vector<QString>& lines, const QFont& font)
{
    const QFontMetricsF metrics(font);
    double width = 0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line.trimmed()));
    return width;
}

/// Joins all surplus lines to the last allowed line, and cuts lines that are too wide.
std::vector<QString> cut(const std::vector<QString>& lines, const QFont& font, double width, const TextStyle& style)
{
    const QFontMetricsF metrics(font);
    const std::size_t max = maxLines(font, style);
    std::vector<QString> kept(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(std::min(max, lines.size())));
    for (std::size_t i = max; i < lines.size(); ++i)
        kept.back() += lines[i];
    for (QString& line : kept)
        line = metrics.elidedText(line.trimmed(), style.cut, width);
    return kept;
}
} // namespace

double FittedText::lineSpacing() const
{
    return spacingOf(font);
}

FittedText fitted(const QString& text, double width, const TextStyle& style)
{
    for (double height = style.height;; height = std::max(height - 1, style.minHeight)) {
        const QFont font = fontOf(height, style.weight);
        std::vector<QString> lines = wrapped(text, font, width);
        const bool isWhole = lines.size() <= maxLines(font, style) && widest(lines, font) <= width;
        if (!isWhole && height > style.minHeight)
            continue;
        lines = isWhole ? lines : cut(lines, font, width, style);
        for (QString& line : lines)
            line = line.trimmed();
        return {font, lines, widest(lines, font)};
    }
}
} // namespace vr
