// What a dab works on (paper, sections 3.1 and 3.5.2): the region under the brush, or with symmetry the half of it
// whose image is changed with it; and painting and masking, which are done once it is selected.

#include "core/sculpt/dab_engine.h"

#include "core/mesh/surface_query.h"
#include "core/sculpt/deform/dab_weights.h"
#include "core/sculpt/deform/mirrored_deform.h"
#include "core/stroke/radial_symmetry.h"
#include "core/util/phase_timer.h"

namespace core
{
void DabEngine::run(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                    DabReport& report)
{
    {
        const PhaseTimer timer(report.selectMs);
        take(settings, {dab.position, dab.radius});
    }
    sculpt(settings, dab, between, report);
}

/// A dab and its image (paper, section 3.5.2): at once where the model is symmetric, else one after the other.
void DabEngine::runMirrored(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                            DabReport& report)
{
    m_mirror.setPlane(settings.symmetry);
    const Dab folded = m_mirror.folded(dab.position) == dab.position ? dab : m_mirror.imageOf(dab);
    const Dab first = m_grab.isMirrored ? folded : dab, image = m_mirror.imageOf(first);
    bool mirrored = false;
    {
        const PhaseTimer timer(report.selectMs);
        mirrored = takeMirrored(settings, {folded.position, dab.radius});
    }
    if (mirrored)
        sculpt(settings, folded, between, report);
    m_mirror.setPlane(Symmetry::None);
    if (mirrored)
        return;
    run(settings, first, between, report);
    if (image.position != first.position) {
        DabReport second;
        swapGrabs(settings.tool);
        run(settings, image, between, second);
        swapGrabs(settings.tool);
        report += second;
    }
    report.asymmetric = true;
}

/// Whether all that the ball and its image can change is symmetric, bit for bit.
bool DabEngine::isMirroredIn(BrushShape brush, const Sphere& ball)
{
    const FaceOctree& octree = m_surface.octree();
    if (brush == BrushShape::Ray) // it follows the surface, and finds on the other side what it found here
        return m_mirror.learn(m_candidates, octree);
    m_candidates = facesIn(latticeBox(m_mesh.lattice(), ball));
    std::vector<Slot> faces = facesIn(latticeBox(m_mesh.lattice(), {m_mirror.imageOf(ball.center), ball.radius}));
    faces.insert(faces.end(), m_candidates.begin(), m_candidates.end());
    return m_mirror.learn(faces, octree);
}

/// Exactly the faces whose boxes meet the box, ascending: what the octree finds besides depends on what was there
/// before.
std::vector<Slot> DabEngine::facesIn(const LatticeBox& box) const
{
    std::vector<Slot> faces = core::facesIn(m_mesh, m_surface.octree(), box);
    std::ranges::sort(faces);
    return faces;
}

/// The candidate triangles and the region (paper, section 3.1).
void DabEngine::select(Region& region, std::vector<Slot>& candidates, BrushShape brush, const Sphere& ball,
                       Slot max) const
{
    if (brush == BrushShape::Sphere) {
        selectSphere(region, candidates, m_mesh, m_surface.octree(), ball);
        return;
    }
    candidates.clear();
    region.clear();
    if (const std::optional<SurfaceHit> hit = nearestPoint(m_mesh, m_surface.octree(), ball.center)) {
        candidates.push_back(hit->face);
        selectGeodesic(region, candidates, m_mesh, ball, max);
    }
}

Footprint DabEngine::footprint(const StrokeSettings& settings, const Vec3& center)
{
    Footprint footprint;
    std::vector<Slot> candidates;
    const auto add = [&](const Dab& dab) {
        select(m_footprint, candidates, settings.brush, {dab.position, dab.radius}, Footprint::maxSlots);
        const DabWeights weights(m_footprint, m_mesh, settings, dab);
        m_footprint.forEach([&](Slot v) {
            footprint.slots.push_back(v);
            const double free = settings.tool == Tool::Mask ? 1 : m_mesh.freedom(v);
            footprint.weights.push_back(static_cast<std::uint8_t>(1 + 254 * free * weights.of(v)));
        });
    };
    Dab dab;
    dab.position = center;
    dab.radius = settings.radius;
    MirrorMap mirror(m_mesh);
    mirror.setPlane(settings.symmetry);
    for (int k = 0; k < settings.radial; ++k) {
        const Dab inSector = Turn::part(k, settings.radial) * dab;
        add(inSector);
        if (mirror.isOn())
            add(mirror.imageOf(inSector));
    }
    return footprint;
}

/// The ray brush's selection after refine().
void DabEngine::selectRefined(Region& region, const Sphere& ball)
{
    std::vector<Slot> candidates = m_candidates; // they stay: a sub-step that fails is refined again
    for (Slot v : m_region.remeshed().slots())
        m_mesh.forEachOutgoing(v, [&](Slot h) { candidates.push_back(m_mesh.face(h)); });
    selectGeodesic(region, candidates, m_mesh, ball);
}

bool DabEngine::wantsSolid(const StrokeSettings& settings, const Dab& dab) const
{
    if (!settings.add || !canAddSolid(settings.tool) || settings.brush != BrushShape::Sphere ||
        settings.place != Placement::Point || !m_region.empty())
        return false;
    const std::optional<SurfaceHit> nearest = nearestPoint(m_mesh, m_surface.octree(), dab.position);
    return !nearest || nearest->distance > dab.radius; // else a face is under the brush, if no vertex is
}

/// Colours the region (paper, section 3.5.3), or masks it. A half stands for both: of what the dab gives to a vertex
/// and to its image the larger counts.
void DabEngine::mark(const StrokeSettings& settings, const Dab& dab, DabReport& report)
{
    const Mesh::Mark mark = m_mesh.mark();
    const auto change = [&](Slot v, double share) {
        if (settings.tool == Tool::Paint)
            colour(v, settings.color, share * m_mesh.freedom(v));
        else
            mask(v, settings.inverted ? -share : share);
    };
    m_region.remeshed().clear(); // here nothing is
    if (m_mirror.isOn())
        selectBothSides({settings, dab, {dab.position, dab.radius}, boundsFor(settings, dab.radius)});
    const Region& whole = m_mirror.isOn() ? m_whole : m_region;
    const DabWeights weights(whole, m_mesh, settings, dab);
    m_region.forEach([&](Slot v) {
        const Slot image = m_mirror.isOn() ? m_mirror.imageOf(v) : v;
        const double imageWeight = image != noSlot && whole.contains(image) ? weights.of(image) : 0;
        const double share = std::min(dab.strength, 1.0) * std::max(weights.of(v), imageWeight);
        change(v, share);
        if (image != v)
            change(image, share);
    });
    m_surface.commitUnverified(mark);
    report.touchedVertices = touchedVertices();
    report.outcome = m_region.empty() ? DabOutcome::Empty : DabOutcome::Committed;
}

/// By a share of the way to the colour.
void DabEngine::colour(Slot v, Rgb color, double share)
{
    const Rgb before = m_mesh.color(v), after = mixed(before, color, share);
    if (after != before)
        m_mesh.setColor(v, after);
}

/// By a part of the whole, which adds up from dab to dab.
void DabEngine::mask(Slot v, double change)
{
    const double after = std::clamp(m_mesh.mask(v) + 255 * change, 0.0, 255.0);
    if (const auto rounded = static_cast<std::uint8_t>(after + 0.5); rounded != m_mesh.mask(v))
        m_mesh.setMask(v, rounded);
}

Slot DabEngine::touchedVertices() const
{
    Slot images = 0;
    if (m_mirror.isOn())
        m_region.forEach([&](Slot v) { images += m_mirror.isOnPlane(v) ? 0 : 1; });
    return m_region.size() + images;
}
} // namespace core
