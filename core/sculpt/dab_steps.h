#pragma once

#include "core/sculpt/deform/stamp_shape.h"
#include "core/sculpt/fuse/fusion.h"
#include "core/sculpt/step_plan.h"

namespace core
{
/// The steps of a dab (paper, sections 3.2 to 3.4). Each step changes the mesh without verifying it; the caller wraps
/// steps in transactions. Exception: fusion verifies each join and each cut itself. Owns the steps' scratch memory.
class DabSteps
{
public:
    /// Clears the record of where earlier strokes joined surfaces.
    void beginStroke() { m_fusion.beginStroke(); }
    /// Clears the record of joins that failed in earlier dabs, and determines whether surfaces face each other under
    /// this dab.
    void begin(DabContext& context);

    /// Makes the mesh under the brush fine enough to plan on, plans how far each vertex is to move, and cuts the plan.
    RemeshCounts refineAndPlan(DabContext& context, StepPlan& plan, MeshEditor edit);
    /// Moves each vertex of the region by a part of its plan. Returns false if a vertex would leave the working volume.
    bool displace(DabContext& context, double part);
    /// Makes the mesh under the brush quasi-uniform. Keeps edges that the tool has made sharp. For a drag tool, also
    /// evens out the spacing along lines that became sharp in this stroke.
    RemeshCounts optimise(DabContext& context, MeshEditor edit);
    /// Displaces, then optimises. Returns false, without optimising, if a vertex would leave the working volume.
    bool displaceAndOptimise(DabContext& context, double part, RemeshCounts& counts);

    /// Presses the stamp in, or raises it, as a solid by a boolean operation. For a folded surface, whose folds the
    /// displacement field of the stamp would push into each other. Returns false, with nothing changed, if that fails.
    bool stampSolid(DabContext& context);

    /// Joins surfaces that the next transaction of the plan would bring into contact. Returns whether anything was
    /// joined.
    bool join(DabContext& context, const StepPlan& plan);
    /// Cuts necks that have grown too thin to be collapsed, and removes specks.
    void separate(DabContext& context);
    /// Smooths what the dab has joined and makes it quasi-uniform. Also cuts necks and tunnels narrower than d that
    /// this dab, or earlier dabs of the stroke, have made by joining.
    void cleanJoints(DabContext& context);
    /// Returns whether surfaces that must not be joined are about to meet at the context's bad vertices.
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
    Region m_whole;    ///< with a mirror: the vertices that the dab alone selects, on both sides
    SlotSet m_outline; ///< Stamp: vertices on the outline that was cut
};
} // namespace core
