#include "app/worker/stroke_step.h"

#include "app/worker/stroke_report.h"

namespace app
{
namespace
{
const QString addIcon = QStringLiteral("add");
} // namespace

QString StrokeStep::iconOf(core::Tool tool)
{
    const std::string_view name = core::name(tool);
    return QLatin1StringView(name.data(), static_cast<qsizetype>(name.size()));
}

QString StrokeStep::textOf(core::Tool tool)
{
    switch (tool) {
    case core::Tool::Pull:
        return tr("Pull", "undo step");
    case core::Tool::Push:
        return tr("Push", "undo step");
    case core::Tool::Inflate:
        return tr("Inflate", "undo step");
    case core::Tool::Clay:
        return tr("Clay", "undo step");
    case core::Tool::Layer:
        return tr("Layer", "undo step");
    case core::Tool::Flatten:
        return tr("Flatten", "undo step");
    case core::Tool::Scrape:
        return tr("Scrape", "undo step");
    case core::Tool::Smooth:
        return tr("Smooth", "undo step");
    case core::Tool::Pinch:
        return tr("Pinch", "undo step");
    case core::Tool::Crease:
        return tr("Crease", "undo step");
    case core::Tool::Grab:
        return tr("Grab", "undo step");
    case core::Tool::SnakeHook:
        return tr("Snake Hook", "undo step");
    case core::Tool::Twist:
        return tr("Twist", "undo step");
    case core::Tool::Stamp:
        return tr("Stamp", "undo step");
    case core::Tool::Paint:
        return tr("Paint", "undo step");
    case core::Tool::Mask:
        return tr("Mask", "undo step");
    }
    return {};
}

QString StrokeStep::textOfAdding(bool isModel)
{
    return isModel ? tr("Add Model", "undo step") : tr("Add Ball", "undo step");
}

StepDescription StrokeStep::descriptionOf(const StrokeReport& report)
{
    const StepMarks marks{report.added ? addIcon : iconOf(report.tool), report.dabs, report.fusions,
                          report.recordedStep};
    return {report.added ? textOfAdding(report.hasModel) : textOf(report.tool), marks};
}

std::optional<StrokeReport> StrokeStep::reportOf(const StepMarks& marks)
{
    const auto* stroke = std::get_if<core::Stroke>(marks.recordedStep.get());
    if (!stroke || !stroke->alpha.file.empty() || !stroke->model.file.empty())
        return std::nullopt;
    StrokeReport report;
    report.recordedStep = marks.recordedStep;
    report.tool = stroke->settings.tool;
    report.dabs = marks.dabs;
    report.fusions = marks.fusions;
    report.added = marks.icon == addIcon;
    report.hasModel = stroke->settings.model != nullptr;
    return report;
}

core::JournalStep StrokeStep::forJournal(const QString& text, const StepMarks& marks)
{
    return {text.toStdString(), marks.icon.toStdString(), marks.dabs, marks.fusions, marks.recordedStep};
}

StepDescription StrokeStep::fromJournal(const core::JournalStep& step)
{
    return {QString::fromStdString(step.text),
            {QString::fromStdString(step.icon), step.dabs, step.fusions, step.entry}};
}
} // namespace app
