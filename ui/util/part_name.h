#pragma once

#include "core/parts/part_list.h"

#include <QString>

namespace ui
{
/// Returns the name of a part as lists show it: its own, or one with its number. Thread: any.
QString partName(const core::Part& part);
} // namespace ui
