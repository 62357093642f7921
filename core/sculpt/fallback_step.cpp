#include "core/sculpt/fallback_step.h"

#include "core/sculpt/verified_remesh.h"
#include "core/sculpt/verify/mesh_transaction.h"
#include "core/util/phase_timer.h"

namespace core
{
namespace
{
/// maxTightenRounds: largest number of rounds of tightening the motion limits. Every roundsPerRing rounds, the limits
/// are tightened in one more ring of vertices around the bad faces.
constexpr int maxTightenRounds = 64, roundsPerRing = 4;
/// Largest number of attempts to optimise in one transaction, each without operations near the bad faces of those
/// before. Then the remaining operations are done one by one.
constexpr int maxFreezeRounds = 16;
/// Work units (WorkBudget) per moved vertex when the whole motion is verified.
constexpr double verifiedMoveWork = 16;

/// Returns the longest displacement that the limits allow, as a share of the longest displacement planned. Vertices
/// that fusion or a collapse has removed do not count.
double shareOfPeak(const DabContext& context)
{
    const Region& region = context.region;
    double planned2 = 0, reached2 = 0;
    region.forEach([&](Slot v) {
        const double plan2 = region.plan(v).squaredNorm(), share = context.limits.share(region, v);
        planned2 = std::max(planned2, plan2);
        reached2 = std::max(reached2, share * share * plan2);
    });
    return planned2 > 0 ? std::sqrt(reached2 / planned2) : 0;
}

/// Returns the corners of the faces and their neighbours. With a mirror, each vertex on its negative side is replaced
/// by its image on the positive side.
std::vector<Slot> cornersAndNeighbours(const DabContext& context, std::span<const Slot> faces)
{
    const Mesh& mesh = context.mesh();
    MirrorMap* mirror = context.mirror;
    std::vector<Slot> found;
    const auto add = [&](Slot v) {
        if (const Slot half = mirror && !mirror->isInHalf(v) ? mirror->imageOf(v) : v; half != noSlot)
            found.push_back(half);
    };
    for (Slot f : faces) {
        for (Slot v : mesh.corners(f)) {
            add(v);
            mesh.forEachOutgoing(v, [&](Slot h) { add(mesh.to(h)); });
        }
    }
    return found;
}

std::vector<Slot> withImages(const DabContext& context, std::vector<Slot> vertices)
{
    if (!context.mirror)
        return vertices;
    for (std::size_t i = 0, n = vertices.size(); i < n; ++i) {
        if (const Slot image = context.mirror->imageOf(vertices[i]); image != noSlot && image != vertices[i])
            vertices.push_back(image);
    }
    return vertices;
}
} // namespace

bool FallbackStep::apply(DabContext& context, StepPlan& plan)
{
    if (!plan.isCut()) {
        context.count(m_steps.refineAndPlan(context, plan, verifiedEditor(context)));
        context.allowFusion();
    }
    // limited vertices stay behind, so the mesh between them and the moving ones must be optimised after each sub-step
    plan.takeSingleSteps();
    m_steps.join(context, plan);
    if (moveWithinLimits(context, plan.part()))
        return true;
    const bool hasMoved = tightenAndMove(context, plan.part());
    if (!optimiseAtOnce(context)) {
        const PhaseTimer timer(context.report.optimiseMs, context.surface.verifyMs());
        context.count(m_steps.optimise(context, verifiedEditor(context)));
    }
    return hasMoved;
}

/// Moves and optimises in one transaction, within the limits of an earlier sub-step. These limits usually suffice.
bool FallbackStep::moveWithinLimits(DabContext& context, double part)
{
    if (!context.limits.inUse())
        return false;
    context.limits.extend(context.region, context.mesh());
    const double share = shareOfPeak(context);
    if (share == 0)
        return false;
    MeshTransaction transaction(context.surface, context.region);
    RemeshCounts counts;
    if (!m_steps.displaceAndOptimise(context, part, counts) || !transaction.commit())
        return false;
    context.count(counts);
    context.report.reached += share * part * context.report.asked;
    return true;
}

/// Moves every vertex as far as it can go without contact. Each failed round tightens the limits of at least one
/// vertex, so the loop ends. A round first rechecks only the vertices tightened last, and verifies the whole change
/// only if they are sound.
bool FallbackStep::tightenAndMove(DabContext& context, double part)
{
    const double moved = context.region.size();
    context.limits.extend(context.region, context.mesh());
    std::vector<Slot> tightened;
    for (int round = 0; round < maxTightenRounds; ++round) {
        const double share = shareOfPeak(context);
        if (share == 0 || context.request.work.isSpent())
            return false;
        context.request.work.spend(moved);
        MeshTransaction transaction(context.surface);
        bool isInside = false;
        {
            const PhaseTimer timer(context.report.deformMs);
            isInside = m_steps.displace(context, part);
        }
        if (isInside && (round == 0 || context.surface.recheck(withImages(context, tightened)))) {
            context.request.work.spend(verifiedMoveWork * moved);
            if (transaction.commit()) {
                context.report.reached += share * part * context.report.asked;
                return true;
            }
        }
        transaction.rollBack();
        context.report.wall = !isInside;
        if (!isInside)
            return false;
        tightened = context.limits.tighten(context.region, context.mesh(), context.surface.badFaces(),
                                           1 + round / roundsPerRing);
        if (tightened.empty())
            return false;
    }
    return false;
}

/// Optimises in one transaction: the direct sub-step probably failed because of its motion, not because of a remeshing
/// operation. If that fails, tries again without the operations near bad faces. Returns false if operations are left to
/// be tried one by one.
bool FallbackStep::optimiseAtOnce(DabContext& context)
{
    m_frozen.clear();
    for (int round = 0; round < maxFreezeRounds; ++round) {
        MeshTransaction transaction(context.surface, context.region);
        RemeshCounts counts;
        {
            const PhaseTimer timer(context.report.optimiseMs);
            counts = m_steps.optimise(context, MeshEditor(context.surface.mesh(), {}, context.mirror, &m_frozen));
        }
        if (transaction.commit()) {
            context.count(counts);
            return round == 0;
        }
        const std::vector<Slot> around = cornersAndNeighbours(context, context.surface.badFaces());
        transaction.rollBack();
        for (Slot v : around) {
            if (v < context.mesh().slots().vertices && context.mesh().isVertex(v))
                m_frozen.add(v);
        }
    }
    return false;
}
} // namespace core
