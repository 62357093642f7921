#pragma once

#include "app/analysis/idle_analysis.h"

#include "core/mesh/footprint.h"
#include "core/operations/part_union.h"
#include "core/print/print_check.h"
#include "ui/util/background_thread.h"

#include <optional>

namespace app
{
/// Analyses whether the visible parts of the model can be printed. Parts that overlap are united first, as an export
/// for print writes them. The slow measurements are made once per change of the model; changed limits and pictures are
/// evaluated from them.
class PrintAnalysis : public IdleAnalysis
{
    Q_OBJECT

public:
    struct Options
    {
        core::PrintLimits limits;
        std::optional<core::PrintPicture> picture;
    };

    PrintAnalysis(Document* document, SculptWorker* worker);
    ~PrintAnalysis() override;

    void setOptions(const Options& options);

Q_SIGNALS:
    /// Progress of the measurements, 0 to 1.
    void progressed(double share);
    /// `shades`: one value per vertex on the measured surface, for drawing by ui::PrintScale; null if no picture is
    /// requested.
    void finished(const core::MeshReport& mesh, const core::PrintReport& print, core::PartUnion parts,
                  const std::shared_ptr<const core::Footprint>& shades);

private:
    struct Measurement
    {
        core::PrintMeasures measures;
        std::vector<core::Slot> vertices; ///< measured vertices that the live mesh has
        std::vector<core::Slot> slots;    ///< slot of each of `vertices` in the live mesh
        core::PartUnion parts = core::PartUnion::NotNeeded;
    };
    struct Result
    {
        core::PrintReport report;
        std::shared_ptr<const core::Footprint> shades;
    };
    static Measurement measure(ModelCopy& copy, const core::JobControl& control);
    static Result evaluate(const Measurement& measured, const Options& options);

    void analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;
    void onMeasured(std::shared_ptr<const Measurement> measured, const std::stop_token& stop);
    void evaluateAgain();

    Options m_options;
    std::shared_ptr<const Measurement> m_measured; ///< measurements of the present model; null: none yet
    std::stop_source m_stopEvaluation;             ///< cancels the evaluation for the latest options
    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
