#pragma once

#include "app/document/idle_analysis.h"

#include "core/analysis/mesh_check.h"
#include "ui/util/background_thread.h"

namespace app
{
/// Measures and judges the whole model on a thread aside.
class ModelInquiry : public RestingModel
{
    Q_OBJECT

public:
    using RestingModel::RestingModel;
    ~ModelInquiry() override { end(); }

Q_SIGNALS:
    void answered(const core::MeshReport& report);

private:
    void look(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;
    void take(const core::MeshReport& report, const std::stop_token& stop);

    ui::BackgroundThread m_aside; ///< last
};
} // namespace app
