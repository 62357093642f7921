// A dab in sub-steps (paper, section 3; DESIGN, section 3):
//   select   the vertices under the brush                                                      region
//   plan     how far each is to move, in all                                                   deform
//   then, for each sub-step no longer than d_move:
//     optimise   the mesh under the brush becomes quasi-uniform                                remesh
//     deform     each vertex moves its part of the plan, snapped to the lattice; edges that grew too long are split
//     verify     exactly, where it changed                                                     verify
//     index      octree and draw ranges learn what changed                                     face_octree, dirty_slots
// A sub-step that does not verify is rolled back and taken with care: first the motion alone, vertices that would touch
// something held back; then each remeshing operation by itself, judged by itself. What cannot be done is left undone.

#include "dab_engine.h"

#include "deform.h"
#include "shell_probe.h"

#include <chrono>

namespace core
{
namespace
{
/// d_move in terms of d: the paper asks for less than d/2 (section 3.3).
constexpr double movePerMinimum = 0.45;
/// Sub-steps of one dab; a dab that would need more ends early.
constexpr double mostSubsteps = 4096;
/// A vertex that would touch something does this part of its motion instead, then nothing.
constexpr double heldShareOnce = 0.25;
constexpr int mostHoldRounds = 64;
/// The uniform d_detail (Botsch and Kobbelt 2004).
constexpr double detailPerMeanEdge = 4.0 / 3;
/// Of an added sphere: edges of 0.13 to 0.16 radii, between d and d_detail of its brush.
constexpr int sphereSubdivisions = 3;
/// d_thickness in terms of d_detail: an added sphere keeps at least this distance from every triangle.
constexpr double clearPerDetail = 0.735;

using Clock = std::chrono::steady_clock;

/// Adds the time of its scope to a phase.
class PhaseTimer
{
public:
    explicit PhaseTimer(double& milliseconds) : m_milliseconds(milliseconds) {}
    ~PhaseTimer() { m_milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - m_start).count(); }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    double& m_milliseconds;
    Clock::time_point m_start = Clock::now();
};

double meanEdge(const Mesh& mesh)
{
    double sum = 0;
    for (Slot e = 0; e < mesh.slots().edges; ++e) {
        if (mesh.isEdge(e))
            sum += (mesh.point(mesh.to(2 * e)) - mesh.point(mesh.to(2 * e + 1))).cast<double>().norm();
    }
    return sum / mesh.live().edges;
}

bool runPlainly(const std::function<void()>& operation)
{
    operation();
    return true;
}
} // namespace

DabEngine::DabEngine(Mesh& mesh) : m_mesh(mesh), m_octree(mesh), m_uniformDetail(detailPerMeanEdge * meanEdge(mesh)) {}

DabReport DabEngine::apply(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between)
{
    DabReport report;
    {
        const PhaseTimer timer(report.totalMs);
        run(settings, dab, between, report);
    }
    return report;
}

void DabEngine::run(const StrokeSettings& settings, const Dab& dab, const std::function<void()>& between,
                    DabReport& report)
{
    m_touchedFaces = 0;
    m_held.clear();
    m_capped = false;
    if (!(dab.strength > 0))
        return;
    {
        const PhaseTimer timer(report.selectMs);
        select(settings.brush, {dab.position, dab.radius});
    }
    if (wantsSphere(settings, dab))
        return addSphere(dab, report);
    if (settings.tool == Tool::Paint)
        return paint(settings, dab, report);
    Task task = {settings, dab, boundsFor(settings, dab)};
    report.outcome = DabOutcome::Committed;
    for (double step = 0; step == 0 || step < task.steps; ++step) {
        const Substep result = step < mostSubsteps ? substep(task, report) : Substep::Stuck;
        if (result == Substep::Empty) {
            report.outcome = DabOutcome::Empty;
            return;
        }
        if (result == Substep::Stuck || m_capped) {
            report.outcome = DabOutcome::EndedEarly;
            break;
        }
        ++report.substeps;
        if (result == Substep::Careful)
            report.outcome = DabOutcome::Careful;
        if (between)
            between();
    }
    report.touchedVertices = m_region.size();
    report.touchedFaces = m_touchedFaces;
}

/// The candidate triangles and the region (paper, section 3.1).
void DabEngine::select(BrushShape brush, const Sphere& ball)
{
    if (brush == BrushShape::Sphere) {
        selectSphere(m_region, m_candidates, m_mesh, m_octree, ball);
        return;
    }
    m_candidates.clear();
    m_region.clear();
    if (const std::optional<SurfaceHit> hit = nearestPoint(m_mesh, m_octree, ball.center)) {
        m_candidates.push_back(hit->face);
        selectAlongSurface(ball);
    }
}

/// Ray brush: from the candidate that holds the ball's centre. The faces it reaches become the candidates.
void DabEngine::selectAlongSurface(const Sphere& ball)
{
    Slot face = noSlot;
    double nearest2 = 0;
    for (Slot f : m_candidates) {
        const Triangle& t = m_mesh.corners(f);
        const auto point = [&](Slot v) -> Vec3 { return m_mesh.point(v).cast<double>(); };
        const double d2 = (nearestInTriangle(ball.center, {point(t[0]), point(t[1]), point(t[2])}) - ball.center).squaredNorm();
        if (face == noSlot || d2 < nearest2 || (d2 == nearest2 && f < face)) {
            face = f;
            nearest2 = d2;
        }
    }
    selectGeodesic(m_region, m_mesh, face, ball);
    SparseIndex& faces = m_region.scratch();
    faces.clear();
    faces.add(face);
    m_region.forEach([&](Slot v) { m_mesh.forEachOutgoing(v, [&](Slot h) { faces.add(m_mesh.face(h)); }); });
    m_candidates = faces.slots();
}

bool DabEngine::wantsSphere(const StrokeSettings& settings, const Dab& dab) const
{
    if (!settings.add || settings.tool != Tool::Pull || settings.brush != BrushShape::Sphere ||
        settings.place != Placement::Point || !m_region.empty())
        return false;
    const std::optional<SurfaceHit> nearest = nearestPoint(m_mesh, m_octree, dab.position);
    return !nearest || nearest->distance > dab.radius; // else a face is under the brush, if no vertex is
}

/// Free topology (paper, section 3.5.1): a sphere of the brush's radius, if it lies outside the model and clear of it.
void DabEngine::addSphere(const Dab& dab, DabReport& report)
{
    const double detail = edgeBounds(dab.radius, 1).detail;
    report.outcome = DabOutcome::Refused;
    report.refusal = refusalOf({dab.position, dab.radius}, clearPerDetail * detail);
    if (report.refusal != Refusal::None)
        return;
    TriangleMesh sphere = icosphere(sphereSubdivisions, dab.radius);
    for (Vec3f& p : sphere.points)
        p = m_mesh.lattice().snap(dab.position + p.cast<double>());
    const Slot hint = m_mesh.corners(nearestPoint(m_mesh, m_octree, dab.position)->face)[0];
    const Mesh::Mark mark = m_mesh.mark();
    m_mesh.addShell(sphere, hint);
    if (!verifyAndIndex(mark, report)) {
        m_mesh.rollback(mark);
        report.refusal = Refusal::TooClose;
        return;
    }
    report.outcome = DabOutcome::Added;
    report.touchedVertices = static_cast<std::uint32_t>(sphere.points.size());
    report.touchedFaces = static_cast<std::uint32_t>(sphere.triangles.size());
}

/// By ray parity, as the paper has it, and by distance: a large triangle may be near though no vertex is.
Refusal DabEngine::refusalOf(const Sphere& ball, double clearance) const
{
    const Lattice& lattice = m_mesh.lattice();
    if (!lattice.contains(ball.center.cwiseAbs() + Vec3::Constant(ball.radius)))
        return Refusal::Wall;
    ShellProbe probe(lattice.toLattice(lattice.snap(ball.center)));
    m_octree.query(probe.column(), [&](Slot f) {
        const Triangle& t = m_mesh.corners(f);
        probe.castAt({m_mesh.latticePoint(t[0]), m_mesh.latticePoint(t[1]), m_mesh.latticePoint(t[2])});
    });
    if (probe.isInside())
        return Refusal::Inside;
    const std::optional<SurfaceHit> nearest = nearestPoint(m_mesh, m_octree, ball.center);
    return nearest && nearest->distance < ball.radius + clearance ? Refusal::TooClose : Refusal::None;
}

/// Colours the region (paper, section 3.5.3); moves nothing and remeshes nothing.
void DabEngine::paint(const StrokeSettings& settings, const Dab& dab, DabReport& report)
{
    const Mesh::Mark mark = m_mesh.mark();
    m_region.forEach([&](Slot v) {
        const double x = std::min(m_region.distance(v) / dab.radius, 1.0);
        const double share = std::min(dab.strength, 1.0) * falloff(x, settings.falloff);
        const Rgb before = m_mesh.color(v);
        const auto mix = [&](int from, int to) { return static_cast<std::uint8_t>(from + share * (to - from) + 0.5); };
        const Rgb after = {mix(before.r, settings.color.r), mix(before.g, settings.color.g), mix(before.b, settings.color.b)};
        if (after != before)
            m_mesh.setColor(v, after);
    });
    const TouchedSlots touched = m_mesh.touchedSince(mark);
    m_mesh.commit(mark);
    reindex(touched, {});
    report.touchedVertices = m_region.size();
    report.outcome = m_region.empty() ? DabOutcome::Empty : DabOutcome::Committed;
}

EdgeBounds DabEngine::boundsFor(const StrokeSettings& settings, const Dab& dab) const
{
    const double uniform = settings.detailLength > 0 ? settings.detailLength : m_uniformDetail;
    const EdgeBounds bounds =
        settings.topology == Topology::Uniform ? edgeBounds(uniform) : edgeBounds(dab.radius, settings.detail);
    return edgeBounds(std::max(bounds.detail, m_mesh.lattice().minDetail()));
}

DabEngine::Substep DabEngine::substep(Task& task, DabReport& report)
{
    if (m_held.empty()) { // what was held back once in a dab stays so in its next sub-steps
        const Region::Saved saved = m_region.save();
        const double steps = task.steps;
        const Substep result = straight(task, report);
        if (result != Substep::Stuck)
            return result;
        m_region.restore(saved);
        task.steps = steps;
        ++m_totals.rolledBack;
    }
    return careful(task, report);
}

/// The first sub-step begins with this: the mesh under the brush is made fine enough to plan on.
RemeshCounts DabEngine::refineAndPlan(Task& task, const Attempt& attempt, DabReport& report)
{
    const Sphere ball = {task.dab.position, task.dab.radius};
    RemeshCounts counts;
    const double verifyBefore = report.verifyMs;
    {
        const PhaseTimer timer(report.optimiseMs);
        counts = refine(m_mesh, m_region, m_candidates, ball, task.bounds, attempt);
    }
    report.optimiseMs -= report.verifyMs - verifyBefore; // operations that are judged are verified inside
    if (task.settings.brush == BrushShape::Ray && counts.splits > 0) {
        const PhaseTimer timer(report.selectMs);
        for (Slot v : m_region.remeshed().slots())
            m_mesh.forEachOutgoing(v, [&](Slot h) { m_candidates.push_back(m_mesh.face(h)); });
        selectAlongSurface(ball);
    }
    const PhaseTimer timer(report.deformMs);
    report.asked = planDeformation(m_region, m_mesh, task.settings, task.dab);
    task.steps = std::max(1.0, std::ceil(report.asked / (movePerMinimum * task.bounds.minimum)));
    return counts;
}

DabEngine::Substep DabEngine::straight(Task& task, DabReport& report)
{
    const Mesh::Mark mark = m_mesh.mark();
    RemeshCounts counts;
    if (task.steps == 0)
        counts += refineAndPlan(task, runPlainly, report);
    if (m_region.empty()) {
        m_mesh.rollback(mark);
        return Substep::Empty;
    }
    {
        const PhaseTimer timer(report.optimiseMs);
        counts += optimise(m_mesh, m_region, task.bounds, runPlainly);
    }
    bool inside = false;
    double reached = 0;
    {
        const PhaseTimer timer(report.deformMs);
        inside = displace(1 / task.steps);
        reached = farthestPlan(1 / task.steps);
    }
    if (inside) {
        const PhaseTimer timer(report.optimiseMs);
        counts += splitLongEdges(m_mesh, m_region, task.bounds, runPlainly);
    }
    if (!inside || !verifyAndIndex(mark, report)) {
        m_mesh.rollback(mark);
        return Substep::Stuck;
    }
    count(counts);
    report.reached += reached;
    return Substep::Straight;
}

DabEngine::Substep DabEngine::careful(Task& task, DabReport& report)
{
    const auto judged = [&](const std::function<void()>& operation) {
        const Mesh::Mark mark = m_mesh.mark();
        operation();
        if (verifyAndIndex(mark, report))
            return true;
        m_mesh.rollback(mark);
        return false;
    };
    if (task.steps == 0)
        count(refineAndPlan(task, judged, report));
    const bool moved = moveHeldBack(1 / task.steps, report);
    if (!optimiseAtOnce(task, report)) {
        const double verifyBefore = report.verifyMs;
        {
            const PhaseTimer timer(report.optimiseMs);
            count(optimise(m_mesh, m_region, task.bounds, judged));
        }
        report.optimiseMs -= report.verifyMs - verifyBefore;
    }
    return moved ? Substep::Careful : Substep::Stuck;
}

/// All operations in one transaction: what stopped the straight path was most likely the motion, not one of them.
bool DabEngine::optimiseAtOnce(Task& task, DabReport& report)
{
    const Region::Saved saved = m_region.save();
    const Mesh::Mark mark = m_mesh.mark();
    RemeshCounts counts;
    {
        const PhaseTimer timer(report.optimiseMs);
        counts = optimise(m_mesh, m_region, task.bounds, runPlainly);
    }
    if (!verifyAndIndex(mark, report)) {
        m_mesh.rollback(mark);
        m_region.restore(saved);
        return false;
    }
    count(counts);
    return true;
}

/// Moves what can be moved without touching anything. Ends: a round without progress holds something back for good.
bool DabEngine::moveHeldBack(double part, DabReport& report)
{
    extendHeld();
    for (int round = 0; round < mostHoldRounds; ++round) {
        const double reached = farthestPlan(part);
        if (reached == 0)
            return false;
        const Mesh::Mark mark = m_mesh.mark();
        m_lastBadFaces.clear();
        bool inside = false;
        {
            const PhaseTimer timer(report.deformMs);
            inside = displace(part);
        }
        if (inside && verifyAndIndex(mark, report)) {
            report.reached += reached;
            return true;
        }
        m_mesh.rollback(mark);
        if (!holdBack(m_lastBadFaces))
            return false;
    }
    return false;
}

/// Vertices that joined the region since are held back as far as their neighbours are.
void DabEngine::extendHeld()
{
    const std::vector<Slot>& slots = m_region.slots();
    const std::size_t known = m_held.size();
    m_held.resize(slots.size(), 1.0);
    if (known == 0)
        return;
    for (std::size_t i = known; i < slots.size(); ++i) {
        if (!m_region.contains(slots[i]))
            continue;
        m_mesh.forEachOutgoing(slots[i], [&](Slot h) {
            if (m_region.contains(m_mesh.to(h)))
                m_held[i] = std::min(m_held[i], m_held[m_region.position(m_mesh.to(h))]);
        });
    }
}

/// Shortens the motion of the region's vertices at and around the bad faces. False if none of them can be held back further.
bool DabEngine::holdBack(const std::vector<Slot>& badFaces)
{
    SparseIndex& around = m_region.scratch();
    around.clear();
    for (Slot f : badFaces) {
        for (Slot v : m_mesh.corners(f)) {
            around.add(v);
            m_mesh.forEachOutgoing(v, [&](Slot h) { around.add(m_mesh.to(h)); });
        }
    }
    bool any = false;
    for (Slot v : around.slots()) {
        if (!m_region.contains(v))
            continue;
        double& share = m_held[m_region.position(v)];
        any = any || share > 0;
        share = share == 1 ? heldShareOnce : 0;
    }
    return any;
}

/// Moves each vertex of the region by its part of the plan. False if one would leave the working volume.
bool DabEngine::displace(double part)
{
    const Lattice& lattice = m_mesh.lattice();
    bool inside = true;
    m_region.forEach([&](Slot v) {
        const double share = part * heldShare(v);
        const Vec3f before = m_mesh.point(v);
        const Vec3f after = lattice.snap(before.cast<double>() + share * m_region.plan(v));
        inside = inside && lattice.contains(after.cast<double>());
        if (inside && after != before)
            m_mesh.setPoint(v, after);
    });
    return inside;
}

double DabEngine::heldShare(Slot v) const
{
    return m_held.empty() ? 1 : m_held[m_region.position(v)];
}

double DabEngine::farthestPlan(double part) const
{
    double farthest2 = 0;
    m_region.forEach([&](Slot v) {
        const double share = part * heldShare(v);
        farthest2 = std::max(farthest2, share * share * m_region.plan(v).squaredNorm());
    });
    return std::sqrt(farthest2);
}

bool DabEngine::verifyAndIndex(const Mesh::Mark& mark, DabReport& report)
{
    const PhaseTimer timer(report.verifyMs);
    const TouchedSlots touched = m_mesh.touchedSince(mark);
    if (m_verification) {
        VerifyResult result = m_verifier.verify(m_mesh, m_octree, touched);
        if (!result.ok()) {
            m_lastBadFaces = std::move(result.badFaces);
            return false;
        }
        ++m_totals.verifyTiers[static_cast<std::size_t>(result.tier)];
    } else {
        m_verifier.collectDirty(m_mesh, touched);
    }
    m_touchedFaces = std::max(m_touchedFaces, static_cast<Slot>(m_verifier.dirtyFaces().size()));
    m_mesh.commit(mark);
    reindex(touched, m_verifier.dirtyFaces());
    return true;
}

void DabEngine::reindex(const TouchedSlots& touched, std::span<const Slot> dirtyFaces)
{
    m_octree.update(m_mesh, touched.faces);
    m_octree.update(m_mesh, dirtyFaces);
    m_dirtySlots.add(m_mesh, touched, dirtyFaces);
}

void DabEngine::follow(const MeshDelta& swapped)
{
    TouchedSlots touched;
    SparseIndex& dirty = m_region.scratch();
    dirty.clear();
    for (const FaceImage& image : swapped.faces) {
        touched.faces.push_back(image.slot);
        if (image.slot < m_mesh.slots().faces && m_mesh.isFace(image.slot))
            dirty.add(image.slot);
    }
    for (const VertexImage& image : swapped.vertices) {
        touched.vertices.push_back(image.slot);
        if (image.slot < m_mesh.slots().vertices && m_mesh.isVertex(image.slot))
            m_mesh.forEachOutgoing(image.slot, [&](Slot h) { dirty.add(m_mesh.face(h)); });
    }
    reindex(touched, dirty.slots());
}

void DabEngine::count(const RemeshCounts& counts)
{
    m_totals.splits += counts.splits;
    m_totals.collapses += counts.collapses;
    m_totals.flips += counts.flips;
    m_capped = m_capped || counts.capped;
}
} // namespace core
