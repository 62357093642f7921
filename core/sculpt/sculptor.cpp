#include "core/sculpt/sculptor.h"

#include "core/sculpt/dab_selection.h"
#include "core/sculpt/deform/dab_weights.h"
#include "core/sculpt/radial_dabs.h"
#include "core/sculpt/select/selector.h"
#include "core/stroke/stroke_anchor.h"
#include "core/stroke/stroke_path.h"
#include "core/util/phase_timer.h"

namespace core
{
namespace
{
/// A centre this near to its ray, in radii, is on it.
constexpr double centerTolerance = 0.02;
constexpr int maxCenterSearches = 12;

bool isAtRest(const StrokeSettings& settings, const Dab& dab)
{
    return isDragTool(settings.tool) && (settings.tool == Tool::Twist ? dab.turn == 0 : dab.motion.isZero());
}
} // namespace

/// The surface, the stages of a dab, and the state of the open stroke.
class Sculptor::Engine
{
public:
    explicit Engine(Mesh& mesh) : surface(mesh) { warmUp(); }

    void beginStroke(const StrokeSettings& strokeSettings);
    std::optional<Vec3> centerOf(const Vec3& position, const Vec3& direction) const;
    std::optional<Vec3> centerOnRay(const Ray& ray) const;
    DabReport apply(Dab dab);
    std::vector<DabReport> applyDue();
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
    SectorGrabs grabs{surface};
    StrokeDisplacements displacements;
    RestLengths rest;
    std::optional<EdgeBounds> lastBounds; ///< edge lengths of the last dab, if it remeshes

private:
    void warmUp();
    DabReport sculpt(const Dab& dab);
    DabReport selectOnly(DabRequest& request, const Dab& dab);

    Region m_footprintRegion; ///< of its own: a footprint may be asked for in the middle of a dab
};

void Sculptor::Engine::beginStroke(const StrokeSettings& strokeSettings)
{
    settings = strokeSettings;
    path.emplace(settings);
    anchor.emplace(settings);
    grabs.beginStroke();
    displacements.clear();
    rest.clear();
}

/// Returns a dab's centre as the stroke places it (StrokeSettings::place); nothing where a ray misses. On the surface
/// it is where the stroke found it, before it raised it: else a stroke would climb onto its own ridge, most of all
/// where the surface turns away.
std::optional<Vec3> Sculptor::Engine::centerOf(const Vec3& position, const Vec3& direction) const
{
    if (anchor->isSet())
        return anchor->placeOf(position, direction);
    switch (settings.brush == BrushShape::Ray ? Placement::Ray : settings.place) {
    case Placement::Point:
        return position;
    case Placement::Nearest:
        if (const std::optional<SurfaceHit> hit = nearestPoint(surface.mesh(), surface.octree(), position))
            return displacements.atRest(*hit, surface.mesh());
        return std::nullopt;
    case Placement::Ray:
        return centerOnRay({position, direction});
    }
    return std::nullopt;
}

/// Returns where the ray met the surface before the stroke. Searches with a ray that is moved as far as the stroke has
/// moved what it met.
std::optional<Vec3> Sculptor::Engine::centerOnRay(const Ray& ray) const
{
    const Vec3 way = ray.direction.normalized();
    std::optional<Vec3> center;
    double least = std::numeric_limits<double>::infinity();
    Vec3 moved = Vec3::Zero();
    for (int i = 0; i < maxCenterSearches && least > centerTolerance * settings.radius; ++i) {
        const auto hit = firstHit(surface.mesh(), surface.octree(), {ray.origin + moved, ray.direction});
        if (!hit)
            break;
        const Vec3 atRest = displacements.atRest(*hit, surface.mesh());
        const double beside = (atRest - ray.origin).cross(way).norm();
        if (beside < least) {
            least = beside;
            center = atRest;
        }
        moved = hit->position - atRest;
    }
    return center;
}

DabReport Sculptor::Engine::apply(Dab dab)
{
    anchor->place(dab);
    const DabReport report = sculpt(dab);
    anchor->follow(dab, report);
    return report;
}

/// Applies the dabs that are due on the path. Returns their reports.
std::vector<DabReport> Sculptor::Engine::applyDue()
{
    std::vector<DabReport> reports;
    const auto center = [this](const Vec3& position, const Vec3& direction) { return centerOf(position, direction); };
    while (const auto due = path->next(center)) {
        reports.push_back(due->hasCenter ? apply(due->dab) : DabReport());
        if (due->isResting)
            displacements.clear(); // where the hand rests the brush follows what it raises
        if (afterDab)
            afterDab(reports.back());
    }
    return reports;
}

/// Routes the dab. A pipeline adds solids, paints, or deforms, by what is under the brush.
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
    report.verifyMs = surface.verifyMs() - verifiedBefore;
    if (report.touchedFaces == 0)
        report.touchedFaces = surface.maxDirtyFaces();
    return report;
}

/// Selects, and moves nothing: a drag tool has not moved since the dab before.
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

/// Warms the pipeline up with a dab at the last vertex: memory that has room for it has room for all.
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
    pipeline.warmUp(context);
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

void Sculptor::beginStroke(const StrokeSettings& settings)
{
    m_engine->beginStroke(settings);
    m_mesh->beginStroke();
}

std::vector<DabReport> Sculptor::addSample(const StrokeSample& sample)
{
    if (!isUsable(m_engine->settings, sample)) {
        if (m_engine->afterDab)
            m_engine->afterDab({});
        return {DabReport()};
    }
    m_engine->path->add(sample);
    return m_engine->applyDue();
}

MeshDelta Sculptor::endStroke()
{
    m_engine->path->finish();
    m_engine->applyDue();
    m_engine->path.reset();
    m_engine->anchor.reset();
    return m_mesh->endStroke();
}

void Sculptor::swap(MeshDelta& delta)
{
    m_mesh->swap(delta);
    m_engine->surface.follow(delta);
    m_engine->lastBounds.reset(); // the last selection may be gone
}

std::optional<SurfaceHit> Sculptor::hit(const Ray& ray) const
{
    return firstHit(*m_mesh, m_engine->surface.octree(), ray);
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
