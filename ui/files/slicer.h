#pragma once

#include <QString>

namespace ui
{
/// Of prusa-slicer, where it stands on the PATH; else empty.
QString installedSlicer();
} // namespace ui
