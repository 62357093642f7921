// Tests the engine's guarantees under random and specific strokes: after every dab the mesh is valid and the octree
// consistent, undo and redo restore the same bits, and dabs reach the requested displacement if that is possible.
//
// FETTLE_EFFORT=soak: a million dabs. FETTLE_SEED=n: another seed. FETTLE_DABS=n: another number of dabs.
// FETTLE_TRACE=1: prints the report of each dab. FETTLE_START=file, FETTLE_PLANE=x|y|z: the first run starts with this
// mesh, which is symmetric about this plane.

#include "core/io/mesh_io.h"
#include "core/sculpt/sculptor.h"
#include "core/util/worker_pool.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
#include "tests/support/fuzz_run.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <deque>
#include <iostream>
#include <utility>

namespace
{
using core::DabOutcome;
using core::DabReport;
using core::Mesh;
using core::MeshDelta;
using core::Sculptor;
using core::Slot;
using core::Symmetry;
using core::Tool;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::sculptable;
} // namespace

class TestSculptor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomStrokes_keepThePromise_data();
    void randomStrokes_keepThePromise();
    void undoneStrokes_leaveNoTraceInMirroredOnes();
    void afterUndo_theSelectionHasNoQuality();
    void pushesThroughASlab_leaveNoSpecksToJoin_data();
    void pushesThroughASlab_leaveNoSpecksToJoin();
    void pushThroughASlab_withoutFusion_stopsAtContact();
    void fingersPulledTogether_withoutFusion_stopAtContact();
    void surfaceAtContact_withoutFusion_followsAPullAway();
    void threads_doNotChangeABit();
    void wallOfTheVolume_endsTheDab();
    void dabOnNothing_changesNothing();
    void rayThatMisses_changesNothing();
    void strengthZero_changesNothing();
    void extremeRadii_haveAnAnswer_data();
    void extremeRadii_haveAnAnswer();
    void unusableSamples_areEmptyDabs_data();
    void unusableSamples_areEmptyDabs();
    void extremeSamples_haveAnAnswer_data();
    void extremeSamples_haveAnAnswer();
    void manySamples_inOneStroke();
    void tooManyOperations_endTheDab();
    void tooManyMoves_endTheDab();
    void peersStroke_commitsOnTheStraightPath();
    void reports_tellWhatTheDabDid();
    void hook_runsBetweenSubsteps();
    void rehearsal_leavesNoTrace();
};

namespace
{
struct OneDab
{
    Tool tool = Tool::Pull;
    Vec3 position = Vec3::Zero();
    double radius = 0.25;
    double strength = 1;
    double detail = 1;
    bool fusion = true;
};

/// Sculpts a stroke of one dab.
DabReport dabOnce(Sculptor& sculptor, const OneDab& dab)
{
    core::StrokeSettings settings;
    settings.tool = dab.tool;
    settings.radius = dab.radius;
    settings.strength = dab.strength;
    settings.detail = dab.detail;
    settings.fusion = dab.fusion;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = dab.position;
    const std::vector<DabReport> reports = sculptor.addSample(sample);
    sculptor.endStroke();
    return reports.empty() ? DabReport() : reports.front();
}

core::Box boundsOf(const Mesh& mesh)
{
    core::Box box;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v))
            box.extend(mesh.point(v).cast<double>());
    }
    return box;
}
} // namespace

namespace
{
constexpr std::uint64_t dabsPerLine = 10'000, seedsPerPart = 1'000'000;
constexpr int fuzzParts = 4;
/// Every run is replayed until `replayed` dabs are done, then one in four. Replaying takes as long as the run and finds
/// only non-determinism.
constexpr std::uint64_t runsPerReplay = 4;

/// Start meshes of the fuzzer's runs. The sequence repeats: two plain shapes, a symmetric one, and one grown in an
/// earlier run.
class FuzzStarts
{
public:
    FuzzStarts() : m_shapes(fuzzShapes())
    {
        if (!qEnvironmentVariableIsSet("FETTLE_START"))
            return;
        const std::string plane = qEnvironmentVariable("FETTLE_PLANE", "none").toStdString();
        m_given = {"given", core::readMesh(qEnvironmentVariable("FETTLE_START").toStdString()),
                   core::named<core::Symmetry>(plane).value()};
    }

    FuzzStart next()
    {
        if (m_given)
            return *std::exchange(m_given, {});
        constexpr Symmetry planes[] = {Symmetry::X, Symmetry::Y, Symmetry::Z};
        const std::size_t run = m_run++, round = run / 4;
        if (run % 4 == 2)
            return symmetrized(m_shapes[round % m_shapes.size()], planes[round % std::size(planes)]);
        if (run % 4 == 3 && !m_grown.empty()) {
            const FuzzStart start = std::move(m_grown.front());
            m_grown.pop_front();
            return start;
        }
        return m_shapes[m_plain++ % m_shapes.size()];
    }

    void keep(const std::optional<FuzzStart>& grown)
    {
        if (grown)
            m_grown.push_back(*grown);
        if (m_grown.size() > maxGrown)
            m_grown.pop_front();
    }

private:
    static constexpr std::size_t maxGrown = 16;

    std::vector<FuzzStart> m_shapes;
    std::optional<FuzzStart> m_given;
    std::deque<FuzzStart> m_grown;
    std::size_t m_run = 0, m_plain = 0;
};
} // namespace

/// Splits the runs into parts, because QtTest limits the time of a test function.
void TestSculptor::randomStrokes_keepThePromise_data()
{
    QTest::addColumn<int>("part");
    for (int part = 0; part < fuzzParts; ++part)
        QTest::addRow("part %d", part) << part;
}

void TestSculptor::randomStrokes_keepThePromise()
{
    QFETCH(int, part);
    const auto dabsPerRun = byEffort<std::uint64_t>(100, 250);
    const auto replayed = byEffort<std::uint64_t>(1'600, 20'000) / fuzzParts;
    const auto usualDabs = isSlowBuild ? std::uint64_t(300) : byEffort<std::uint64_t>(20'000, 20'000, 1'000'000);
    const std::uint64_t dabs = numberFromEnvironment("FETTLE_DABS", usualDabs) / fuzzParts;
    const std::uint64_t seed =
        numberFromEnvironment("FETTLE_SEED", 20240812) + seedsPerPart * static_cast<std::uint64_t>(part);
    FuzzStarts starts;
    FuzzTally tally;
    for (std::uint64_t run = 0, line = dabsPerLine; tally.dabs < dabs; ++run) {
        const FuzzStart start = starts.next();
        FuzzRun fuzz(start, seed + run, tally);
        const bool replays = tally.dabs < replayed || run % runsPerReplay == 0;
        fuzz.go(std::min(dabsPerRun, dabs - tally.dabs),
                replays ? FuzzRun::AtEnd::UndoAndReplay : FuzzRun::AtEnd::Undo);
        if (!fuzz.ok() || tally.dabs >= std::min(line, dabs)) {
            tally.print(std::cout);
            line += dabsPerLine;
        }
        QVERIFY2(fuzz.ok(), fuzz.problem().c_str());
        starts.keep(fuzz.grown());
    }
    tally.printClasses(std::cout);
}

/// Minimised from a failed run: faces that the octree found beyond the brush used to influence where a mirrored dab
/// refines.
void TestSculptor::undoneStrokes_leaveNoTraceInMirroredOnes()
{
    Sculptor used(sculptable(clay::twoFingers(0.01))), fresh(sculptable(clay::twoFingers(0.01)));
    core::StrokeSettings pull;
    pull.radius = 0.95;
    pull.detail = 1.86;
    pull.fusion = false;
    used.beginStroke(pull);
    core::StrokeSample sample;
    sample.position = {-0.02, 0.77, -0.08};
    used.addSample(sample);
    MeshDelta delta = used.endStroke();
    used.swap(delta);
    QCOMPARE(used.mesh().stateHash(), fresh.mesh().stateHash());

    core::StrokeSettings flatten;
    flatten.tool = Tool::Flatten;
    flatten.place = core::Placement::Nearest;
    flatten.topology = core::Topology::Uniform;
    flatten.symmetry = Symmetry::Z;
    flatten.radius = 0.27;
    for (const double x : {-0.6, -0.4, -0.2, 0.2, 0.4, 0.6}) {
        for (const double y : {-0.8, -0.4, 0.0, 0.4, 0.8}) {
            sample.position = {x, y, 0.5};
            for (Sculptor* sculptor : {&used, &fresh}) {
                sculptor->beginStroke(flatten);
                sculptor->addSample(sample);
                sculptor->endStroke();
            }
            QCOMPARE(used.mesh().stateHash(), fresh.mesh().stateHash());
        }
    }
}

/// Minimised from a run that hung: after an undo, a dab that met nothing was asked for the quality of the earlier
/// selection.
void TestSculptor::afterUndo_theSelectionHasNoQuality()
{
    Sculptor sculptor(sculptable(core::icosphere(3, 1)));
    core::StrokeSettings pull;
    pull.radius = 0.3;
    pull.place = core::Placement::Ray;
    core::StrokeSample sample;
    sample.position = {0, 0, 2};
    sculptor.beginStroke(pull);
    sculptor.addSample(sample);
    QVERIFY(sculptor.selectionQuality());
    MeshDelta delta = sculptor.endStroke();
    sculptor.swap(delta);
    sample.position = {0, 5, 2};
    sculptor.beginStroke(pull);
    QCOMPARE(sculptor.addSample(sample).at(0).outcome, core::DabOutcome::Empty);
    QVERIFY(!sculptor.selectionQuality());
    sculptor.endStroke();
}

void TestSculptor::pushesThroughASlab_leaveNoSpecksToJoin_data()
{
    QTest::addColumn<double>("thickness");
    QTest::addColumn<double>("strength");
    QTest::addColumn<double>("detail");
    QTest::addColumn<int>("falloff");
    QTest::newRow("thicker") << 0.1 << 1.0 << 0.5 << 0;
    QTest::newRow("thicker, stronger") << 0.1 << 2.0 << 0.5 << 0;
}

/// Joining used to loop forever on a vertex that had been removed with a speck.
void TestSculptor::pushesThroughASlab_leaveNoSpecksToJoin()
{
    QFETCH(double, thickness);
    QFETCH(double, strength);
    QFETCH(double, detail);
    QFETCH(int, falloff);
    Sculptor sculptor(sculptable(clay::slab(2, thickness, 12)));
    core::StrokeSettings settings;
    settings.tool = Tool::Push;
    settings.place = core::Placement::Nearest;
    settings.radius = 0.5;
    settings.strength = strength;
    settings.detail = detail;
    settings.falloff = falloff;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {0.03, thickness / 2, 0.02};
    for (int i = 0; i < 3; ++i)
        sculptor.addSample(sample);
    sculptor.endStroke();
    QVERIFY(sculptor.totals().fusions > 0);
    VERIFY_VALID(sculptor.mesh());
}

void TestSculptor::pushThroughASlab_withoutFusion_stopsAtContact()
{
    Sculptor sculptor(sculptable(clay::slab(2, 0.1, 16)));
    bool stopped = false;
    for (int i = 0; i < 20; ++i) {
        const auto above = sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}});
        QVERIFY(above);
        const DabReport report = dabOnce(
            sculptor, {.tool = Tool::Push, .position = above->position, .radius = 0.4, .strength = 2, .fusion = false});
        const bool stops = report.outcome == DabOutcome::EndedEarly || report.reached < 0.95 * report.asked;
        QVERIFY(report.contact || !stops); // the report must give the reason
        QCOMPARE(core::shortfallOf(report), stops ? core::Shortfall::Contact : core::Shortfall::None);
        stopped = stopped || stops;
        VERIFY_VALID(sculptor.mesh());
        QVERIFY(sculptor.indexIsConsistent());
        QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 2);
    }
    QVERIFY(stopped); // 20 dabs of 0.08 would pierce a slab of 0.1 several times
}

void TestSculptor::fingersPulledTogether_withoutFusion_stopAtContact()
{
    Sculptor sculptor(sculptable(clay::twoFingers(0.2)));
    for (int i = 0; i < 12; ++i) {
        for (double side : {-1.0, 1.0}) {
            const auto facing = sculptor.hit({{0, 0.01, 0.02}, {side, 0, 0}});
            if (!facing)
                continue; // the surface has grown over the point between the fingers
            dabOnce(sculptor, {.tool = Tool::Pull, .position = facing->position, .radius = 0.3, .fusion = false});
            VERIFY_VALID(sculptor.mesh());
            QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 4);
        }
    }
    const auto left = sculptor.hit({{-0.1, 0.01, 0.02}, {1, 0, 0}}),
               right = sculptor.hit({{0.1, 0.01, 0.02}, {-1, 0, 0}});
    // they stop only after coming near each other
    QVERIFY(!left || !right || (left->position - right->position).norm() < 0.1);
}

void TestSculptor::surfaceAtContact_withoutFusion_followsAPullAway()
{
    Sculptor sculptor(sculptable(clay::slab(2, 0.1, 16)));
    for (int i = 0; i < 10; ++i) {
        const auto above = sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}});
        QVERIFY(above);
        dabOnce(sculptor, {.tool = Tool::Push, .position = above->position, .radius = 0.4, .fusion = false});
    }
    const auto above = sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}});
    QVERIFY(above);
    const DabReport away =
        dabOnce(sculptor, {.tool = Tool::Pull, .position = above->position, .radius = 0.4, .fusion = false});
    QVERIFY(away.outcome == DabOutcome::Committed || away.outcome == DabOutcome::Fallback);
    QVERIFY(away.reached >= 0.95 * away.asked && !away.contact);
    const auto after = sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}});
    QVERIFY(after && after->position.y() > above->position.y() + 0.02); // the full displacement is 0.04 at the peak
    VERIFY_VALID(sculptor.mesh());
}

/// Large dabs of each tool, one of which folds the surface, so that each phase of a dab uses several threads.
void TestSculptor::threads_doNotChangeABit()
{
    const TriangleMesh ball = core::icosphere(6, 1);
    std::vector<std::uint64_t> hashes;
    for (const std::size_t threads : {1, 2, 16}) {
        core::WorkerPool::shared().setThreads(threads);
        Sculptor sculptor(sculptable(ball));
        std::uint64_t patches = 0;
        for (const Tool tool : {Tool::Pull, Tool::Push, Tool::Flatten, Tool::Smooth, Tool::Push}) {
            const DabReport report = dabOnce(sculptor, {tool, Vec3(0, 0, 1), 0.7, 1, 0.2});
            QVERIFY(report.touchedVertices > 4096);
            for (const core::DrawVertex& v : sculptor.takePatch().vertices)
                patches =
                    patches * 31 + static_cast<std::uint8_t>(v.normal[0]) + static_cast<std::uint8_t>(v.normal[2]);
        }
        dabOnce(sculptor, {Tool::Push, Vec3(0, 0, 1), 0.5, 8, 0.3});
        hashes.push_back(sculptor.mesh().stateHash() + patches);
    }
    core::WorkerPool::shared().setThreads(0);
    QCOMPARE(hashes[1], hashes[0]);
    QCOMPARE(hashes[2], hashes[0]);
}

void TestSculptor::wallOfTheVolume_endsTheDab()
{
    const core::Lattice tight(23); // the working volume is just the bounding box of the sphere
    Sculptor sculptor(sculptable(core::icosphere(3, 1), tight));
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 0.3, 3});
    QVERIFY(report.outcome == DabOutcome::EndedEarly && report.reached < report.asked);
    QVERIFY(report.wall && core::shortfallOf(report) == core::Shortfall::Wall);
    VERIFY_VALID(sculptor.mesh());
    QVERIFY(boundsOf(sculptor.mesh()).max().z() <= 1);
    QVERIFY(sculptor.indexIsConsistent());
}

void TestSculptor::dabOnNothing_changesNothing()
{
    Sculptor sculptor(sculptable(core::icosphere(3, 1)));
    const std::uint64_t state = sculptor.mesh().stateHash();
    for (const Vec3& position : {Vec3(5, 0, 0), Vec3(0, 0, 0), Vec3(1e7, -1e7, 1e7)}) {
        core::StrokeSettings settings;
        settings.radius = 0.25;
        sculptor.beginStroke(settings);
        core::StrokeSample sample;
        sample.position = position;
        const std::vector<DabReport> reports = sculptor.addSample(sample);
        QCOMPARE(reports.size(), std::size_t(1));
        QVERIFY(reports.front().outcome == DabOutcome::Empty);
        QVERIFY(sculptor.endStroke().empty());
        QCOMPARE(sculptor.mesh().stateHash(), state);
        QVERIFY(sculptor.takePatch().empty());
    }
}

void TestSculptor::rayThatMisses_changesNothing()
{
    Sculptor sculptor(sculptable(core::icosphere(3, 1)));
    core::StrokeSettings settings;
    settings.radius = 0.25;
    settings.place = core::Placement::Ray;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {5, 5, 5};
    sample.direction = {1, 0, 0};
    const std::vector<DabReport> reports = sculptor.addSample(sample);
    QCOMPARE(reports.size(), std::size_t(1));
    QVERIFY(reports.front().outcome == DabOutcome::Empty);
    QVERIFY(sculptor.endStroke().empty());
}

void TestSculptor::strengthZero_changesNothing()
{
    for (Tool tool : {Tool::Pull, Tool::Push, Tool::Smooth}) {
        Sculptor sculptor(sculptable(core::icosphere(3, 1)));
        const std::uint64_t state = sculptor.mesh().stateHash();
        const DabReport report = dabOnce(sculptor, {tool, {0, 0, 1}, 0.25, 0});
        QVERIFY(report.outcome == DabOutcome::Empty);
        QCOMPARE(sculptor.mesh().stateHash(), state);
    }
}

void TestSculptor::extremeRadii_haveAnAnswer_data()
{
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("detail");
    for (double radius : {1e-6, 1e-3, 2.0, 100.0, 1e6}) {
        for (double detail : {0.05, 1.0, 20.0})
            QTest::addRow("radius %g, detail %g", radius, detail) << radius << detail;
    }
}

void TestSculptor::extremeRadii_haveAnAnswer()
{
    QFETCH(double, radius);
    QFETCH(double, detail);
    for (Tool tool : {Tool::Pull, Tool::Push, Tool::Smooth}) {
        Sculptor sculptor(sculptable(core::icosphere(2, 1)));
        const std::uint64_t start = sculptor.mesh().stateHash();
        core::StrokeSettings settings;
        settings.tool = tool;
        settings.radius = radius;
        settings.detail = detail;
        settings.strength = 10;
        settings.place = core::Placement::Nearest;
        sculptor.beginStroke(settings);
        core::StrokeSample sample;
        sample.position = {0.3, 0.2, 1.1};
        QCOMPARE(sculptor.addSample(sample).size(), std::size_t(1));
        MeshDelta delta = sculptor.endStroke();
        VERIFY_VALID(sculptor.mesh());
        QVERIFY(sculptor.indexIsConsistent());
        sculptor.swap(delta);
        QCOMPARE(sculptor.mesh().stateHash(), start);
    }
}

namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

using Spoil = std::function<void(core::StrokeSettings&, core::StrokeSample&)>;
} // namespace

void TestSculptor::unusableSamples_areEmptyDabs_data()
{
    using Settings = core::StrokeSettings;
    using Sample = core::StrokeSample;
    QTest::addColumn<Spoil>("spoil");
    for (double value : {notANumber, infinite, -infinite, -1e300, 1e300}) {
        QTest::addRow("position %g", value) << Spoil([value](Settings&, Sample& s) { s.position.y() = value; });
        QTest::addRow("direction %g", value) << Spoil([value](Settings&, Sample& s) { s.direction.x() = value; });
        QTest::addRow("pressure %g", value) << Spoil([value](Settings&, Sample& s) { s.pressure = value; });
        QTest::addRow("rotation %g", value) << Spoil([value](Settings&, Sample& s) { s.rotation.x() = value; });
        QTest::addRow("radius %g", value) << Spoil([value](Settings& t, Sample&) { t.radius = value; });
        QTest::addRow("sample radius %g", value) << Spoil([value](Settings&, Sample& s) { s.radius = value; });
        QTest::addRow("strength %g", value) << Spoil([value](Settings& t, Sample&) { t.strength = value; });
        QTest::addRow("sample strength %g", value) << Spoil([value](Settings&, Sample& s) { s.strength = value; });
        QTest::addRow("detail %g", value) << Spoil([value](Settings& t, Sample&) { t.detail = value; });
        QTest::addRow("detail length %g", value) << Spoil([value](Settings& t, Sample&) { t.detailLength = value; });
        QTest::addRow("spacing %g", value) << Spoil([value](Settings& t, Sample&) { t.spacing = value; });
    }
    QTest::newRow("radius 0") << Spoil([](Settings& t, Sample&) { t.radius = 0; });
    QTest::newRow("radius denormal") << Spoil([](Settings& t, Sample&) { t.radius = denormal; });
    QTest::newRow("detail denormal") << Spoil([](Settings& t, Sample&) { t.detail = denormal; });
    QTest::newRow("falloff 2") << Spoil([](Settings& t, Sample&) { t.falloff = 2; });
    QTest::newRow("falloff -1") << Spoil([](Settings& t, Sample&) { t.falloff = -1; });
    QTest::newRow("rotation 0") << Spoil([](Settings&, Sample& s) { s.rotation.coeffs().setZero(); });
}

void TestSculptor::unusableSamples_areEmptyDabs()
{
    QFETCH(Spoil, spoil);
    Sculptor sculptor(sculptable(core::icosphere(2, 1)));
    const std::uint64_t start = sculptor.mesh().stateHash();
    core::StrokeSettings settings;
    settings.radius = 0.4;
    core::StrokeSample sample;
    sample.position = {0, 0, 1};
    spoil(settings, sample);
    sculptor.beginStroke(settings);
    for (int i = 0; i < 2; ++i) {
        const std::vector<DabReport> reports = sculptor.addSample(sample);
        QCOMPARE(reports.size(), std::size_t(1));
        QVERIFY(reports.front().outcome == DabOutcome::Empty);
    }
    QVERIFY(sculptor.endStroke().empty());
    QCOMPARE(sculptor.mesh().stateHash(), start);

    core::StrokeSettings sound; // the next stroke must work normally
    sound.radius = 0.4;
    sculptor.beginStroke(sound);
    core::StrokeSample next;
    next.position = {0, 0, 1};
    QVERIFY(sculptor.addSample(next).at(0).outcome == DabOutcome::Committed);
    sculptor.endStroke();
    VERIFY_VALID(sculptor.mesh());
}

void TestSculptor::extremeSamples_haveAnAnswer_data()
{
    QTest::addColumn<Spoil>("spoil");
    QTest::newRow("denormal position") << Spoil([](auto&, auto& s) { s.position = {denormal, -denormal, 1}; });
    QTest::newRow("denormal pressure") << Spoil([](auto&, auto& s) { s.pressure = denormal; });
    QTest::newRow("denormal strength") << Spoil([](auto& t, auto&) { t.strength = denormal; });
    QTest::newRow("denormal direction") << Spoil([](auto& t, auto& s) {
        t.place = core::Placement::Ray;
        s.direction = {0, 0, -denormal};
    });
    QTest::newRow("no direction") << Spoil([](auto& t, auto& s) {
        t.brush = core::BrushShape::Ray;
        s.direction.setZero();
    });
    QTest::newRow("far position") << Spoil([](auto&, auto& s) { s.position = {1e9, -1e9, 1e9}; });
    QTest::newRow("far position, brush as large") << Spoil([](auto& t, auto& s) {
        s.position = {0, 0, 1e6};
        t.radius = 1e6;
    });
    QTest::newRow("nearest from afar") << Spoil([](auto& t, auto& s) {
        t.place = core::Placement::Nearest;
        s.position = {1e9, -1e9, 1e9};
    });
    QTest::newRow("ray from afar") << Spoil([](auto& t, auto& s) {
        t.brush = core::BrushShape::Ray;
        s.position = {0, 0, 1e9};
        s.direction = {0, 0, -1e9};
    });
    QTest::newRow("detail length below the lattice's") << Spoil([](auto& t, auto&) {
        t.radius = 0.02;
        t.topology = core::Topology::Uniform;
        t.detailLength = 1e-6;
    });
    QTest::newRow("detail length of kilometres") << Spoil([](auto& t, auto&) {
        t.topology = core::Topology::Uniform;
        t.detailLength = 1e6;
    });
}

void TestSculptor::extremeSamples_haveAnAnswer()
{
    QFETCH(Spoil, spoil);
    for (Tool tool : {Tool::Pull, Tool::Flatten, Tool::Smooth}) {
        Sculptor sculptor(sculptable(core::icosphere(3, 1)));
        const std::uint64_t start = sculptor.mesh().stateHash();
        core::StrokeSettings settings;
        settings.tool = tool;
        settings.radius = 0.4;
        core::StrokeSample sample;
        sample.position = {0, 0, 1};
        spoil(settings, sample);
        sculptor.beginStroke(settings);
        QCOMPARE(sculptor.addSample(sample).size(), std::size_t(1));
        MeshDelta delta = sculptor.endStroke();
        VERIFY_VALID(sculptor.mesh());
        QVERIFY(sculptor.indexIsConsistent());
        sculptor.swap(delta);
        QCOMPARE(sculptor.mesh().stateHash(), start);
    }
}

void TestSculptor::manySamples_inOneStroke()
{
    Sculptor sculptor(sculptable(core::icosphere(2, 1)));
    const std::uint64_t start = sculptor.mesh().stateHash();
    core::StrokeSettings settings;
    settings.radius = 0.4;
    settings.strength = 0.01;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    for (int i = 0; i < 1'000'000; ++i) { // the pointer moves in empty space and touches the surface occasionally
        sample.position = {0, 1e-6 * i, i % 10'000 == 0 ? 1.0 : 3.0};
        QCOMPARE(sculptor.addSample(sample).size(), std::size_t(1));
    }
    MeshDelta delta = sculptor.endStroke();
    QVERIFY(!delta.empty());
    VERIFY_VALID(sculptor.mesh());
    sculptor.swap(delta);
    QCOMPARE(sculptor.mesh().stateHash(), start);
}

/// A fine brush on a coarse model reaches the limit of operations per sub-step.
void TestSculptor::tooManyOperations_endTheDab()
{
    Sculptor sculptor(sculptable(core::icosphere(1, 1)));
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 2, 1, 0.05});
    QVERIFY(report.outcome == DabOutcome::EndedEarly && report.reached < report.asked);
    QVERIFY(report.capped && core::shortfallOf(report) == core::Shortfall::Capped);
    VERIFY_VALID(sculptor.mesh());
}

/// A brush that is fine, large and strong needs hundreds of sub-steps of tens of thousands of vertices.
void TestSculptor::tooManyMoves_endTheDab()
{
    Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    sculptor.setVerification(false); // skips the exact check, which would only take time here
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 2, 10, 0.05});
    QVERIFY(report.outcome == DabOutcome::EndedEarly && report.substeps > 10);
    QVERIFY(report.reached > 0 && report.reached < report.asked);
    QVERIFY(report.capped && core::shortfallOf(report) == core::Shortfall::Capped);
    VERIFY_LINKED(sculptor.mesh());
}

/// The strokes of the speed comparison: along a great circle, with a displacement of 0.02 radii per dab.
void TestSculptor::peersStroke_commitsOnTheStraightPath()
{
    Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    core::StrokeSettings settings;
    settings.radius = 0.25;
    settings.strength = 0.2;
    sculptor.beginStroke(settings);
    int direct = 0;
    constexpr int dabs = 200;
    for (int i = 0; i < dabs; ++i) {
        const double angle = 0.126 * settings.radius * i;
        core::StrokeSample sample;
        sample.position = {std::cos(angle), 0, std::sin(angle)};
        for (const DabReport& report : sculptor.addSample(sample))
            direct += report.outcome == DabOutcome::Committed && report.reached >= 0.999 * report.asked;
        QVERIFY(sculptor.indexIsConsistent());
    }
    sculptor.endStroke();
    VERIFY_VALID(sculptor.mesh());
    QVERIFY2(direct >= 0.99 * dabs, qPrintable(QString::number(direct)));
}

void TestSculptor::reports_tellWhatTheDabDid()
{
    Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    const double before = boundsOf(sculptor.mesh()).max().z();
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 0.25, 1});
    QVERIFY(report.outcome == DabOutcome::Committed);
    // 0.1 radii, nearly reached because a vertex is at the centre
    QVERIFY(report.asked > 0.0249 && report.asked <= 0.025);
    QVERIFY(std::abs(report.reached - report.asked) < 1e-3 * report.asked);
    QVERIFY(std::abs(boundsOf(sculptor.mesh()).max().z() - before - report.reached) < 0.1 * report.reached);
    QVERIFY(report.touchedVertices > 20 && report.touchedFaces > report.touchedVertices && report.substeps >= 1);
    QVERIFY(report.totalMs >= report.verifyMs && report.verifyMs > 0);
}

void TestSculptor::hook_runsBetweenSubsteps()
{
    Sculptor sculptor(sculptable(core::icosphere(3, 1)));
    std::uint32_t calls = 0;
    bool valid = true;
    sculptor.setBetweenSubsteps([&] {
        ++calls;
        valid = valid && mesh_asserts::badFaces(sculptor.mesh()).empty();
    });
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 0.3, 5});
    QVERIFY(report.substeps > 1);
    QVERIFY(valid && calls > 1 && calls <= report.substeps); // a transaction may contain several sub-steps
}

void TestSculptor::rehearsal_leavesNoTrace()
{
    for (const core::TriangleMesh& shape : {core::icosphere(4, 1), clay::bowl(), shapes::cube(1)}) {
        const std::unique_ptr<core::Mesh> untouched = sculptable(shape);
        Sculptor sculptor(sculptable(shape));
        QCOMPARE(sculptor.mesh().stateHash(), untouched->stateHash());
        QVERIFY(sculptor.indexIsConsistent());
        QVERIFY(sculptor.takePatch().vertexSpans.empty());
    }
}

FETTLE_TEST(TestSculptor)
#include "tst_sculptor.moc"
