#include "app/document/model_analysis.h"

namespace app
{
void ModelInquiry::look(const std::shared_ptr<ModelCopy>& copy, const std::stop_token& stop)
{
    m_aside.run(
        [copy, stop] {
            return core::checkMesh(copy->mesh, {stop, {}});
        },
        [this, stop](const core::MeshReport& report) { take(report, stop); });
}

void ModelInquiry::take(const core::MeshReport& report, const std::stop_token& stop)
{
    if (stop.stop_requested())
        return;
    setAnswered();
    Q_EMIT answered(report);
}
} // namespace app
