#pragma once

#include "core/sculpt/deform/stroke_displacements.h"
#include "core/sculpt/edit/mesh_editor.h"
#include "core/sculpt/grab.h"
#include "core/sculpt/remesh/remesh.h"
#include "core/sculpt/sculptor_totals.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <functional>

namespace core
{
/// The work that a dab may do, its images included: a guard, not a tuning knob. A dab that would need more ends early.
class WorkBudget
{
public:
    void spend(double work) { m_spent += work; }
    bool isSpent() const { return m_spent >= max; }
    double left() const { return max - m_spent; }

private:
    /// A vertex that moves counts as 1, and so does a face that an operation verified by itself visits: some
    /// microseconds each.
    static constexpr double max = 1 << 21;
    double m_spent = 0;
};

/// A dab as the stroke hands it down: shared by all images of the dab.
struct DabRequest
{
    const StrokeSettings& settings;
    StrokeDisplacements& displacements;
    RestLengths& rest;
    const std::function<void()>& afterSubstep; ///< may be empty
    SculptorTotals& totals;
    WorkBudget work = {};
    bool hasLetGo = false;                 ///< result: the tip of Snake Hook has become part of another surface
    std::optional<EdgeBounds> bounds = {}; ///< result: to which its last image has remeshed; nothing if it has not
};

/// A dab at one place, or on both sides of a mirror at once: what its steps pass on from one to the next.
struct DabContext
{
    DabContext(VerifiedMesh& surfaceToEdit, DabRequest& dabRequest, const Dab& dabToDo, Grab& dabGrab);

    const Mesh& mesh() const { return surface.mesh(); }
    /// Returns an editor whose operations are not verified one by one.
    MeshEditor editor() { return MeshEditor(surface.mesh(), {}, mirror); }
    /// Returns the stroke's rest lengths if it keeps detail, else null.
    RestLengths* rest() const { return keepsDetail(settings.topology) ? &request.rest : nullptr; }
    /// Returns the vertices of the region, and their images.
    Slot touchedVertices() const;
    /// Lets the region meet other surfaces, and be joined to them: it is no longer kept as fine as it was grabbed.
    void allowFusion();
    /// Notes what a remeshing that was committed has done.
    void count(const RemeshCounts& counts);

    VerifiedMesh& surface;
    DabRequest& request;
    const StrokeSettings& settings;
    Dab dab;
    Grab& grab;
    Region& region;                 ///< the grab's; with a mirror the half of it
    MirrorMap* mirror = nullptr;    ///< null, or one that is on: the dab is done on both sides at once
    std::vector<Slot> candidates{}; ///< candidate triangles (paper, section 3.1.1)
    Sphere ball;                    ///< around everything that the dab moves
    EdgeBounds bounds;
    bool canFuse = false; ///< surfaces face each other under the brush and will meet, or something stopped the motion
    MotionLimits limits{};
    unsigned fallbackSteps = 0;        ///< done within these limits
    std::vector<Slot> badVertices{};   ///< corners of the faces at which the last direct step failed
    std::vector<VertexPair> blocked{}; ///< edges that the last optimisation could not collapse
    bool isCapped = false;             ///< a cap on operations or steps was reached: the dab ends there
    DabReport report{};
};
} // namespace core
