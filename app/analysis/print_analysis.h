#pragma once

#include "app/analysis/idle_analysis.h"

#include "core/analysis/print_check.h"
#include "core/mesh/footprint.h"
#include "ui/util/background_thread.h"

#include <optional>

namespace app
{
/// Whether the model will print. Long measurements are made once per change; limits and pictures are evaluated from
/// them.
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
    /// 0 to 1, while it is measured.
    void progressed(double share);
    /// `shades`: of the vertices, as ui::PrintScale has them; null if no picture is requested.
    void finished(const core::MeshReport& mesh, const core::PrintReport& print,
                  const std::shared_ptr<const core::Footprint>& shades);

private:
    struct Measurement
    {
        core::PrintMeasures measures;
        std::vector<core::Slot> slots;
    };
    struct Result
    {
        core::PrintReport report;
        std::shared_ptr<const core::Footprint> shades;
    };
    static Result evaluate(const Measurement& measured, const Options& options);

    void analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;
    void onMeasured(std::shared_ptr<const Measurement> measured, const std::stop_token& stop);
    void evaluateAgain();

    Options m_options;
    std::shared_ptr<const Measurement> m_measured; ///< null: of no model, or of one that has changed
    std::stop_source m_stopEvaluation;             ///< of the evaluation for the latest options
    ui::BackgroundThread m_background;             ///< last
};
} // namespace app
