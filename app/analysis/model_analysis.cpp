#include "app/analysis/model_analysis.h"

namespace app
{
void ModelAnalysis::analyse(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop)
{
    m_background.run(
        [copy, stop] {
            return core::checkMesh(copy->mesh, {stop, {}});
        },
        [this, stop](const core::MeshReport& report) {
            if (stop.stop_requested())
                return;
            setFinished();
            Q_EMIT finished(report);
        });
}
} // namespace app
