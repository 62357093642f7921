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
/// Sculpts one mesh. If the mesh bounds a solid, it still does after every dab: closed, manifold, consistently oriented
/// and free of self-intersections. A dab that would break this ends early. Thread: the mesh thread; not thread-safe.
class Sculptor
{
public:
    /// Takes a mesh that passed `buildMesh`. Cost: O(faces), for the octree.
    explicit Sculptor(std::unique_ptr<Mesh> mesh);
    ~Sculptor();

    const Mesh& mesh() const { return *m_mesh; }

    /// Switches verification on or off; it is on initially. Without it the mesh may become unsound. To be used only to
    /// measure the cost of verification.
    void setVerification(bool on);
    /// Sets a function that is called between sub-steps, when the mesh is valid and may be read. Thread: that of
    /// addSample().
    void setBetweenSubsteps(std::function<void()> hook);
    /// Sets a function that is called with the report of each dab. Its time does not count in the report. Thread: that
    /// of addSample().
    void setAfterDab(std::function<void(const DabReport&)> hook);

    /// Selects the part that hit(), nearest() and footprint() refer to; initially part 0. beginStroke() selects the
    /// part of its settings.
    void activate(PartId part);
    PartId activePart() const;

    enum class Anchored { Waits, Shown };

    /// A stroke of a part that cannot be changed (PartList::isEditable()) does nothing.
    void beginStroke(const StrokeSettings& settings);
    bool strokeOpen() const { return m_mesh->strokeOpen(); }
    /// Applies the dabs of the path up to this sample. Returns their reports. Dabs that need a further sample to be
    /// placed (StrokePath::next) are applied with that sample, or by endStroke(). An unusable sample (isUsable())
    /// counts as one empty dab and does not become part of the path. A long motion of a drag tool is several dabs.
    ///
    /// The single dab of an anchored stroke is applied when the stroke ends. Anchored::Shown applies it now as a
    /// preview that replaces the previous preview. The result of the stroke is the same with and without previews.
    std::vector<DabReport> addSample(const StrokeSample& sample, Anchored anchored = Anchored::Waits);
    /// Applies the remaining dabs, whose reports go to the hook of setAfterDab() only, and closes the stroke. Returns
    /// the stroke's delta, which is already applied and is empty if nothing changed. StrokeEnd::TakenBack instead
    /// restores the mesh from before the stroke and applies no remaining dabs.
    MeshDelta endStroke(StrokeEnd how = StrokeEnd::Kept);

    /// Undoes a delta, or redoes it: exchanges the element states in the delta with those of the mesh. Cost: the
    /// delta's elements.
    void swap(MeshDelta& delta);

    /// Returns the first intersection of the ray with a face that it enters from outside; nothing if there is none.
    /// Cost: O(faces near the ray).
    std::optional<SurfaceHit> hit(const Ray& ray) const;
    /// A place on the surface of a part.
    struct PartHit
    {
        PartId part;
        SurfaceHit hit;
    };
    /// Returns where the ray first meets a visible part; nothing if it meets none. Cost: a hit() for each part.
    std::optional<PartHit> visibleHit(const Ray& ray);
    /// Returns the surface point nearest to `point`, if it is no farther than `within` (mm). Cost: O(faces in that
    /// ball).
    std::optional<SurfaceHit> nearest(const Vec3& point, double within) const;

    /// Returns the vertices that a dab with these settings and this centre would select on the current mesh, with their
    /// weights. A ray brush selects nothing in a sector, or in its mirror image, where it would select more than
    /// Footprint::maxSlots vertices. May be called between sub-steps. Cost: the selection.
    Footprint footprint(const StrokeSettings& settings, const Vec3& center);

    /// Returns the changes since the previous call of takePatch().
    MeshPatch takePatch();
    /// Returns the whole mesh as a patch, for a viewer that starts late. Does not affect what takePatch() returns next.
    MeshPatch wholePatch() const;

    /// Returns the quality of the last dab's selection on the current mesh; nothing if that dab only painted, added a
    /// solid, or selected no face. Cost: O(selection log selection).
    std::optional<SelectionQuality> selectionQuality() const;

    SculptorTotals totals() const;

    /// Returns whether the octree agrees with the mesh. For tests.
    bool indexIsConsistent() const;

private:
    class Engine;
    std::unique_ptr<Mesh> m_mesh;
    std::unique_ptr<Engine> m_engine;
};
} // namespace core
