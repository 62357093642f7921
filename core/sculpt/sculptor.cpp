#include "core/sculpt/sculptor.h"

#include "core/sculpt/dab_engine.h"
#include "core/stroke/stroke_anchor.h"
#include "core/stroke/stroke_path.h"

namespace core
{
class Sculptor::Engine
{
public:
    explicit Engine(Mesh& mesh) : dabs(mesh) {}

    DabEngine dabs;
    StrokeSettings settings;
    std::optional<StrokePath> path;
    std::optional<StrokeAnchor> anchor;
    std::function<void()> betweenSubsteps;
    std::function<void(const DabReport&)> afterDab;

    std::optional<Vec3> centerOf(const Vec3& position, const Vec3& direction) const;
    DabReport apply(Dab dab);
};

/// Where a dab's centre comes from (`place`, DESIGN section 4).
std::optional<Vec3> Sculptor::Engine::centerOf(const Vec3& position, const Vec3& direction) const
{
    if (anchor->isSet())
        return anchor->placeOf(position, direction);
    std::optional<SurfaceHit> hit;
    switch (settings.brush == BrushShape::Ray ? Placement::Ray : settings.place) {
    case Placement::Point:
        return position;
    case Placement::Nearest:
        hit = nearestPoint(dabs.mesh(), dabs.octree(), position);
        break;
    case Placement::Ray:
        hit = firstHit(dabs.mesh(), dabs.octree(), {position, direction});
        break;
    }
    return hit ? std::optional(hit->position) : std::nullopt;
}

DabReport Sculptor::Engine::apply(Dab dab)
{
    anchor->place(dab);
    const DabReport report = dabs.apply(settings, dab, betweenSubsteps);
    anchor->follow(dab, report);
    return report;
}

Sculptor::Sculptor(std::unique_ptr<Mesh> mesh) : m_mesh(std::move(mesh)), m_engine(std::make_unique<Engine>(*m_mesh)) {}

Sculptor::~Sculptor() = default;

void Sculptor::setVerification(bool on)
{
    m_engine->dabs.setVerification(on);
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
    m_engine->settings = settings;
    m_engine->path.emplace(settings);
    m_engine->anchor.emplace(settings);
    m_engine->dabs.beginStroke();
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
    m_engine->dabs.follow(delta);
}

std::optional<SurfaceHit> Sculptor::hit(const Ray& ray) const
{
    return firstHit(*m_mesh, m_engine->dabs.octree(), ray);
}

std::optional<SurfaceHit> Sculptor::nearest(const Vec3& point, double within) const
{
    return nearestPoint(*m_mesh, m_engine->dabs.octree(), point, within);
}

std::optional<SelectionQuality> Sculptor::selectionQuality() const
{
    return m_engine->dabs.selectionQuality();
}

Footprint Sculptor::footprint(const StrokeSettings& settings, const Vec3& center)
{
    return m_engine->dabs.footprint(settings, center);
}

MeshPatch Sculptor::takePatch()
{
    return m_engine->dabs.dirtySlots().take(*m_mesh);
}

MeshPatch Sculptor::wholePatch() const
{
    return wholePatchOf(*m_mesh);
}

SculptorTotals Sculptor::totals() const
{
    return m_engine->dabs.totals();
}

bool Sculptor::indexIsConsistent() const
{
    return m_engine->dabs.octree().isConsistent(*m_mesh);
}
} // namespace core
