#include "core/sculpt/attribute_brush.h"

#include "core/sculpt/dab_selection.h"
#include "core/sculpt/deform/dab_weights.h"

#include <algorithm>

namespace core
{
namespace
{
/// Mixes `share` (0 to 1) of the colour into the vertex's colour.
void paint(Mesh& mesh, Slot v, Rgb color, double share)
{
    const Rgb before = mesh.color(v), after = mixed(before, color, share);
    if (after != before)
        mesh.setColor(v, after);
}

/// Adds to the vertex's mask. `change`: -1 to 1, where 1 is a full mask.
void addMask(Mesh& mesh, Slot v, double change)
{
    const double after = std::clamp(mesh.mask(v) + 255 * change, 0.0, 255.0);
    if (const auto rounded = static_cast<std::uint8_t>(after + 0.5); rounded != mesh.mask(v))
        mesh.setMask(v, rounded);
}

void change(Mesh& mesh, const StrokeSettings& settings, Slot v, double share)
{
    if (mesh.isHidden(v))
        return;
    if (settings.tool == Tool::Paint)
        paint(mesh, v, settings.color, share * mesh.freedom(v));
    else
        addMask(mesh, v, settings.inverted ? -share : share);
}
} // namespace

/// Paints each vertex by its weight. With a mirror, a vertex and its image both get the larger of their two weights.
void AttributeBrush::apply(DabContext& context)
{
    Mesh& mesh = context.surface.mesh();
    const StrokeSettings& settings = context.settings;
    const Mesh::Mark mark = mesh.mark();
    context.region.remeshed().clear();
    if (context.mirror)
        selectBothSides(context, m_whole);
    const Region& whole = context.mirror ? m_whole : context.region;
    const DabWeights weights(whole, mesh, settings, context.dab);
    context.region.forEach([&](Slot v) {
        const Slot image = context.mirror ? context.mirror->imageOf(v) : v;
        const double imageWeight = image != noSlot && whole.contains(image) ? weights.of(image) : 0;
        const double share = std::min(context.dab.strength, 1.0) * std::max(weights.of(v), imageWeight);
        change(mesh, settings, v, share);
        if (image != v)
            change(mesh, settings, image, share);
    });
    context.surface.commitUnverified(mark);
    context.report.touchedVertices = context.touchedVertices();
    context.report.outcome = context.region.empty() ? DabOutcome::Empty : DabOutcome::Committed;
}
} // namespace core
