#include "core/sculpt/dab_selection.h"

#include "core/sculpt/deform/mirrored_deform.h"
#include "core/sculpt/select/selector.h"

namespace core
{
namespace
{
Selector selectorOf(const DabContext& context)
{
    return Selector(context.mesh(), context.surface.octree());
}

/// Returns whether the dab selects only the connected part of the surface that is nearest to it. SnakeHook does;
/// otherwise it would push away the surface that its tip approaches, and never meet it.
bool selectsOnePart(const StrokeSettings& settings)
{
    return settings.tool == Tool::SnakeHook && settings.brush == BrushShape::Sphere;
}

/// Stores, for each vertex, the distance of its mirror image (Region::carried()); twice the radius if the image is not
/// selected.
void carryImageDistances(DabContext& context)
{
    Region& region = context.region;
    region.forEach([&](Slot v) {
        const Slot image = context.mirror->imageOf(v);
        const bool hasImage = image != noSlot && region.contains(image);
        region.setCarried(v, hasImage ? region.distance(image) : 2 * context.dab.radius);
    });
}

void selectUnderBrush(DabContext& context)
{
    selectorOf(context).select(context.region, context.candidates, context.settings.brush, context.ball);
    if (selectsOnePart(context.settings))
        selectorOf(context).keepNearestPart(context.region, context.ball);
    if (keepsSelection(context.settings.tool))
        context.grab.measure(context.mesh());
}

/// Returns whether the candidate triangles have mirror images, bit for bit.
bool areMirrored(DabContext& context)
{
    return context.mirror->learn(context.candidates, context.surface.octree());
}

bool isSurfaceMirrored(DabContext& context)
{
    // a mirrored ray brush would select exactly the images of these faces
    if (context.settings.brush == BrushShape::Ray)
        return areMirrored(context);
    const Selector selector = selectorOf(context);
    context.candidates = selector.facesIn(context.ball);
    std::vector<Slot> faces = selector.facesIn({context.mirror->imageOf(context.ball.center), context.ball.radius});
    faces.insert(faces.end(), context.candidates.begin(), context.candidates.end());
    return context.mirror->learn(faces, context.surface.octree());
}

bool isGrabMirrored(DabContext& context)
{
    if (!context.grab.state.isHalf)
        return false;
    context.grab.grow(context.settings, context.mesh(), context.dab);
    context.candidates = context.grab.faces(context.mesh());
    return areMirrored(context);
}

/// Stores, for each vertex of the region, the distance of its mirror image (Region::carried()). In `whole`, that value
/// is stored for both the vertex and its image.
void carryToBothSides(DabContext& context, Region& whole)
{
    context.region.forEach([&](Slot v) {
        const Slot image = context.mirror->imageOf(v);
        const bool hasImage = image != noSlot && whole.contains(image);
        context.region.setCarried(v, hasImage ? whole.distance(image) : 2 * context.dab.radius);
        for (Slot side : {v, image}) {
            if (side != noSlot && whole.contains(side))
                whole.setCarried(side, context.region.carried(v));
        }
    });
}
} // namespace

void selectRegion(DabContext& context)
{
    if (!context.grab.state.isOn)
        return selectUnderBrush(context);
    context.grab.grow(context.settings, context.mesh(), context.dab);
    context.candidates = context.grab.faces(context.mesh());
}

bool selectMirroredRegion(DabContext& context)
{
    const bool isGrabbed = context.grab.state.isOn;
    if (!isGrabbed)
        selectUnderBrush(context);
    const bool isMirrored = isGrabbed ? isGrabMirrored(context) : isSurfaceMirrored(context);
    if (isMirrored && selectsOnePart(context.settings))
        carryImageDistances(context);
    if (isMirrored) // needed for grabs too: fusion may have moved grabbed vertices across the plane
        keepHalf(context.region, *context.mirror);
    return isMirrored;
}

void selectBothSides(DabContext& context, Region& whole)
{
    const bool isGrabbed = context.grab.state.isOn;
    if (isGrabbed || selectsOnePart(context.settings))
        selectWholeGrabbed(whole, context.region, *context.mirror, context.dab.radius);
    else if (context.settings.brush == BrushShape::Ray)
        selectRefined(context, whole);
    else
        selectWhole(whole, context.region, *context.mirror, context.mesh(), context.ball);
    if (keepsSelection(context.settings.tool) && !isGrabbed)
        carryToBothSides(context, whole);
}

void selectRefined(DabContext& context, Region& selected)
{
    selectorOf(context).selectRefined(selected, context.region, context.candidates, context.ball);
}
} // namespace core
