#include "core/sculpt/dab_context.h"

#include "core/sculpt/dab_bounds.h"

namespace core
{
DabContext::DabContext(VerifiedMesh& surfaceToEdit, DabRequest& dabRequest, const Dab& dabToDo, Grab& dabGrab)
    : surface(surfaceToEdit)
    , request(dabRequest)
    , settings(dabRequest.settings)
    , dab(dabToDo)
    , grab(dabGrab)
    , region(dabGrab.region)
    , ball{dabToDo.position, dabToDo.radius}
    , bounds(dabBounds(settings, surfaceToEdit.mesh(), dabToDo.radius))
{}

Slot DabContext::touchedVertices() const
{
    Slot images = 0;
    if (mirror)
        region.forEach([&](Slot v) { images += mirror->isOnPlane(v) ? 0 : 1; });
    return region.size() + images;
}

void DabContext::allowFusion()
{
    canFuse = true;
    bounds = dabBounds(settings, mesh(), dab.radius);
}

void DabContext::count(const RemeshCounts& counts)
{
    request.totals.splits += counts.splits;
    request.totals.collapses += counts.collapses;
    request.totals.flips += counts.flips;
    blocked = counts.blocked;
    isCapped = isCapped || counts.capped;
}
} // namespace core
