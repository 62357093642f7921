#include "tests/support/fuzz_run.h"

#include "core/io/mesh_io.h"
#include "core/mesh/mesh_hash.h"
#include "core/operations/uniform_remesh.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"

#include <cstdlib>
#include <iostream>
#include <sstream>

using core::DabReport;
using core::Mesh;
using core::MeshDelta;
using core::Sculptor;
using core::Slot;
using core::Stroke;
using core::StrokeSettings;
using core::Symmetry;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
/// A run ends if its mesh has fewer than minFaces faces, because it has been sculpted away, or maxFaces() or more,
/// because it only takes more time.
constexpr Slot minFaces = 64;
Slot maxFaces()
{
    return byEffort<Slot>(3'000, 10'000);
}

constexpr int dabsPerPairCheck = 8, dabsPerJudge = 100;
/// Average number of steps per command to the whole model, and per undo.
constexpr std::uint64_t stepsPerCommand = 40, stepsPerUndo = 8;
using How = core::MaskOperation::Kind;
constexpr std::uint64_t maskChanges = std::uint64_t(How::Part) + 1;
/// Range of the target edge length of a remeshing, as a multiple of the mean edge length.
constexpr double finest = 0.8, coarsest = 2;

double largestCoordinate(const TriangleMesh& mesh)
{
    float largest = 0;
    for (const core::Vec3f& p : mesh.points)
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return largest;
}

Mesh sculptableCopy(const FuzzStart& start)
{
    return *sculptable(start.mesh);
}

/// Saves the start mesh of a failed run to the temporary folder, and returns its path.
std::filesystem::path save(const FuzzStart& start, std::uint64_t seed)
{
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("fettle-fuzz-" + std::to_string(seed) + ".ply");
    core::writeMesh(path, start.mesh);
    return path;
}
} // namespace

std::vector<FuzzStart> fuzzShapes()
{
    using namespace shapes;
    const TriangleMesh ball = core::icosphere(3, 1);
    const TriangleMesh specksInside = together(reversed(moved(core::icosphere(0, 0.02), {0, 0.95f, 0})),
                                               reversed(moved(core::icosphere(1, 0.05), {0.7f, 0, 0.5f})));
    const TriangleMesh plate = moved(clay::slab(0.3, 0.004, 3), {0, 1.05f, 0});
    return {{"sphere", ball},
            {"torus", torus()},
            {"thinSlab", clay::slab(2, 0.05, 12)},
            {"speck", together(core::icosphere(2, 1), moved(core::icosphere(0, 0.02), {1.06f, 0, 0}))},
            {"plate", together(core::icosphere(2, 1), plate)},
            {"twoFingers", clay::twoFingers(0.01)},
            {"nestedShells", nestedSpheres(true)},
            {"bowl", clay::bowl()},
            {"spiral", clay::spiral()},
            {"specksInside", together(ball, specksInside)}};
}

FuzzStart symmetrized(const FuzzStart& start, Symmetry plane)
{
    Mesh mesh = sculptableCopy(start);
    core::ModelChange change = applyToCopy(mesh, core::Symmetrize{plane});
    mesh.swap(change.delta);
    return {start.shape, mesh_asserts::surfaceOf(mesh), plane};
}

FuzzRun::FuzzRun(const FuzzStart& start, std::uint64_t seed, FuzzTally& tally)
    : m_start(start)
    , m_seed(seed)
    , m_fuzzer(seed)
    , m_tally(tally)
    , m_sculptor(sculptable(start.mesh))
    , m_where(start.shape + ", plane " + std::string(name(start.plane)) + ", seed " + std::to_string(seed))
    , m_startState(m_sculptor.mesh().stateHash())
    , m_trace(std::getenv("FETTLE_TRACE") != nullptr)
    , m_nextJudge(dabsPerJudge)
{}

std::optional<FuzzStart> FuzzRun::grown() const
{
    const Mesh& mesh = m_sculptor.mesh();
    FuzzStart end = {m_start.shape.starts_with("grown ") ? m_start.shape : "grown " + m_start.shape,
                     mesh_asserts::surfaceOf(mesh), m_start.plane};
    const bool fits = core::Lattice::forExtent(largestCoordinate(end.mesh)).exponent() >= mesh.lattice().exponent();
    return fits && mesh.live().faces >= minFaces && mesh.live().faces < maxFaces() / 2 ? std::optional(end)
                                                                                       : std::nullopt;
}

bool FuzzRun::mayGoOn() const
{
    const Slot faces = m_sculptor.mesh().live().faces;
    return ok() && faces >= minFaces && faces < maxFaces();
}

void FuzzRun::go(std::uint64_t dabs, AtEnd atEnd)
{
    ++m_tally.runs;
    judge("at the start");
    const std::uint64_t end = m_tally.dabs + dabs;
    while (m_tally.dabs < end && mayGoOn()) {
        if (m_fuzzer.below(stepsPerUndo) == 0 && !m_undo.empty())
            undoForGood();
        if (m_fuzzer.below(stepsPerCommand) == 0)
            command(nextCommand());
        else
            sculpt(nextStroke());
    }
    if (!ok())
        return;
    checkPairs("at the end");
    judge("at the end");
    walkHistory();
    if (atEnd == AtEnd::UndoAndReplay)
        replay();
    m_tally.digest = m_tally.digest * 31 + m_sculptor.mesh().stateHash();
    m_tally.add(m_sculptor.totals());
}

void FuzzRun::fail(const std::string& what)
{
    if (!ok())
        return;
    std::ostringstream text;
    text << m_where << ", step " << m_steps.size() << ", dab " << m_dabs << ": " << what
         << "; again with FETTLE_EFFORT=" << effortName() << " FETTLE_SEED=" << m_seed
         << " FETTLE_PLANE=" << name(m_start.plane) << " FETTLE_START=" << save(m_start, m_seed).string();
    m_problem = text.str();
}

// --- steps of a run

Stroke FuzzRun::nextStroke()
{
    Stroke stroke = m_fuzzer.stroke(m_sculptor.mesh());
    if (m_start.plane != Symmetry::None)
        stroke.settings.symmetry = m_start.plane;
    if (stroke.settings.symmetry != core::Symmetry::None)
        stroke.settings.join = false; // meeting balls in the mirror plane are not joined symmetrically bit for bit
    return stroke;
}

/// Returns a random command. In a symmetric run it preserves the symmetry.
core::ModelCommand FuzzRun::nextCommand()
{
    const Mesh& mesh = m_sculptor.mesh();
    // at least half of the mask commands clear the mask, so that enough of the model stays sculptable
    if (m_fuzzer.below(2) == 0)
        return core::MaskOperation{
            static_cast<How>(m_fuzzer.below(2) == 0 ? m_fuzzer.below(maskChanges) : std::uint64_t(How::Clear)), {}};
    if (m_start.plane != Symmetry::None)
        return core::Symmetrize{m_start.plane, m_fuzzer.below(2) == 0 ? core::Half::Positive : core::Half::Negative};
    const auto sized = [&](double from, double to) { return m_fuzzer.uniform(from, to); };
    switch (m_fuzzer.below(8)) {
    case 0:
        return core::Move{sized(0, 0.2) * m_fuzzer.direction()};
    case 1: {
        const Vec3 axis = sized(0, 3) * m_fuzzer.direction();
        return core::Rotate{Eigen::Quaterniond(1, axis.x(), axis.y(), axis.z()).normalized()};
    }
    case 2:
        return core::Scale{sized(0.8, 1.25)};
    case 3:
        return core::Mirror{static_cast<int>(m_fuzzer.below(3))};
    case 4:
        return core::Recentre{};
    case 6: {
        const Vec3 axis = sized(0, 0.3) * m_fuzzer.direction();
        return core::Transform{mesh.point(*mesh.vertices().begin()).cast<double>(),
                               sized(0, 0.1) * m_fuzzer.direction(),
                               Eigen::Quaterniond(1, axis.x(), axis.y(), axis.z()).normalized(),
                               {sized(0.8, 1.25), sized(0.8, 1.25), sized(0.8, 1.25)}};
    }
    case 5: {
        const double mean2 = core::areaOf(mesh) / mesh.live().faces * 2; // roughly the square of the mean edge length
        return core::RemeshUniformly{sized(finest, coarsest) * 1.5 * std::sqrt(mean2)};
    }
    default:
        return core::Fill{{static_cast<std::uint8_t>(m_fuzzer.below(256)), 40, 90}};
    }
}

/// Sculpts the stroke sample by sample. Stops early if the run must end.
void FuzzRun::sculpt(Stroke stroke)
{
    ++m_tally.strokes;
    m_sculptor.setAfterDab([&](const DabReport& report) {
        m_tally.add(stroke.settings, report, m_start.shape);
        ++m_dabs;
        if (m_trace)
            trace(stroke.settings, report);
        if (report.asymmetric && m_start.plane != Symmetry::None)
            fail("taken for asymmetric");
    });
    m_sculptor.beginStroke(stroke.settings);
    std::size_t used = 0;
    while (used < stroke.samples.size() && mayGoOn()) {
        // anchored dabs are shown at once; replay() lets them wait for the end, with the same result
        m_sculptor.addSample(stroke.samples[used++], Sculptor::Anchored::Shown);
        checkAfterSample();
    }
    stroke.samples.resize(used);
    MeshDelta delta = m_sculptor.endStroke();
    m_sculptor.setAfterDab({});
    done(std::move(delta), std::move(stroke));
    checkAfterSample(); // checks the dabs that were still waiting
}

void FuzzRun::command(const core::ModelCommand& command)
{
    ++m_tally.commands;
    core::ModelChange change = applyToCopy(m_sculptor.mesh(), command);
    if (!change.changes)
        return;
    m_sculptor.swap(change.delta);
    done(std::move(change.delta), command);
    checkAfterSample();
    judge("after a command");
}

void FuzzRun::done(MeshDelta delta, Step step)
{
    m_undo.push_back(std::move(delta));
    m_steps.push_back(std::move(step));
    m_states.push_back(m_sculptor.mesh().stateHash());
    if (m_sculptor.mesh().meshHash() != wholeHash(m_sculptor.mesh()))
        fail("the mesh hash is not that of the faces");
}

/// Undoes the last step and removes it from the history of the run, so that different steps follow.
void FuzzRun::undoForGood()
{
    m_sculptor.swap(m_undo.back());
    m_undo.pop_back();
    m_steps.pop_back();
    m_states.pop_back();
    checkIndex("after an undo");
}

void FuzzRun::trace(const StrokeSettings& s, const DabReport& report) const
{
    std::cout << m_where << ", step " << m_steps.size() << ", dab " << m_dabs << ": " << name(s.tool) << ' '
              << name(s.brush) << ' ' << name(s.place) << ' ' << name(s.topology) << " fusion " << s.fusion
              << " symmetry " << name(s.symmetry) << (report.asymmetric ? " (as two dabs)" : "") << " radial "
              << s.radial << " radius " << s.radius << " strength " << s.strength << " falloff " << s.falloff
              << " detail " << s.detail << ": " << name(report.outcome) << ", " << report.touchedVertices
              << " vertices, " << report.substeps << " sub-steps, " << report.reached << " of " << report.asked
              << (report.contact ? " (contact), " : ", ") << report.totalMs << " ms, fuse " << report.fuseMs
              << " ms, verify " << report.verifyMs << " ms, optimise " << report.optimiseMs << " ms, model "
              << m_sculptor.mesh().live().faces << " faces" << std::endl;
}

// --- checks of the mesh

void FuzzRun::checkAfterSample()
{
    checkIndex("after a dab");
    if (const auto quality = m_sculptor.selectionQuality(); quality && !(quality->longestEdge > 0))
        fail("what the last dab selected has no edges");
    if (m_start.plane != Symmetry::None) {
        if (const std::string asymmetry = mirror_asserts::asymmetry(m_sculptor.mesh(), m_start.plane);
            !asymmetry.empty())
            fail(asymmetry);
    }
    if (m_dabs >= m_nextPairCheck) {
        m_nextPairCheck = m_dabs + dabsPerPairCheck;
        checkPairs("after a dab");
    }
    if (m_dabs >= m_nextJudge) {
        m_nextJudge = m_dabs + dabsPerJudge;
        judge("after a dab");
    }
}

void FuzzRun::checkIndex(const char* when)
{
    if (!m_sculptor.indexIsConsistent())
        fail(std::string("the octree is wrong ") + when);
}

void FuzzRun::checkPairs(const char* when)
{
    if (const std::string broken = mesh_asserts::brokenLinks(m_sculptor.mesh()); !broken.empty())
        fail(std::string("broken links ") + when + ": " + broken);
    else if (const auto bad = mesh_asserts::badFaces(m_sculptor.mesh()); !bad.empty())
        fail(std::to_string(bad.size()) + " bad faces " + when + ", the first " + std::to_string(bad.front()));
}

void FuzzRun::judge(const char* when)
{
    ++m_tally.judged;
    if (const std::string verdict = mesh_asserts::unsoundness(m_sculptor.mesh()); !verdict.empty())
        fail(std::string("judged ") + when + ": " + verdict);
}

void FuzzRun::walkHistory()
{
    const std::uint64_t end = m_sculptor.mesh().stateHash();
    for (auto delta = m_undo.rbegin(); delta != m_undo.rend(); ++delta)
        m_sculptor.swap(*delta);
    if (m_sculptor.mesh().stateHash() != m_startState)
        fail("undoing everything does not lead to the start");
    checkIndex("after undoing everything");
    for (MeshDelta& delta : m_undo)
        m_sculptor.swap(delta);
    if (m_sculptor.mesh().stateHash() != end)
        fail("redoing everything does not lead to the end");
    checkIndex("after redoing everything");
}

/// Repeats the run's steps from the start mesh, omitting the steps that were undone for good.
void FuzzRun::replay()
{
    Sculptor again(sculptable(m_start.mesh));
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        if (const auto* stroke = std::get_if<Stroke>(&m_steps[i])) {
            again.beginStroke(stroke->settings);
            for (const core::StrokeSample& sample : stroke->samples)
                again.addSample(sample);
            again.endStroke();
        } else {
            core::ModelChange change = applyToCopy(again.mesh(), std::get<core::ModelCommand>(m_steps[i]));
            again.swap(change.delta);
        }
        if (again.mesh().stateHash() != m_states[i]) {
            fail("the same steps give another mesh from step " + std::to_string(i + 1) + " of " +
                 std::to_string(m_steps.size()) + " on");
            return;
        }
    }
}
