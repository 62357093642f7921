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
/// Returns what a person must know of a repair that did not keep the model, with pictures; nothing if it kept it.
/// `repaired` has a mesh. Thread: any. Cost: two pictures.
std::optional<ui::RepairDoubt> repairDoubt(ui::RepairUse use, const QString& name, const core::RepairResult& repaired,
                                           const core::TriangleMesh& old);
} // namespace app
