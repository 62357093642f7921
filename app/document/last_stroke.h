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

/// The last step of a document if it is a stroke. Another stroke may replace it. Thread: gui.
class LastStroke
{
public:
    struct Step
    {
        StrokeReport report; ///< report of the stroke, without its delta
        std::shared_ptr<StoredDelta> change;
        int index = 0;
        std::optional<quint64> saving; ///< SavedState::count() if the model is unmodified; nothing otherwise
    };
    /// A callback that receives the report of the new stroke; nothing if the stroke is no longer the last step, another
    /// source is sculpting, or another model is being opened.
    using Done = std::function<void(const std::optional<StrokeReport>& report)>;

    explicit LastStroke(Document* document) : m_document(document) {}

    /// Returns the last step; nothing if it is not a stroke, was made before the model was opened, is undone, or its
    /// change has expired.
    std::optional<Step> step() const;
    /// Replaces the last stroke, or its earlier replacement, by another stroke, still as one step. If the new stroke
    /// changes nothing, the step stays undone. If `stroke` is null or the replacement is stopped, the last stroke is
    /// restored, bit for bit. Sculpting is refused meanwhile, and viewers never see the state between the strokes.
    void replace(const Step& last, std::shared_ptr<const core::Stroke> stroke, const std::stop_token& stop, Done done);

    /// Sets the report of the stroke that is now the last step.
    void setReport(const StrokeReport& report);
    /// Ends a replacement when its stroke is reported. `isOther`: another model is being installed.
    void onReport(const StrokeReport& report, bool isOther);
    /// Reads the last stroke from a recovered history.
    void restore();

private:
    Document* m_document;
    std::optional<StrokeReport> m_report; ///< report of the last stroke, without its delta
    Done m_done;                          ///< callback of the replacement in progress; null: none
};
} // namespace app
