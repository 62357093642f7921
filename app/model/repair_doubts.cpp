#include "app/model/repair_doubts.h"

#include "core/drawing/model_thumbnail.h"
#include "core/repair/repair.h"
#include "ui/files/thumbnail_maker.h"
#include "ui/util/repair_messages.h"

namespace app
{
namespace
{
QImage pictureOf(const core::TriangleMesh& mesh)
{
    constexpr int pixels = 192; // small enough to show two pictures side by side in a dialog
    return ui::toImage(core::drawThumbnail(mesh, pixels, {}).value());
}
} // namespace

std::optional<ui::RepairDoubt> repairDoubt(ui::RepairUse use, const QString& name, const core::RepairResult& repaired,
                                           const core::TriangleMesh& old)
{
    if (repaired.report.isFaithful())
        return std::nullopt;
    return ui::RepairDoubt{use, ui::RepairMessages::doubt(name, repaired.report),
                           ui::RepairMessages::losses(repaired.report), pictureOf(old), pictureOf(*repaired.mesh)};
}
} // namespace app
