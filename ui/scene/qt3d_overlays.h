#pragma once

#include "ui/scene/overlay.h"

class QOffscreenSurface;

namespace ui
{
/// Makes a renderer that draws the overlays as entities of Qt3D, on demand and on the calling thread, in Qt3D's
/// context, which is then current on the surface. The surface must outlive it. Returns null in a build without Qt3D
/// (FETTLE_QT3D=OFF), and if Qt3D does not draw into the framebuffer that is bound when its context is current: the
/// overlays would then not meet the clay's depth. Cost: a few frames, in which Qt3D loads its shaders.
std::unique_ptr<OverlayRenderer> makeQt3dOverlays(QOffscreenSurface& surface,
                                                  const std::vector<const Overlay*>& overlays);
} // namespace ui
