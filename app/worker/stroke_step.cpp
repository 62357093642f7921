#include "app/worker/stroke_step.h"

#include "app/worker/stroke_report.h"

#include "ui/util/part_name.h"

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
    const QString texts[] = {
        tr("Pull", "undo step"),  tr("Push", "undo step"),    tr("Inflate", "undo step"), tr("Clay", "undo step"),
        tr("Layer", "undo step"), tr("Flatten", "undo step"), tr("Scrape", "undo step"),  tr("Smooth", "undo step"),
        tr("Pinch", "undo step"), tr("Crease", "undo step"),  tr("Grab", "undo step"),    tr("Snake Hook", "undo step"),
        tr("Twist", "undo step"), tr("Stamp", "undo step"),   tr("Paint", "undo step"),   tr("Mask", "undo step")};
    static_assert(std::size(texts) == core::toolNames().size());
    return texts[static_cast<std::size_t>(tool)];
}

QString StrokeStep::textOfAdding(bool isModel)
{
    return isModel ? tr("Add Model", "undo step") : tr("Add Ball", "undo step");
}

StepDescription StrokeStep::descriptionOf(const StrokeReport& report)
{
    const StepMarks marks{report.added ? addIcon : iconOf(report.tool), report.dabs, report.fusions,
                          report.recordedStep};
    return {textOfPart(report.part, report.added ? textOfAdding(report.hasModel) : textOf(report.tool)), marks};
}

QString StrokeStep::textOfPart(const std::optional<core::Part>& part, const QString& text)
{
    return part ? tr("%1: %2", "undo step: name of the part, what was done to it").arg(ui::partName(*part), text)
                : text;
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
