#pragma once

#include "core/operations/model_command.h"
#include "core/repair/repair.h"

#include <QString>

#include <optional>

namespace ui
{
/// A model in a file that is to be added to the present one, as the person wants it. A value.
struct Insertion
{
    QString path;
    core::Insert::Place place = core::Insert::Place::Beside;
    core::Vec3 centre = core::Vec3::Zero(); ///< with Place::Centre
    double unit = 1;                        ///< as so many mm the file's unit is taken; above 0
    /// A model that is not in order is legalised; else it is refused.
    std::optional<core::RepairOptions> mend = std::nullopt;
};
} // namespace ui
