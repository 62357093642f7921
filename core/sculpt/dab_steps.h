#pragma once

#include "core/sculpt/deform/stamp_shape.h"
#include "core/sculpt/fuse/fusion.h"
#include "core/sculpt/step_plan.h"

namespace core
{
/// The steps of a dab (paper, sections 3.2 to 3.4). Each changes the mesh and none is a transaction, except that fusion
/// verifies each join and each cut by itself. Owns their scratch memory.
class DabSteps
{
public:
    /// Forgets where earlier strokes joined surfaces.
    void beginStroke() { m_fusion.beginStroke(); }
    /// Forgets what earlier dabs could not join, and finds out whether surfaces face each other under this one.
    void begin(DabContext& context);

    /// Makes the mesh under the brush fine enough to plan on, plans how far each vertex is to move, and cuts the plan.
    RemeshCounts refineAndPlan(DabContext& context, StepPlan& plan, MeshEditor edit);
    /// Moves each vertex of the region by a part of its plan. False if one would leave the working volume.
    bool displace(DabContext& context, double part);
    /// Makes the mesh under the brush quasi-uniform. Keeps edges that the tool has made sharp; of a drag it evens the
    /// lines of those that were not sharp before.
    RemeshCounts optimise(DabContext& context, MeshEditor edit);
    /// Displaces, and optimises unless a vertex would leave the working volume: false.
    bool displaceAndOptimise(DabContext& context, double part, RemeshCounts& counts);

    /// Presses the stamp in, or raises it, as a solid, by a boolean operation: for a surface with folds, which its
    /// field would push into each other. False if that cannot be done; then nothing has changed.
    bool stampSolid(DabContext& context);

    /// Joins what the next transaction of the plan would bring into contact. Returns whether anything was joined.
    bool join(DabContext& context, const StepPlan& plan);
    /// Cuts necks that have grown too thin to be collapsed, and removes specks.
    void separate(DabContext& context);
    /// Smooths what the dab has joined, makes it quasi-uniform, and cuts the necks and tunnels narrower than d that
    /// this dab and earlier ones of the stroke have left by joining.
    void cleanJoints(DabContext& context);
    /// Whether surfaces that may not be joined are about to meet at the context's bad vertices.
    bool isContact(const DabContext& context, const StepPlan& plan);

private:
    StampShape stampShape(DabContext& context);
    RemeshCounts cutOutline(DabContext& context, MeshEditor& edit);
    double plan(DabContext& context);
    void optimiseJoints(DabContext& context);
    void smoothJoints(DabContext& context);
    std::uint64_t separateJoints(DabContext& context);
    static bool canFacesFuse(const DabContext& context);

    TopologyFusion m_fusion;
    Region m_whole;    ///< with a mirror: what the dab alone selects, on both sides
    SlotSet m_outline; ///< of Stamp: vertices on the outline that was cut
};
} // namespace core
