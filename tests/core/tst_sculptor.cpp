// The promise under random and under meant strokes: after every dab the mesh is valid and the index right, undo and redo
// give the same bits, and what can be done is done.
//
// FETTLE_SOAK=1: a million dabs. FETTLE_SEED=n: another seed. FETTLE_DABS=n: another number of dabs. FETTLE_TRACE=1: says
// what each dab did.

#include "core/sculptor.h"
#include "core/mesh_hash.h"
#include "core/worker_pool.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"

#include <QTest>

#include <iostream>
#include <sstream>

namespace
{
using core::DabOutcome;
using core::DabReport;
using core::Mesh;
using core::MeshDelta;
using core::Sculptor;
using core::Slot;
using core::Stroke;
using core::Tool;
using core::TriangleMesh;
using core::Vec3;
using mesh_asserts::sculptable;

constexpr core::Slot mostFaces = 10'000; ///< a run whose mesh has grown past this ends: more would only take longer
constexpr core::Slot leastFaces = 64;     ///< so does one that has pushed nearly all of it away
constexpr int dabsPerPairCheck = 8, dabsPerJudge = 100;

#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr std::uint64_t usualDabs = 3'000;
#else
constexpr std::uint64_t usualDabs = 300; // 5 to 30 times slower
#endif

struct NamedShape
{
    const char* name;
    TriangleMesh mesh;
};

std::vector<NamedShape> fuzzShapes()
{
    return {{"sphere", core::icosphere(3, 1)},
            {"torus", shapes::torus()},
            {"thinSlab", clay::slab(2, 0.05, 12)},
            {"speck", shapes::together(core::icosphere(2, 1), shapes::moved(core::icosphere(0, 0.02), {1.06f, 0, 0}))},
            {"twoFingers", clay::twoFingers(0.01)},
            {"nestedShells", shapes::nestedSpheres(true)},
            {"bowl", clay::bowl()},
            {"specksInside", shapes::together(core::icosphere(3, 1),
                                              shapes::together(shapes::reversed(shapes::moved(core::icosphere(0, 0.02), {0, 0.95f, 0})),
                                                               shapes::reversed(shapes::moved(core::icosphere(1, 0.05), {0.7f, 0, 0.5f}))))}};
}

struct Tally
{
    std::uint64_t dabs = 0, committed = 0, careful = 0, endedEarly = 0, empty = 0, whole = 0, judged = 0;
    std::uint64_t strokes = 0, runs = 0;
    std::uint64_t digest = 0; ///< of all end states: the same on every machine and in every build
    std::array<std::uint64_t, 3> tiers{};
    std::uint64_t fusions = 0, separations = 0;

    void add(const DabReport& report)
    {
        ++dabs;
        committed += report.outcome == DabOutcome::Committed;
        careful += report.outcome == DabOutcome::Careful;
        endedEarly += report.outcome == DabOutcome::EndedEarly;
        empty += report.outcome == DabOutcome::Empty;
        whole += report.outcome != DabOutcome::Empty && report.reached >= 0.95 * report.asked;
    }

    void print() const
    {
        const auto percent = [this](std::uint64_t n) { return 100.0 * static_cast<double>(n) / static_cast<double>(dabs - empty); };
        std::cout << "fuzzer: " << dabs << " dabs, " << strokes << " strokes, " << runs << " runs, " << judged << " CGAL checks; "
                  << committed << " committed (" << percent(committed) << " %), " << careful << " careful (" << percent(careful)
                  << " %), " << endedEarly << " ended early (" << percent(endedEarly) << " %), " << empty << " empty; " << whole
                  << " reached 95 % of what was asked (" << percent(whole) << " %); proved by patch, stars, pairs: " << tiers[0]
                  << " " << tiers[1] << " " << tiers[2] << "; " << fusions << " fusions, " << separations << " separations; digest " << std::hex << digest << std::dec << std::endl;
    }
};

/// One mesh, sculpted at random until the dabs are used up or it has grown large.
class FuzzRun
{
public:
    FuzzRun(const NamedShape& shape, std::uint64_t seed, Tally& tally)
        : m_shape(shape), m_fuzzer(seed), m_tally(tally), m_sculptor(sculptable(shape.mesh)), m_where(shape.name)
    {
        m_where += ", seed " + std::to_string(seed);
    }

    void go(std::uint64_t dabs)
    {
        ++m_tally.runs;
        judge("at the start");
        m_start = m_sculptor.mesh().stateHash();
        const std::uint64_t end = m_tally.dabs + dabs;
        while (m_tally.dabs < end && m_sculptor.mesh().live().faces < mostFaces && m_sculptor.mesh().live().faces >= leastFaces && ok()) {
            if (m_fuzzer.below(8) == 0 && !m_undo.empty())
                undoForGood();
            sculpt(m_fuzzer.stroke(m_sculptor.mesh()));
        }
        if (!ok())
            return;
        checkAll("at the end");
        walkHistory();
        replay();
        m_tally.digest = m_tally.digest * 31 + m_sculptor.mesh().stateHash();
        for (std::size_t i = 0; i < 3; ++i)
            m_tally.tiers[i] += m_sculptor.totals().verifyTiers[i];
        m_tally.fusions += m_sculptor.totals().fusions;
        m_tally.separations += m_sculptor.totals().separations;
    }

    bool ok() const { return m_problem.empty(); }
    const std::string& problem() const { return m_problem; }

private:
    void fail(const std::string& what)
    {
        if (!m_problem.empty())
            return;
        std::ostringstream text;
        text << m_where << ", stroke " << m_strokes.size() << ", dab " << m_dabs << ": " << what;
        m_problem = text.str();
    }

    void sculpt(const Stroke& stroke)
    {
        ++m_tally.strokes;
        m_strokes.push_back(stroke);
        m_sculptor.beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples) {
            for (const DabReport& report : m_sculptor.addSample(sample)) {
                m_tally.add(report);
                ++m_dabs;
                if (m_trace)
                    trace(stroke, report);
            }
            checkAfterSample();
        }
        m_undo.push_back(m_sculptor.endStroke());
        m_states.push_back(m_sculptor.mesh().stateHash());
        if (m_sculptor.mesh().meshHash() != wholeHash(m_sculptor.mesh()))
            fail("the mesh hash is not that of the faces");
    }

    void trace(const Stroke& stroke, const DabReport& report) const
    {
        const core::StrokeSettings& s = stroke.settings;
        std::cout << m_where << ", stroke " << m_strokes.size() << ", dab " << m_dabs << ": " << name(s.tool) << ' '
                  << name(s.place) << " radius " << s.radius << " strength " << s.strength << " falloff " << s.falloff
                  << " detail " << s.detail << ": " << name(report.outcome) << ", " << report.touchedVertices << " vertices, "
                  << report.substeps << " sub-steps, " << report.reached << " of " << report.asked << ", " << report.totalMs
                  << " ms, fuse " << report.fuseMs << " ms, verify " << report.verifyMs << " ms, optimise " << report.optimiseMs << " ms, model "
                  << m_sculptor.mesh().live().faces << " faces" << std::endl;
    }

    /// What was undone is forgotten, and other strokes follow.
    void undoForGood()
    {
        m_sculptor.swap(m_undo.back());
        m_undo.pop_back();
        m_strokes.pop_back();
        m_states.pop_back();
        if (!m_sculptor.indexIsConsistent())
            fail("the octree is wrong after an undo");
    }

    void checkAfterSample()
    {
        if (!m_sculptor.indexIsConsistent())
            fail("the octree is wrong");
        if (m_dabs >= m_nextPairCheck) {
            m_nextPairCheck = m_dabs + dabsPerPairCheck;
            checkPairs("now");
        }
        if (m_dabs >= m_nextJudge) {
            m_nextJudge = m_dabs + dabsPerJudge;
            judge("now");
        }
    }

    void checkPairs(const char* when)
    {
        if (const std::string broken = mesh_asserts::brokenLinks(m_sculptor.mesh()); !broken.empty())
            fail(std::string("broken links ") + when + ": " + broken);
        else if (const auto bad = mesh_asserts::badFaces(m_sculptor.mesh()); !bad.empty())
            fail(std::to_string(bad.size()) + " bad faces " + when + ", the first " + std::to_string(bad.front()));
    }

    void judge(const char* when)
    {
        ++m_tally.judged;
        const std::string verdict = mesh_asserts::unsoundness(m_sculptor.mesh());
        if (!verdict.empty())
            fail(std::string("judged ") + when + ": " + verdict);
    }

    void checkAll(const char* when)
    {
        checkPairs(when);
        judge(when);
        if (!m_sculptor.indexIsConsistent())
            fail(std::string("the octree is wrong ") + when);
    }

    void walkHistory()
    {
        const std::uint64_t end = m_sculptor.mesh().stateHash();
        for (auto delta = m_undo.rbegin(); delta != m_undo.rend(); ++delta)
            m_sculptor.swap(*delta);
        if (m_sculptor.mesh().stateHash() != m_start)
            fail("undoing everything does not lead to the start");
        if (!m_sculptor.indexIsConsistent())
            fail("the octree is wrong after undoing everything");
        for (MeshDelta& delta : m_undo)
            m_sculptor.swap(delta);
        if (m_sculptor.mesh().stateHash() != end)
            fail("redoing everything does not lead to the end");
        if (!m_sculptor.indexIsConsistent())
            fail("the octree is wrong after redoing everything");
    }

    /// The same strokes, without what was undone in between.
    void replay()
    {
        Sculptor again(sculptable(m_shape.mesh));
        for (std::size_t i = 0; i < m_strokes.size(); ++i) {
            const Stroke& stroke = m_strokes[i];
            again.beginStroke(stroke.settings);
            for (const core::StrokeSample& sample : stroke.samples)
                again.addSample(sample);
            again.endStroke();
            if (again.mesh().stateHash() != m_states[i]) {
                fail("the same strokes give another mesh from stroke " + std::to_string(i + 1) + " of " +
                     std::to_string(m_strokes.size()) + " on");
                return;
            }
        }
    }

    const NamedShape& m_shape;
    StrokeFuzzer m_fuzzer;
    Tally& m_tally;
    Sculptor m_sculptor;
    std::string m_where, m_problem;
    std::vector<Stroke> m_strokes;
    std::vector<std::uint64_t> m_states; ///< after each of them
    std::vector<MeshDelta> m_undo;
    std::uint64_t m_start = 0;
    bool m_trace = qEnvironmentVariableIsSet("FETTLE_TRACE");
    int m_dabs = 0, m_nextPairCheck = 0, m_nextJudge = dabsPerJudge;
};

std::uint64_t numberFromEnvironment(const char* name, std::uint64_t otherwise)
{
    bool isNumber = false;
    const std::uint64_t value = qEnvironmentVariable(name).toULongLong(&isNumber);
    return isNumber ? value : otherwise;
}
} // namespace

class TestSculptor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomStrokes_keepThePromise();
    void undoneStrokes_leaveNoTraceInMirroredOnes();
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

/// A stroke of one dab.
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

void TestSculptor::randomStrokes_keepThePromise()
{
    const bool soak = qEnvironmentVariableIntValue("FETTLE_SOAK") != 0;
    const std::uint64_t dabs = numberFromEnvironment("FETTLE_DABS", soak ? 1'000'000 : usualDabs);
    const std::uint64_t seed = numberFromEnvironment("FETTLE_SEED", 20240812);
    const std::vector<NamedShape> shapes = fuzzShapes();
    Tally tally;
    for (std::uint64_t run = 0; tally.dabs < dabs; ++run) {
        FuzzRun fuzz(shapes[run % shapes.size()], seed + run, tally);
        fuzz.go(std::min<std::uint64_t>(400, dabs - tally.dabs));
        if (!fuzz.ok())
            tally.print();
        QVERIFY2(fuzz.ok(), fuzz.problem().c_str());
    }
    tally.print();
}

/// Shrunk from a run that failed: what the octree finds beyond the brush once decided where a mirrored dab refines.
void TestSculptor::undoneStrokes_leaveNoTraceInMirroredOnes()
{
    const std::vector<NamedShape> shapes = fuzzShapes();
    const auto fingers = std::ranges::find(shapes, std::string("twoFingers"), &NamedShape::name);
    Tally tally;
    FuzzRun fuzz(*fingers, 20240872, tally);
    fuzz.go(20);
    QVERIFY2(fuzz.ok(), fuzz.problem().c_str());
}

void TestSculptor::pushThroughASlab_withoutFusion_stopsAtContact()
{
    Sculptor sculptor(sculptable(clay::slab(2, 0.1, 16)));
    bool stopped = false;
    for (int i = 0; i < 20; ++i) {
        const auto above = sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}});
        QVERIFY(above);
        const DabReport report = dabOnce(sculptor, {.tool = Tool::Push, .position = above->position, .radius = 0.4, .strength = 2, .fusion = false});
        stopped = stopped || report.outcome == DabOutcome::EndedEarly || report.reached < 0.95 * report.asked;
        VERIFY_VALID(sculptor.mesh());
        QVERIFY(sculptor.indexIsConsistent());
        QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 2);
    }
    QVERIFY(stopped); // 20 x 0.08 would go through 0.1 many times over
}

void TestSculptor::fingersPulledTogether_withoutFusion_stopAtContact()
{
    Sculptor sculptor(sculptable(clay::twoFingers(0.2)));
    for (int i = 0; i < 12; ++i) {
        for (double side : {-1.0, 1.0}) {
            const auto facing = sculptor.hit({{0, 0.01, 0.02}, {side, 0, 0}});
            if (!facing)
                continue; // the point between them has been grown over
            dabOnce(sculptor, {.tool = Tool::Pull, .position = facing->position, .radius = 0.3, .fusion = false});
            VERIFY_VALID(sculptor.mesh());
            QCOMPARE(mesh_asserts::eulerNumber(sculptor.mesh()), 4);
        }
    }
    const auto left = sculptor.hit({{-0.1, 0.01, 0.02}, {1, 0, 0}}), right = sculptor.hit({{0.1, 0.01, 0.02}, {-1, 0, 0}});
    QVERIFY(!left || !right || (left->position - right->position).norm() < 0.1); // they came near before they stopped
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
    const DabReport away = dabOnce(sculptor, {.tool = Tool::Pull, .position = above->position, .radius = 0.4, .fusion = false});
    QVERIFY(away.outcome == DabOutcome::Committed || away.outcome == DabOutcome::Careful);
    QVERIFY(away.reached >= 0.95 * away.asked);
    const auto after = sculptor.hit({{0.03, 1, 0.02}, {0, -1, 0}});
    QVERIFY(after && after->position.y() > above->position.y() + 0.02); // 0.04 at the peak
    VERIFY_VALID(sculptor.mesh());
}

/// Large dabs of each tool, and one that crumples, so that each step of a dab has work for several threads.
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
                patches = patches * 31 + static_cast<std::uint8_t>(v.normal[0]) + static_cast<std::uint8_t>(v.normal[2]);
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
    const core::Lattice tight(23); // the working volume is the sphere's own box
    Sculptor sculptor(sculptable(core::icosphere(3, 1), tight));
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 0.3, 3});
    QVERIFY(report.outcome == DabOutcome::EndedEarly || report.reached < report.asked);
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
Q_DECLARE_METATYPE(Spoil)

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

    core::StrokeSettings sound; // the next stroke is none the worse
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
    for (int i = 0; i < 1'000'000; ++i) { // a hand that waves in the air and touches the surface now and then
        sample.position = {0, 1e-6 * i, i % 10'000 == 0 ? 1.0 : 3.0};
        QCOMPARE(sculptor.addSample(sample).size(), std::size_t(1));
    }
    MeshDelta delta = sculptor.endStroke();
    QVERIFY(!delta.empty());
    VERIFY_VALID(sculptor.mesh());
    sculptor.swap(delta);
    QCOMPARE(sculptor.mesh().stateHash(), start);
}

/// A fine brush over a coarse model: the operations of a sub-step are capped.
void TestSculptor::tooManyOperations_endTheDab()
{
    Sculptor sculptor(sculptable(core::icosphere(1, 1)));
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 2, 1, 0.05});
    QVERIFY(report.outcome == DabOutcome::EndedEarly && report.reached < report.asked);
    VERIFY_VALID(sculptor.mesh());
}

/// Fine, wide and strong at once: hundreds of sub-steps of tens of thousands of vertices.
void TestSculptor::tooManyMoves_endTheDab()
{
    Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    sculptor.setVerification(false); // it would only take longer
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 2, 10, 0.05});
    QVERIFY(report.outcome == DabOutcome::EndedEarly && report.substeps > 10);
    QVERIFY(report.reached > 0 && report.reached < report.asked);
    VERIFY_LINKED(sculptor.mesh());
}

/// The strokes of the speed comparison: along a great circle, 0.02 radius a dab.
void TestSculptor::peersStroke_commitsOnTheStraightPath()
{
    Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    core::StrokeSettings settings;
    settings.radius = 0.25;
    settings.strength = 0.2;
    sculptor.beginStroke(settings);
    int straight = 0;
    constexpr int dabs = 200;
    for (int i = 0; i < dabs; ++i) {
        const double angle = 0.126 * settings.radius * i;
        core::StrokeSample sample;
        sample.position = {std::cos(angle), 0, std::sin(angle)};
        for (const DabReport& report : sculptor.addSample(sample))
            straight += report.outcome == DabOutcome::Committed && report.reached >= 0.999 * report.asked;
        QVERIFY(sculptor.indexIsConsistent());
    }
    sculptor.endStroke();
    VERIFY_VALID(sculptor.mesh());
    QVERIFY2(straight >= 0.99 * dabs, qPrintable(QString::number(straight)));
}

void TestSculptor::reports_tellWhatTheDabDid()
{
    Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    const double before = boundsOf(sculptor.mesh()).max().z();
    const DabReport report = dabOnce(sculptor, {Tool::Pull, {0, 0, 1}, 0.25, 1});
    QVERIFY(report.outcome == DabOutcome::Committed);
    QVERIFY(report.asked > 0.0249 && report.asked <= 0.025); // 0.1 radius, at a vertex in the centre
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
    QVERIFY(valid && calls > 1 && calls <= report.substeps); // several may be one transaction
}

QTEST_APPLESS_MAIN(TestSculptor)
#include "tst_sculptor.moc"
