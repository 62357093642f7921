#pragma once

#include "ui/model/repair_doubt.h"

#include <optional>

namespace core
{
struct RepairResult;
struct TriangleMesh;
} // namespace core

namespace app
{
/// Returns a description of what a repair lost, with pictures of the model before and after; nothing if the repair
/// preserved the model. Precondition: `repaired` has a mesh. Thread: any. Cost: two rendered pictures.
std::optional<ui::RepairDoubt> repairDoubt(ui::RepairUse use, const QString& name, const core::RepairResult& repaired,
                                           const core::TriangleMesh& old);
} // namespace app
