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
/// Limits the work of a dab, its mirror and radial images included. A guard against endless work, not a tuning knob: a
/// dab that needs more ends early.
class WorkBudget
{
public:
    void spend(double work) { m_spent += work; }
    bool isSpent() const { return m_spent >= max; }
    double left() const { return max - m_spent; }

private:
    /// Largest number of work units of a dab. A moved vertex counts as 1 unit, as does a face visited in verifying a
    /// single operation: a few microseconds each.
    static constexpr double max = 1 << 21;
    double m_spent = 0;
};

/// The request to apply a dab. Its mirror and radial images share it.
struct DabRequest
{
    const StrokeSettings& settings;
    StrokeDisplacements& displacements;
    RestLengths& rest;
    const std::function<void()>& afterSubstep; ///< called after each committed sub-step; may be empty
    SculptorTotals& totals;
    WorkBudget work = {};
    /// result: the tip of Snake Hook has joined another surface, so the stroke ignores further dabs
    bool isOver = false;
    /// result: edge bounds of the image sculpted last; empty if the dab only painted or added a solid
    std::optional<EdgeBounds> bounds = {};
};

/// A dab at one place, or on both sides of a mirror at once: the data that its steps pass on from one to the next.
struct DabContext
{
    DabContext(VerifiedMesh& surfaceToEdit, DabRequest& dabRequest, const Dab& dabToDo, Grab& dabGrab);

    const Mesh& mesh() const { return surface.mesh(); }
    /// Returns an editor whose operations are not verified one by one.
    MeshEditor editor() { return MeshEditor(surface.mesh(), {}, mirror); }
    /// Returns the stroke's rest lengths if it keeps detail, else null.
    RestLengths* rest() const { return keepsDetail(settings.topology) ? &request.rest : nullptr; }
    /// Returns the number of vertices in the region, their mirror images included.
    Slot touchedVertices() const;
    /// Allows the region to join surfaces that it meets. From then on the edge bounds are the brush's, not those of a
    /// finer grabbed surface.
    void allowFusion();
    /// Adds the counts of a committed remeshing to the totals.
    void count(const RemeshCounts& counts);

    VerifiedMesh& surface;
    DabRequest& request;
    const StrokeSettings& settings;
    Dab dab;
    Grab& grab;
    Region& region; ///< the grab's region; with a mirror, only its part on the positive side
    /// null: no mirror; otherwise a map that is on, and the dab is done on both sides at once
    MirrorMap* mirror = nullptr;
    std::vector<Slot> candidates{}; ///< candidate triangles of the selection (paper, section 3.1.1)
    Sphere ball;                    ///< contains everything that the dab moves
    EdgeBounds bounds;
    bool canFuse = false; ///< surfaces under the brush face each other and may meet, or something stopped the motion
    MotionLimits limits{};
    unsigned fallbackSteps = 0;        ///< fallback steps done within these limits
    std::vector<Slot> badVertices{};   ///< corners of the bad faces of the last direct sub-step that failed
    std::vector<VertexPair> blocked{}; ///< edges that the last optimisation could not collapse
    bool isCapped = false;             ///< the limit on operations or steps was reached: the dab ends early
    DabReport report{};
};
} // namespace core
