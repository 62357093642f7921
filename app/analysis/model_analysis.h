#pragma once

#include "app/analysis/idle_analysis.h"

#include "core/analysis/mesh_check.h"
#include "ui/util/background_thread.h"

namespace app
{
/// Measures and checks the active part on a background thread.
class ModelAnalysis : public IdleAnalysis
{
    Q_OBJECT

public:
    ModelAnalysis(Document* document, SculptWorker* worker) : IdleAnalysis(document, worker, AnalysedParts::Active) {}
    ~ModelAnalysis() override { cancel(); }

Q_SIGNALS:
    /// `part`: name of the part; empty if the model has only one.
    void finished(const core::MeshReport& report, const QString& part);

private:
    void analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop) override;

    ui::BackgroundThread m_background; ///< last member: its destructor waits for jobs that use the other members
};
} // namespace app
