#pragma once

#include "core/mesh/footprint.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_patch.h"
#include "core/mesh/surface_query.h"
#include "core/sculpt/sculptor_totals.h"
#include "core/sculpt/selection_quality.h"
#include "core/stroke/stroke.h"

#include <functional>
#include <memory>

namespace core
{
/// Sculpts one mesh. Not thread-safe: lives on the mesh thread. After every dab the mesh is closed, manifold,
/// consistently oriented, free of self-intersections and bounds a solid, if it was before; a dab that would break this
/// ends early.
class Sculptor
{
public:
    /// Takes a mesh that passed `buildMesh`. Cost: O(faces), for the octree.
    explicit Sculptor(std::unique_ptr<Mesh> mesh);
    ~Sculptor();

    const Mesh& mesh() const { return *m_mesh; }

    /// On from the start. Off only to learn what verification costs: then the promise is not kept.
    void setVerification(bool on);
    /// Called between sub-steps, on the thread that called addSample; the mesh is valid then and may be read.
    void setBetweenSubsteps(std::function<void()> hook);
    /// Called after each dab, on the same thread, outside the times that the report tells.
    void setAfterDab(std::function<void(const DabReport&)> hook);

    void beginStroke(const StrokeSettings& settings);
    bool strokeOpen() const { return m_mesh->strokeOpen(); }
    /// Places the dabs that the path up to this sample holds, and applies them. A sample that is not usable (isUsable)
    /// is one empty dab, and no part of the path.
    std::vector<DabReport> addSample(const StrokeSample& sample);
    /// Closes the stroke. The delta is already applied; it is empty if nothing changed.
    MeshDelta endStroke();

    /// Applies a delta backwards, or forwards again: swaps its images with the mesh's. Cost: the delta's elements.
    void swap(MeshDelta& delta);

    /// First hit from outside, or nothing. Cost: O(faces near the ray).
    std::optional<SurfaceHit> hit(const Ray& ray) const;
    /// The surface's nearest point, if it is no farther than that. Cost: O(faces in the ball of that radius).
    std::optional<SurfaceHit> nearest(const Vec3& point, double within) const;

    /// What the next dab with these settings selects on the mesh as it is, if its centre is there; of the ray brush
    /// nothing where it would be more than Footprint::maxSlots on a side. May be called between sub-steps. Cost: the
    /// selection.
    Footprint footprint(const StrokeSettings& settings, const Vec3& center);

    /// What changed since the last call.
    MeshPatch takePatch();
    /// Everything, for a viewer that comes late. Does not change what takePatch returns next.
    MeshPatch wholePatch() const;

    /// Of what the last dab selected, as the mesh is now; nothing if that dab remeshes nothing. Cost: O(selection).
    std::optional<SelectionQuality> selectionQuality() const;

    SculptorTotals totals() const;

    /// For tests: the octree against the mesh.
    bool indexIsConsistent() const;

private:
    class Engine;
    std::unique_ptr<Mesh> m_mesh;
    std::unique_ptr<Engine> m_engine;
};
} // namespace core
