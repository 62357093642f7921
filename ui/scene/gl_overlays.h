#pragma once

#include "ui/scene/overlay.h"

class QOffscreenSurface;

namespace ui
{
/// Makes a renderer that draws by OpenGL calls of its own, in a context of its own, which is then current on the
/// surface. The surface must outlive it. Returns null if the driver gives no context of OpenGL 3.3 core, or a shader
/// does not compile; the log is in the debug output.
std::unique_ptr<OverlayRenderer> makeGlOverlays(QOffscreenSurface& surface,
                                                const std::vector<const Overlay*>& overlays);
} // namespace ui
