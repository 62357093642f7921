#pragma once

#include "app/worker/stroke_report.h"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace app
{
class Document;
class StoredDelta;

/// The last step of a document, while it is a stroke: another stroke may replace it. Thread: gui.
class LastStroke
{
public:
    struct Step
    {
        StrokeReport report; ///< without its change
        std::shared_ptr<StoredDelta> change;
        int index = 0;
        std::optional<quint64> saving; ///< the count of savings, if nothing was changed since
    };
    /// Gets the report of the new stroke; nothing if the stroke is not the last step any more, or another source
    /// sculpts.
    using Done = std::function<void(const std::optional<StrokeReport>& report)>;

    explicit LastStroke(Document* document) : m_document(document) {}

    /// Nothing if the last step is no stroke, was done before the model was opened, or is undone.
    std::optional<Step> step() const;
    /// Does another stroke in place of the last, or of what replaced it already: one step, as before. If the new one
    /// changes nothing, the step stays undone. If it is null, or stopped before it is done, the last stroke comes back,
    /// bit for bit. Nobody sculpts meanwhile, and nobody sees the model without either.
    void replace(const Step& last, std::shared_ptr<const core::Stroke> stroke, const std::stop_token& stop, Done done);

    /// That stroke became the last step.
    void setReport(const StrokeReport& report);
    /// A stroke was reported. `isOther`: the worker has another model.
    void onReport(const StrokeReport& report, bool isOther);
    /// The history was recovered.
    void restore();

private:
    Document* m_document;
    std::optional<StrokeReport> m_report; ///< of the last stroke, without its change
    Done m_done;                          ///< while a stroke is replaced
};
} // namespace app
