#pragma once

#include <QString>

namespace ui
{
/// Returns the path of prusa-slicer, searched on PATH; empty if it is not installed.
QString installedSlicer();
} // namespace ui
