#pragma once

#include "core/operations/model_command.h"
#include "core/repair/repair.h"

#include <QString>

#include <optional>

namespace ui
{
/// A request to insert the model of a file into the present model. A value type.
struct InsertRequest
{
    QString path;
    core::Insert::Place place = core::Insert::Place::Beside;
    core::Vec3 centre = core::Vec3::Zero(); ///< centre of the inserted model, mm; for Place::Centre only
    double unit = 1;                        ///< mm for each unit of the file; above 0
    /// Options for repairing a model that is not sound; nullopt: such a model is refused.
    std::optional<core::RepairOptions> repair = std::nullopt;
    core::Insert::Combination combination = core::Insert::Combination::Apart;
    bool acceptsLoss = false; ///< the user has seen and accepted what the repair loses
};
} // namespace ui
