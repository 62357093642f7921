#pragma once

#include "core/operations/model_command.h"
#include "core/repair/repair.h"

#include <QString>

#include <optional>

namespace ui
{
/// A request to add the model of a file to the present one. A value.
struct InsertRequest
{
    QString path;
    core::Insert::Place place = core::Insert::Place::Beside;
    core::Vec3 centre = core::Vec3::Zero(); ///< with Place::Centre
    double unit = 1;                        ///< as so many mm the file's unit is taken; above 0
    /// repairs a model that is not sound; else it is refused.
    std::optional<core::RepairOptions> repair = std::nullopt;
    bool acceptsLoss = false; ///< the person saw what the repair loses, and takes it
};
} // namespace ui
