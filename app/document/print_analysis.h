#pragma once

#include "app/document/idle_analysis.h"

#include "core/analysis/print_check.h"
#include "core/mesh/footprint.h"
#include "ui/util/background_thread.h"

#include <optional>

namespace app
{
/// Will the model print? What takes long is measured once a change; limits and pictures are answered from that.
class PrintInquiry : public RestingModel
{
    Q_OBJECT

public:
    struct Wishes
    {
        core::PrintLimits limits;
        std::optional<core::PrintPicture> picture;
    };

    PrintInquiry(Document* document, SculptWorker* worker);
    ~PrintInquiry() override;

    void setWishes(const Wishes& wishes);

Q_SIGNALS:
    /// 0 to 1, while it is measured.
    void progressed(double share);
    /// `shades`: of the vertices, as ui::PrintScale has them; null if no picture is wished for.
    void answered(const core::MeshReport& mesh, const core::PrintReport& print,
                  const std::shared_ptr<const core::Footprint>& shades);

private:
    struct Measured
    {
        core::PrintMeasures measures;
        std::vector<core::Slot> slots;
    };
    struct Answer
    {
        core::PrintReport report;
        std::shared_ptr<const core::Footprint> shades;
    };
    static Answer judge(const Measured& measured, const Wishes& wishes);

    void look(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;
    void take(std::shared_ptr<const Measured> measured, const std::stop_token& stop);
    void answer();

    Wishes m_wishes;
    std::shared_ptr<const Measured> m_measured; ///< null: of no model, or of one that has changed
    std::stop_source m_wish;                    ///< of the latest wishes
    ui::BackgroundThread m_aside;               ///< last
};
} // namespace app
