#include "panel_builder.h"
#include "panel_content.h"
#include "panel_theme.h"

namespace vr
{
namespace
{
constexpr double width = 470, lineHeight = 42, numberWidth = 130;
constexpr double distance = 0.6; ///< metres

struct Line
{
    QString name, number;
};
} // namespace

QString PerformancePanel::nameOf(std::size_t phase)
{
    switch (phase) {
    case 0: return tr("Events");
    case 1: return tr("Waiting");
    case 2: return tr("Input");
    case 3: return tr("Model");
    case 4: return tr("Images");
    case 5: return tr("Drawing");
    default: return tr("Handing over");
    }
}

PanelLayout PerformancePanel::layout() const
{
    const auto milliseconds = [](double value) { return QString::number(value, 'f', 2); };
    std::vector<Line> lines{{tr("CPU, ms"), milliseconds(totalMs)}};
    for (std::size_t i = 0; i < phaseCount; ++i)
        lines.push_back({nameOf(i), milliseconds(cpuMs[i])});
    lines.push_back({tr("Dropped frames"), QString::number(dropped)});

    PanelBuilder builder(PanelKind::Performance, width, distance);
    //: %1: how many frames a second
    builder.addTitle({tr("%1 fps").arg(framesPerSecond)});
    const QRectF table = builder.nextRow(lineHeight * static_cast<double>(lines.size()));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool isSum = i == 0 || i + 1 == lines.size();
        const QRectF line(table.left(), table.top() + lineHeight * static_cast<double>(i), table.width(), lineHeight);
        const std::vector<QRectF> places = cells(line, {0, numberWidth});
        builder.add(places[0], TextLook{.text = lines[i].name, .role = isSum ? TextRole::Body : TextRole::Faint});
        builder.add(places[1], TextLook{lines[i].number, TextRole::Number, Qt::AlignRight | Qt::AlignVCenter});
    }
    return builder.finished();
}
} // namespace vr
