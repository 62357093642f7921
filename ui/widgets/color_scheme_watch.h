#pragma once

#include "ui/widgets/system_color_scheme.h"

#include <functional>

namespace ui
{
/// Asks the desktop for its colour scheme, and calls `report` when it answers and after each change, until the returned
/// object is destroyed. Each platform has an implementation in a file of its own. Thread: gui.
std::unique_ptr<QObject> watchColorScheme(std::function<void(SystemColorScheme::Scheme)> report);
} // namespace ui
