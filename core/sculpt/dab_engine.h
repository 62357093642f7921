#pragma once

#include "core/sculpt/deform/dab_weights.h"
#include "core/sculpt/deform/motion_limits.h"
#include "core/sculpt/edit/mesh_editor.h"
#include "core/sculpt/fuse/fold_smoothing.h"
#include "core/sculpt/fuse/fusion.h"
#include "core/sculpt/patch_copy.h"
#include "core/sculpt/remesh/remesh.h"
#include "core/sculpt/sculptor.h"
#include "core/sculpt/select/region.h"
#include "core/sculpt/verify/verified_mesh.h"

#include <bit>

namespace core
{
/// One dab, as the paper's section 3 has it: select -> optimise mesh -> deform -> verify -> index, in sub-steps that
/// either hold or never were. Owns the scratch memory of all steps.
class DabEngine
{
public:
    explicit DabEngine(Mesh& mesh);

    /// Drops the grab and the layer heights of the stroke before.
    void beginStroke();

    /// Precondition: a stroke is open. `between` may be empty.
    DabReport apply(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between);

    /// See Sculptor::footprint.
    Footprint footprint(const StrokeSettings& settings, const Vec3& center);

    /// See Sculptor::setVerification.
    void setVerification(bool on) { m_surface.setVerification(on); }

    /// Brings octree and patches up to date after Mesh::swap. What the last dab selected may be no more.
    void follow(const MeshDelta& swapped)
    {
        m_surface.follow(swapped);
        m_bounds.reset();
    }

    const Mesh& mesh() const { return m_mesh; }
    const FaceOctree& octree() const { return m_surface.octree(); }
    /// See Sculptor::selectionQuality.
    std::optional<SelectionQuality> selectionQuality() const
    {
        return m_bounds ? core::selectionQuality(m_mesh, m_region, *m_bounds) : std::nullopt;
    }
    DirtySlots& dirtySlots() { return m_surface.dirtySlots(); }
    SculptorTotals totals() const;

private:
    enum class Substep { Direct, Fallback, Retry, Failed, Empty };

    /// A step that fails is halved so often that it does one of these; after one that passes the next is twice as long.
    static constexpr unsigned ticksPerStep = 8;
    /// Then the fallback step limits the motion.
    static constexpr unsigned maxRetriesPerSubstep = 6, maxRetriesPerDab = 12;
    /// A guard, not a tuning knob: of a dab, some seconds. What is counted costs some microsecond each: vertices moved,
    /// and faces looked at by operations that are verified one by one. A dab that would need more ends early.
    static constexpr double maxWork = 1 << 21;
    /// Motion limits are lifted for one try after as many at the latest.
    static constexpr unsigned maxLimitedSubsteps = 8;
    /// Work that a vertex's move counts for where it is verified in the fallback step.
    static constexpr unsigned fallbackMoveWork = 16;

    /// State of a tool that keeps its selection: once it is on, m_region is kept instead of selected.
    struct GrabState
    {
        bool isOn = false;
        bool isMirrored = false;  ///< m_region is the half that stands for both
        Vec3 axis = Vec3::Zero(); ///< the mean normal when it was taken
        double detail = 0;        ///< the d_detail that keeps it as fine as it was then
        std::size_t known = 0;    ///< so many of Mesh::removedVertices() are no longer in its region
        Vec3 way = Vec3::Zero();  ///< of the last dab: where it is the next one's, too, what was in the way still is
        MotionLimits limits{};    ///< by that
        unsigned fallbackSubsteps = 0; ///< with that
    };

    /// The grab of another sector than the first, in a radial stroke.
    struct SectorGrab
    {
        GrabState grab, mirroredGrab;
        Region region, imageRegion;
        bool isSeparate = false; ///< for the rest of the stroke it is no image of the first
    };
    struct GrabbedPoint
    {
        Vec3f point;
        double distance;
    };
    struct Orbit;

    struct Task
    {
        const StrokeSettings& settings;
        const Dab& dab;
        Sphere ball; ///< about all that it moves
        EdgeBounds bounds;
        double steps = 0; ///< into which the plan is cut, each no longer than d_move; 0: not planned yet
        unsigned maxTicks = ticksPerStep; ///< ticks in a transaction: of several sub-steps at once where nothing meets
        unsigned ticks = ticksPerStep;    ///< that the next transaction does
        unsigned left = 0;                ///< that the plan still holds
        unsigned retries = 0;             ///< how often the next sub-step has been made easier
        unsigned totalRetries = 0;        ///< and all of them so far
        unsigned fallbackSubsteps = 0;    ///< so far
        /// Surfaces face each other under the brush and will meet, or something stopped the motion.
        bool canFuse = false;

        /// Of the plan, that the next sub-step does.
        double part() const { return ticks / (ticksPerStep * steps); }
        FusionInput fusionInput() const { return {pushes(settings), bounds, part()}; }
        /// Motion limits persist across sub-steps. They are lifted for one try after 1, 2, 4, 8, then every 8
        /// sub-steps, in case the obstacle is gone.
        bool shouldRelax() const
        {
            return std::has_single_bit(fallbackSubsteps) || fallbackSubsteps % maxLimitedSubsteps == 0;
        }
        /// To which the finished transaction amounts.
        unsigned substeps() const { return std::max(ticks / ticksPerStep, 1u); }
    };

    void warmUp();
    void run(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between, DabReport& report);
    void runMirrored(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                     DabReport& report);
    void runOnce(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                 DabReport& report);
    void runRadial(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                   DabReport& report);
    bool addsIn(const StrokeSettings& settings, const Dab& dab);
    DabReport runOrbit(Orbit& orbit);
    DabReport runInSector(const Orbit& orbit, std::size_t sector);
    static std::vector<Sphere> ballsOf(const Orbit& orbit);
    static std::vector<std::size_t> othersIn(const Orbit& orbit);
    bool canCopyPatch(const Orbit& orbit, const std::vector<std::size_t>& others);
    bool copyPatch(const Orbit& orbit, std::size_t other, const DabReport& once, DabReport& report);
    static Turn turnIn(const Orbit& orbit, std::size_t sector);
    void grabHalf(const Orbit& orbit, SectorGrab& own, const Turn& turn);
    void grabSeparately(const Orbit& orbit, std::size_t from);
    void noteGrabbed(Orbit& orbit);
    void selectImages(Region& region, const std::vector<GrabbedPoint>& grabbed, const Turn& turn) const;
    void swapSector(Tool tool, std::size_t sector);
    void dropRemoved(GrabState& grab, Region& region) const;
    void sculpt(const StrokeSettings& settings, Dab dab, const std::function<void()>& between, DabReport& report);
    void deform(Task& task, const std::function<void()>& between, DabReport& report);
    DabReport rest(const StrokeSettings& settings, const Dab& dab);
    void take(const StrokeSettings& settings, const Sphere& ball);
    bool takeMirrored(const StrokeSettings& settings, const Sphere& ball);
    bool selectGrabbed();
    void growSelection(const StrokeSettings& settings, double radius);
    void recallLimits(Task& task);
    void noteLimits(const Task& task, const DabReport& report);
    double meanEdge(const Region& region) const;
    void swapGrabs(Tool tool);
    Sphere ballAround(const Dab& dab) const;
    void selectBothSides(const Task& task);
    void recallRaised();
    void noteRaised(double share);
    void noteRaised(Slot v, double raised);
    double raised(Slot v) const;
    double raisedAround(Slot v) const;
    std::vector<Slot> facesIn(const LatticeBox& box) const;
    bool isMirroredIn(BrushShape brush, const Sphere& ball);
    MeshEditor plainEditor() { return MeshEditor(m_mesh, {}, mirror()); }
    MeshEditor verifiedEditor();
    bool isSpent() const { return m_work >= maxWork; }
    MirrorMap* mirror() { return m_mirror.isOn() ? &m_mirror : nullptr; }
    Slot touchedVertices() const;
    void select(Region& region, std::vector<Slot>& candidates, BrushShape brush, const Sphere& ball,
                Slot max = noSlot) const;
    bool wantsSolid(const StrokeSettings& settings, const Dab& dab) const;
    void mark(const StrokeSettings& settings, const Dab& dab, DabReport& report);
    void colour(Slot v, Rgb color, double share);
    void mask(Slot v, double change);
    /// Of the brush's own d, that the tool asks for; 1 where the brush has none.
    static double detailShare(const StrokeSettings& settings);
    EdgeBounds boundsFor(const StrokeSettings& settings, double radius) const;
    EdgeBounds grabBounds(const StrokeSettings& settings, const EdgeBounds& bounds) const;
    void allowFusion(Task& task) const;
    Substep substep(Task& task, DabReport& report);
    Substep direct(Task& task, DabReport& report);
    Substep fallback(Task& task, DabReport& report);
    RemeshCounts refineAndPlan(Task& task, MeshEditor edit, DabReport& report);
    double plan(const Task& task);
    double transactionsFor(const Task& task) const;
    double longestBetweenNeighbours() const;
    void selectRefined(Region& region, const Sphere& ball);
    bool moveAndOptimise(const Task& task, RemeshCounts& counts, DabReport& report);
    RemeshCounts remesh(const Task& task, MeshEditor edit);
    bool moveWithinLimits(const Task& task, DabReport& report);
    bool optimiseAtOnce(Task& task, DabReport& report);
    std::vector<Slot> namedAround(std::span<const Slot> faces);
    bool tightenAndMove(double part, DabReport& report);
    std::vector<Slot> withImages(std::vector<Slot> vertices);
    bool displace(double part);
    double shareOfPeak() const;
    bool canFacesFuse(const StrokeSettings& settings, const Sphere& ball);
    bool join(Task& task, DabReport& report);
    bool easeMotion(Task& task, DabReport& report);
    static bool shortenStep(Task& task);
    bool refineAtOnce(Task& task, DabReport& report);
    void separate(Task& task, DabReport& report);
    void count(const RemeshCounts& counts);

    Mesh& m_mesh;
    VerifiedMesh m_surface;
    Region m_region;    ///< with a mirror: of the half
    MirrorMap m_mirror; ///< on while a dab is done on both sides at once
    Region m_whole;     ///< with a mirror: what the dab alone selects, on both sides
    GrabState m_grab;
    /// Of a symmetric stroke where the model is not symmetric, its second dab's: with the next.
    GrabState m_mirroredGrab;
    Region m_imageRegion;
    std::vector<SectorGrab> m_sectors; ///< of a radial stroke, by sector; the first one's is m_grab
    PatchCopy m_patchCopy;
    SparseIndex m_raisedVertices; ///< by Layer, in this stroke
    std::vector<double> m_raised; ///< how far, by position among them; negative: of one that is gone
    Region m_footprint;           ///< only that: it is asked for in the middle of a dab
    std::vector<Slot> m_candidates;
    MotionLimits m_limits;
    SlotSet m_frozen; ///< by an optimisation: operations there were not sound
    FoldSmoothing m_foldSmoothing;
    TopologyFusion m_fusion;
    std::vector<Slot> m_badVertices;   ///< of the faces that the last direct sub-step failed at
    std::vector<VertexPair> m_blocked; ///< what the last optimisation could not collapse
    SculptorTotals m_totals;
    std::optional<EdgeBounds> m_bounds; ///< of the last dab, if it remeshes
    bool m_capped = false;              ///< a sub-step reached the cap on remeshing operations: the dab ends there
    double m_work = 0;                  ///< of the dab so far, see maxWork
};
} // namespace core
