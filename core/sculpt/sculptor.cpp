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
    DabReport apply(Dab dab);
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
    LayerHeights heights;
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
    heights.clear();
    rest.clear();
}

/// Returns a dab's centre as the stroke places it (StrokeSettings::place); nothing where a ray misses.
std::optional<Vec3> Sculptor::Engine::centerOf(const Vec3& position, const Vec3& direction) const
{
    if (anchor->isSet())
        return anchor->placeOf(position, direction);
    std::optional<SurfaceHit> hit;
    switch (settings.brush == BrushShape::Ray ? Placement::Ray : settings.place) {
    case Placement::Point:
        return position;
    case Placement::Nearest:
        hit = nearestPoint(surface.mesh(), surface.octree(), position);
        break;
    case Placement::Ray:
        hit = firstHit(surface.mesh(), surface.octree(), {position, direction});
        break;
    }
    return hit ? std::optional(hit->position) : std::nullopt;
}

DabReport Sculptor::Engine::apply(Dab dab)
{
    anchor->place(dab);
    const DabReport report = sculpt(dab);
    anchor->follow(dab, report);
    return report;
}

/// Routes the dab. A pipeline adds solids, paints, or deforms, by what is under the brush.
DabReport Sculptor::Engine::sculpt(const Dab& dab)
{
    lastBounds.reset();
    DabReport report;
    if (!(dab.strength > 0))
        return report;
    DabRequest request = {settings, heights, rest, betweenSubsteps, totals};
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
    DabRequest request = {settings, heights, rest, betweenSubsteps, totals};
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
    std::vector<DabReport> reports;
    Engine& engine = *m_engine;
    const auto report = [&](const DabReport& dab) {
        reports.push_back(dab);
        if (engine.afterDab)
            engine.afterDab(dab);
    };
    if (isUsable(engine.settings, sample))
        engine.path->add(sample);
    else
        report({});
    const auto centerOf = [&](const Vec3& position, const Vec3& direction) {
        return engine.centerOf(position, direction);
    };
    while (const auto due = engine.path->next(centerOf))
        report(due->hasCenter ? engine.apply(due->dab) : DabReport());
    return reports;
}

MeshDelta Sculptor::endStroke()
{
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
