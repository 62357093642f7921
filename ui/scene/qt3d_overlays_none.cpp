// Compiled in place of qt3d_overlays.cpp if the build has no Qt3D.

#include "ui/scene/qt3d_overlays.h"

namespace ui
{
std::unique_ptr<OverlayRenderer> makeQt3dOverlays(QOffscreenSurface&, const std::vector<const Overlay*>&)
{
    return nullptr;
}
} // namespace ui
