#include "core/sculpt/sculptor.h"

#include "core/sculpt/dab_selection.h"
#include "core/sculpt/deform/dab_weights.h"
#include "core/sculpt/radial_dabs.h"
#include "core/sculpt/select/selector.h"
#include "core/stroke/stroke_anchor.h"
#include "core/stroke/stroke_path.h"
#include "core/util/phase_timer.h"

#include <utility>

namespace core
{
namespace
{
/// nearestPlace() ends its search when two successive estimates of the displacement differ by at most this, in radii.
constexpr double centerTolerance = 0.02;
constexpr int maxCenterSearches = 12;

bool isAtRest(const StrokeSettings& settings, const Dab& dab)
{
    return isDragTool(settings.tool) && (settings.tool == Tool::Twist ? dab.turn == 0 : dab.motion.isZero());
}
} // namespace

/// Owns the surface, the stages of a dab, and the state of the open stroke.
class Sculptor::Engine
{
public:
    /// A point of the surface: where it was before the stroke moved it, and where it is now.
    struct SurfacePlace
    {
        Vec3 atRest, now;
    };

    explicit Engine(Mesh& mesh) : surface(mesh) { warmUp(); }

    void beginStroke(const StrokeSettings& strokeSettings);
    void startOver();
    void takeBackShown();
    void swap(MeshDelta& delta);
    std::optional<Vec3> centerOf(const Vec3& position, const Vec3& direction) const;
    std::optional<SurfacePlace> placeOf(const Vec3& position, const Vec3& direction) const;
    std::optional<SurfacePlace> placeOnRay(const Ray& ray) const;
    std::optional<SurfacePlace> nearestPlace(const Vec3& hand) const;
    void placeResting(StrokePath::Due& due) const;
    Placement placement() const { return settings.brush == BrushShape::Ray ? Placement::Ray : settings.place; }
    DabReport apply(Dab dab);
    std::vector<DabReport> applyDue(StrokePath& dabs);
    Footprint footprint(const StrokeSettings& strokeSettings, const Vec3& center);

    VerifiedMesh surface;
    DabPipeline pipeline;
    MirroredDab mirroredDab{surface, pipeline};
    RadialDabs radialDabs{surface, mirroredDab};
    SculptorTotals totals;
    std::function<void()> betweenSubsteps;
    std::function<void(const DabReport&)> afterDab;

    StrokeSettings settings;
    std::optional<StrokePath> path;
    std::optional<StrokeAnchor> anchor;
    /// StrokeSettings::add as it was at the stroke's start; `settings.add` is cleared after the first dab
    bool mayAdd = false;
    bool isOver = false;    ///< the stroke ignores all further dabs (DabRequest::isOver)
    bool isEditable = true; ///< whether the stroke's part may be changed
    bool isShown = false;   ///< the newest sample's preview of an anchored stroke is applied to the mesh
    SectorGrabs grabs{surface};
    StrokeDisplacements displacements;
    RestLengths rest;
    std::optional<EdgeBounds> lastBounds; ///< edge bounds of the last dab; empty if it only painted or added a solid

private:
    void warmUp();
    DabReport sculpt(const Dab& dab);
    DabReport selectOnly(DabRequest& request, const Dab& dab);

    /// separate from the grabs' regions, because a footprint may be requested in the middle of a dab
    Region m_footprintRegion;
};

void Sculptor::Engine::beginStroke(const StrokeSettings& strokeSettings)
{
    settings = strokeSettings;
    surface.activate(settings.part);
    isEditable = surface.mesh().frame().parts.isEditable(settings.part);
    mayAdd = settings.add;
    path.emplace(settings);
    isShown = false;
    startOver();
}

/// Clears all that the stroke has recorded about its dabs.
void Sculptor::Engine::startOver()
{
    anchor.emplace(settings);
    settings.add = mayAdd;
    isOver = false;
    grabs.beginStroke();
    pipeline.beginStroke();
    displacements.clear();
    rest.clear();
}

/// Restores the mesh from before the stroke. The stroke stays open.
void Sculptor::Engine::takeBackShown()
{
    MeshDelta shown = surface.mesh().endStroke();
    swap(shown);
    startOver();
    surface.mesh().beginStroke();
}

void Sculptor::Engine::swap(MeshDelta& delta)
{
    surface.mesh().swap(delta);
    surface.follow(delta);
    lastBounds.reset(); // the vertices of the last selection may no longer exist
}

/// Returns a dab's centre as StrokeSettings::place asks for it; nothing if a ray misses. A centre on the surface refers
/// to the surface before the stroke moved it. Otherwise a stroke would climb onto its own ridge, most of all where the
/// surface turns away from the viewer.
std::optional<Vec3> Sculptor::Engine::centerOf(const Vec3& position, const Vec3& direction) const
{
    if (anchor->isSet())
        return anchor->placeOf(position, direction);
    if (placement() == Placement::Point) {
        const auto hold = settings.tool == Tool::SnakeHook
                              ? nearestPoint(surface.mesh(), surface.octree(), position, settings.radius)
                              : std::nullopt;
        return hold ? hold->position : position;
    }
    const std::optional<SurfacePlace> place = placeOf(position, direction);
    return place ? std::optional(place->atRest) : std::nullopt;
}

/// Moves the centre of an airbrush dab to the current surface, so that the shape under a pointer at rest keeps growing.
void Sculptor::Engine::placeResting(StrokePath::Due& due) const
{
    if (placement() == Placement::Point)
        return;
    if (const std::optional<SurfacePlace> place = placeOf(due.hand, due.dab.direction))
        due.dab.position = place->now;
}

/// Returns the surface point that the ray meets, or the one nearest to the position. Both refer to the surface before
/// the stroke.
std::optional<Sculptor::Engine::SurfacePlace> Sculptor::Engine::placeOf(const Vec3& position,
                                                                        const Vec3& direction) const
{
    return placement() == Placement::Ray ? placeOnRay({position, direction}) : nearestPlace(position);
}

/// Returns the point where the ray meets the surface as it was before the stroke. Returns nothing if the ray meets only
/// material that the stroke has raised.
std::optional<Sculptor::Engine::SurfacePlace> Sculptor::Engine::placeOnRay(const Ray& ray) const
{
    const Mesh& mesh = surface.mesh();
    const auto cornersAtRest = [&](Slot f) { return displacements.cornersAtRest(f, mesh); };
    const auto hit = firstHit(mesh, surface.octree(), ray, cornersAtRest, displacements.longest());
    return hit ? std::optional(SurfacePlace{hit->position, displacements.now(*hit, mesh)}) : std::nullopt;
}

/// Returns the surface point that was nearest to `hand` before the stroke. Fixed-point iteration: searches the current
/// surface from `hand`, displaced by the stroke's displacement at the nearest point found so far.
std::optional<Sculptor::Engine::SurfacePlace> Sculptor::Engine::nearestPlace(const Vec3& hand) const
{
    std::optional<SurfacePlace> found;
    double least = std::numeric_limits<double>::infinity();
    Vec3 moved = Vec3::Zero();
    for (int i = 0; i < maxCenterSearches; ++i) {
        const std::optional<SurfaceHit> hit = nearestPoint(surface.mesh(), surface.octree(), hand + moved);
        if (!hit)
            break;
        const Vec3 atRest = displacements.atRest(*hit, surface.mesh());
        const Vec3 before = std::exchange(moved, hit->position - atRest);
        if (const double distance = (hand - atRest).norm(); distance < least) {
            least = distance;
            found = {atRest, hit->position};
        }
        if ((moved - before).norm() <= centerTolerance * settings.radius)
            break;
    }
    return found;
}

DabReport Sculptor::Engine::apply(Dab dab)
{
    anchor->place(dab);
    const DabReport report = sculpt(dab);
    anchor->follow(dab, report);
    if (!settings.join && report.outcome != DabOutcome::Empty)
        settings.add = false;
    if (settings.tool == Tool::Stamp && report.outcome == DabOutcome::Added && !settings.join)
        isOver = true; // otherwise the next stamp would be pressed into the solid just added
    return report;
}

/// Applies the dabs that are due on the path. Returns their reports.
std::vector<DabReport> Sculptor::Engine::applyDue(StrokePath& dabs)
{
    std::vector<DabReport> reports;
    const auto center = [this](const Vec3& position, const Vec3& direction) { return centerOf(position, direction); };
    while (auto due = dabs.next(center)) {
        if (due->isResting)
            placeResting(*due);
        if (!anchor->isSet())
            anchor->takeHold(due->hand);
        const auto tell = [&](const DabReport& report) {
            reports.push_back(report);
            if (afterDab)
                afterDab(report);
        };
        if (!due->hasCenter || isOver || !isEditable) {
            tell({});
            continue;
        }
        for (const Dab& dab : anchor->divide(due->dab)) {
            tell(apply(dab));
            if (isOver || reports.back().capped || reports.back().wall)
                break; // the rest of the way would cost as much, and get no further
        }
    }
    return reports;
}

/// Applies the dab, in all sectors and on both sides of a mirror if the stroke has these. DabPipeline then decides
/// whether to add a solid, paint or deform.
DabReport Sculptor::Engine::sculpt(const Dab& dab)
{
    lastBounds.reset();
    DabReport report;
    if (!(dab.strength > 0))
        return report;
    DabRequest request = {settings, displacements, rest, betweenSubsteps, totals};
    if (isAtRest(settings, dab))
        return selectOnly(request, dab);
    const double verifiedBefore = surface.verifyMs();
    surface.forgetDirtyFaces();
    {
        const PhaseTimer timer(report.totalMs);
        report = settings.radial > 1 ? radialDabs.apply(request, dab, grabs)
                                     : mirroredDab.apply(request, dab, grabs.first());
    }
    lastBounds = request.bounds;
    isOver = request.isOver;
    report.verifyMs = surface.verifyMs() - verifiedBefore;
    if (report.touchedFaces == 0)
        report.touchedFaces = surface.maxDirtyFaces();
    return report;
}

/// Only selects, because a drag tool has not moved since the previous dab.
DabReport Sculptor::Engine::selectOnly(DabRequest& request, const Dab& dab)
{
    DabContext context(surface, request, dab, grabs.first().own);
    if (!context.grab.state.isOn)
        selectRegion(context);
    context.report.outcome = context.region.empty() ? DabOutcome::Empty : DabOutcome::Committed;
    context.report.touchedVertices = context.region.size();
    return context.report;
}

Footprint Sculptor::Engine::footprint(const StrokeSettings& strokeSettings, const Vec3& center)
{
    const Mesh& mesh = surface.mesh();
    const Selector selector(mesh, surface.octree());
    Region& region = m_footprintRegion;
    Footprint footprint;
    std::vector<Slot> candidates;
    const auto add = [&](const Dab& dab) {
        selector.select(region, candidates, strokeSettings.brush, {dab.position, dab.radius}, Footprint::maxSlots);
        const DabWeights weights(region, mesh, strokeSettings, dab);
        region.forEach([&](Slot v) {
            footprint.slots.push_back(v);
            const double free = strokeSettings.tool == Tool::Mask ? 1 : mesh.freedom(v);
            footprint.weights.push_back(static_cast<std::uint8_t>(1 + 254 * free * weights.of(v)));
        });
    };
    Dab dab;
    dab.position = center;
    dab.radius = strokeSettings.radius;
    MirrorMap mirror(mesh);
    mirror.setPlane(strokeSettings.symmetry);
    for (int k = 0; k < strokeSettings.radial; ++k) {
        const Dab inSector = Turn::part(k, strokeSettings.radial) * dab;
        add(inSector);
        if (mirror.isOn())
            add(mirror.imageOf(inSector));
    }
    return footprint;
}

/// Warms the pipeline up with a dab at the vertex of the highest slot, so that containers indexed by slot allocate
/// memory for all slots.
void Sculptor::Engine::warmUp()
{
    const Mesh& mesh = surface.mesh();
    if (mesh.live().vertices == 0)
        return;
    Slot v = mesh.slots().vertices - 1;
    while (!mesh.isVertex(v))
        --v;
    Dab dab;
    dab.position = mesh.point(v).cast<double>();
    dab.radius = mesh.uniformDetail() / edgeBounds(1, settings.detail).detail;
    dab.strength = 1;
    DabRequest request = {settings, displacements, rest, betweenSubsteps, totals};
    DabContext context(surface, request, dab, grabs.first().own);
    const PartId active = surface.octree().activePart();
    surface.activate(mesh.part(v));
    pipeline.warmUp(context);
    surface.activate(active);
}

Sculptor::Sculptor(std::unique_ptr<Mesh> mesh) : m_mesh(std::move(mesh)), m_engine(std::make_unique<Engine>(*m_mesh)) {}

Sculptor::~Sculptor() = default;

void Sculptor::setVerification(bool on)
{
    m_engine->surface.setVerification(on);
}

void Sculptor::setBetweenSubsteps(std::function<void()> hook)
{
    m_engine->betweenSubsteps = std::move(hook);
}

void Sculptor::setAfterDab(std::function<void(const DabReport&)> hook)
{
    m_engine->afterDab = std::move(hook);
}

void Sculptor::activate(PartId part)
{
    m_engine->surface.activate(part);
}

PartId Sculptor::activePart() const
{
    return m_engine->surface.octree().activePart();
}

void Sculptor::beginStroke(const StrokeSettings& settings)
{
    m_engine->beginStroke(settings);
    m_mesh->beginStroke();
}

std::vector<DabReport> Sculptor::addSample(const StrokeSample& sample, Anchored anchored)
{
    if (!isUsable(m_engine->settings, sample)) {
        if (m_engine->afterDab)
            m_engine->afterDab({});
        return {DabReport()};
    }
    m_engine->path->add(sample);
    m_engine->isShown = isAnchored(m_engine->settings) && anchored == Anchored::Shown;
    if (!m_engine->isShown)
        return m_engine->applyDue(*m_engine->path);
    m_engine->takeBackShown();
    StrokePath ended = *m_engine->path;
    ended.finish();
    return m_engine->applyDue(ended);
}

MeshDelta Sculptor::endStroke(StrokeEnd how)
{
    if (how == StrokeEnd::Kept && !m_engine->isShown) {
        if (isAnchored(m_engine->settings))
            m_engine->takeBackShown();
        m_engine->path->finish();
        m_engine->applyDue(*m_engine->path);
    }
    m_engine->path.reset();
    m_engine->anchor.reset();
    MeshDelta delta = m_mesh->endStroke();
    if (how == StrokeEnd::Kept)
        return delta;
    swap(delta);
    return {};
}

void Sculptor::swap(MeshDelta& delta)
{
    m_engine->swap(delta);
}

std::optional<SurfaceHit> Sculptor::hit(const Ray& ray) const
{
    return firstHit(*m_mesh, m_engine->surface.octree(), ray);
}

std::optional<Sculptor::PartHit> Sculptor::visibleHit(const Ray& ray)
{
    const PartId before = activePart();
    std::optional<PartHit> found;
    for (const Part& part : m_mesh->frame().parts.all()) {
        if (!part.isVisible)
            continue;
        activate(part.id);
        if (const auto at = hit(ray); at && (!found || at->distance < found->hit.distance))
            found = PartHit{part.id, *at};
    }
    activate(before);
    return found;
}

std::optional<SurfaceHit> Sculptor::nearest(const Vec3& point, double within) const
{
    return nearestPoint(*m_mesh, m_engine->surface.octree(), point, within);
}

std::optional<SelectionQuality> Sculptor::selectionQuality() const
{
    if (!m_engine->lastBounds)
        return std::nullopt;
    return core::selectionQuality(*m_mesh, m_engine->grabs.first().own.region, *m_engine->lastBounds);
}

Footprint Sculptor::footprint(const StrokeSettings& settings, const Vec3& center)
{
    return m_engine->footprint(settings, center);
}

MeshPatch Sculptor::takePatch()
{
    return m_engine->surface.dirtySlots().take(*m_mesh);
}

MeshPatch Sculptor::wholePatch() const
{
    return wholePatchOf(*m_mesh);
}

SculptorTotals Sculptor::totals() const
{
    SculptorTotals totals = m_engine->totals;
    totals.verifyTiers = m_engine->surface.tiers();
    return totals;
}

bool Sculptor::indexIsConsistent() const
{
    return m_engine->surface.octree().isConsistent(*m_mesh);
}
} // namespace core
