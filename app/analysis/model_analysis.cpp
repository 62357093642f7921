#include "app/analysis/model_analysis.h"

#include "app/document/document.h"

#include "ui/util/part_name.h"

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
            const DocumentParts& parts = document().parts();
            const core::Part* const part = parts.list().size() > 1 ? parts.list().find(parts.active()) : nullptr;
            Q_EMIT finished(report, part ? ui::partName(*part) : QString());
        });
}
} // namespace app
