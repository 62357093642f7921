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
/// Sculpts one mesh. After every dab the mesh is closed, manifold, consistently oriented, free of self-intersections
/// and bounds a solid, if it was before. A dab that would break this ends early. Thread: the mesh thread; not
/// thread-safe.
class Sculptor
{
public:
    /// Takes a mesh that passed `buildMesh`. Cost: O(faces), for the octree.
    explicit Sculptor(std::unique_ptr<Mesh> mesh);
    ~Sculptor();

    const Mesh& mesh() const { return *m_mesh; }

    /// Verification is on from the start. Switched off to measure its cost; the promise is not kept then.
    void setVerification(bool on);
    /// The hook is called between sub-steps. The mesh is valid then and may be read. Thread: that of addSample().
    void setBetweenSubsteps(std::function<void()> hook);
    /// The hook is called after each dab, outside the times of the report. Thread: that of addSample().
    void setAfterDab(std::function<void(const DabReport&)> hook);

    enum class Anchored { Waits, Shown };

    void beginStroke(const StrokeSettings& settings);
    bool strokeOpen() const { return m_mesh->strokeOpen(); }
    /// Places the dabs of the path up to this sample, and applies them. Returns their reports. Those that wait for
    /// another sample (StrokePath::next) come with it, or with endStroke(). A sample that is not usable (isUsable)
    /// counts as one empty dab, and is no part of the path.
    ///
    /// The dab of an anchored stroke waits for its end. Anchored::Shown applies it as if that came now, in place of the
    /// one shown before; the stroke ends as it would without.
    std::vector<DabReport> addSample(const StrokeSample& sample, Anchored anchored = Anchored::Waits);
    /// Applies the dabs that still wait, whose reports only the hook after dabs gets, and closes the stroke. The delta
    /// is already applied; it is empty if nothing changed. A stroke that is taken back leaves the mesh as it was before
    /// it, and does not apply what waits.
    MeshDelta endStroke(StrokeEnd how = StrokeEnd::Kept);

    /// Applies a delta backwards, or forwards again: swaps its images with the mesh's. Cost: the delta's elements.
    void swap(MeshDelta& delta);

    /// Returns the first hit from outside, or nothing. Cost: O(faces near the ray).
    std::optional<SurfaceHit> hit(const Ray& ray) const;
    /// Returns the surface's nearest point, if it is no farther than `within`, in mm. Cost: O(faces in that ball).
    std::optional<SurfaceHit> nearest(const Vec3& point, double within) const;

    /// Returns what a dab with these settings and this centre would select on the mesh as it is. A ray brush selects
    /// nothing where it would be more than Footprint::maxSlots on a side. May be called between sub-steps. Cost: the
    /// selection.
    Footprint footprint(const StrokeSettings& settings, const Vec3& center);

    /// Returns what has changed since the last call.
    MeshPatch takePatch();
    /// Returns everything, for a viewer that comes late. Does not change what takePatch() returns next.
    MeshPatch wholePatch() const;

    /// Returns the quality of the last dab's selection on the mesh as it is now; nothing if that dab remeshes nothing.
    /// Cost: O(selection).
    std::optional<SelectionQuality> selectionQuality() const;

    SculptorTotals totals() const;

    /// Compares the octree with the mesh, for tests.
    bool indexIsConsistent() const;

private:
    class Engine;
    std::unique_ptr<Mesh> m_mesh;
    std::unique_ptr<Engine> m_engine;
};
} // namespace core
