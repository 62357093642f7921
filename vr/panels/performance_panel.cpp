#include "vr/panels/panel_builder.h"
#include "vr/panels/panel_content.h"
#include "vr/panels/panel_theme.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <ranges>

namespace vr
{
namespace
{
constexpr double performanceWidth = 620, lineHeight = 42, numberWidth = 130, performanceTitleWidth = 270;
constexpr double performanceDistance = 0.6; ///< metres from which the panel is read
constexpr double lastMs = 1000;             ///< duration that the numbers cover, milliseconds

struct Line
{
    QString name, number;
    bool isMain = false;
};

struct Recent
{
    std::vector<FrameTiming> shown;
    double ms = 0; ///< planned duration from the first frame's beginning to the last one's end, milliseconds
};

/// Returns the shown frames of the last second. The time of dropped frames counts too.
Recent recent(const std::vector<FrameTiming>& timings)
{
    Recent found;
    for (const FrameTiming& timing : std::views::reverse(timings)) {
        if (found.ms >= lastMs)
            break;
        found.ms += timing.periodMs * (1.0 + timing.dropped);
        if (timing.isShown)
            found.shown.push_back(timing);
    }
    return found;
}

/// Returns the median of the values; 0 if there are none.
template <typename Value> double median(const std::vector<FrameTiming>& timings, const Value& valueOf)
{
    std::vector<double> values;
    for (const FrameTiming& timing : timings)
        values.push_back(valueOf(timing));
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}
} // namespace

PerformancePanel PerformancePanel::of(const std::vector<FrameTiming>& timings, std::uint64_t droppedFrames)
{
    const auto [shown, ms] = recent(timings);
    PerformancePanel panel;
    for (std::size_t i = 0; i < framePhaseCount; ++i) {
        const bool draws = static_cast<FramePhase>(i) == FramePhase::Draw;
        panel.cpuMs[i] =
            median(shown, [&](const FrameTiming& timing) { return timing.cpuMs[i] - (draws ? timing.drawCallMs : 0); });
    }
    panel.totalMs = median(shown, [](const FrameTiming& timing) { return timing.ownMs(); });
    panel.drawCallMs = median(shown, [](const FrameTiming& timing) { return timing.drawCallMs; });
    panel.framesPerSecond = ms > 0 ? static_cast<int>(std::lround(static_cast<double>(shown.size()) * 1000 / ms)) : 0;
    panel.dropped = droppedFrames;
    return panel;
}

QString PerformancePanel::nameOf(FramePhase phase)
{
    switch (phase) {
    case FramePhase::Events:
        return tr("Events");
    case FramePhase::Wait:
        return tr("Waiting");
    case FramePhase::Input:
        return tr("Input");
    case FramePhase::Client:
        return tr("Model");
    case FramePhase::Images:
        return tr("Images");
    case FramePhase::Draw:
        return tr("Drawing");
    case FramePhase::Submit:
        return tr("Handing over");
    }
    return {};
}

PanelLayout PerformancePanel::layout() const
{
    const auto milliseconds = [](double value) { return QLocale().toString(value, 'f', 2); };
    std::vector<Line> lines{{tr("Without draw calls"), milliseconds(totalMs), true}};
    for (std::size_t i = 0; i < framePhaseCount; ++i)
        lines.push_back({nameOf(static_cast<FramePhase>(i)), milliseconds(cpuMs[i])});
    lines.push_back({tr("Draw calls"), milliseconds(drawCallMs), true});
    lines.push_back({tr("Dropped frames"), QString::number(dropped), true});

    PanelBuilder builder(PanelKind::Performance, performanceWidth, performanceDistance);
    //: %1: how many frames a second
    builder.addTitle({tr("%1 fps").arg(framesPerSecond), tr("CPU, ms"), performanceTitleWidth});
    const QRectF table = builder.nextRow(lineHeight * static_cast<double>(lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const QRectF line(table.left(), table.top() + lineHeight * static_cast<double>(i), table.width(), lineHeight);
        const std::vector<QRectF> places = cells(line, {0, numberWidth});
        builder.add(places[0],
                    TextLook{.text = lines[i].name, .role = lines[i].isMain ? TextRole::Body : TextRole::Faint});
        builder.add(places[1], TextLook{lines[i].number, TextRole::Number, Qt::AlignRight | Qt::AlignVCenter});
    }
    return builder.finished();
}
} // namespace vr
