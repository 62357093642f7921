// Tests mirrored sculpting: a symmetric model stays symmetric bit for bit under any stroke, even one across the plane.
//
// FETTLE_SEED=n: another seed. FETTLE_DABS=n: number of dabs for each shape and plane.

#include "core/analysis/surface_distance.h"
#include "core/operations/model_command.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/effort.h"
#include "tests/support/environment.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <iostream>
#include <iterator>

using clay::dabOnce;
using clay::stroke;
using clay::unitBall;
using core::Dab;
using core::DabOutcome;
using core::DabReport;
using core::Mesh;
using core::MeshDelta;
using core::Sculptor;
using core::Slot;
using core::StrokeSettings;
using core::Symmetry;
using core::Tool;
using core::Vec3;
using mesh_asserts::sculptable;
using mirror_asserts::asymmetry;

namespace
{
constexpr Slot minFaces = 12, maxFaces = 10'000; ///< a run ends if its mesh is smaller or larger

core::TriangleMesh symmetrized(const core::TriangleMesh& shape, Symmetry plane)
{
    const auto mesh = sculptable(shape);
    core::ModelChange change = applyToCopy(*mesh, core::Symmetrize{plane});
    mesh->swap(change.delta);
    return mesh_asserts::surfaceOf(*mesh);
}

struct Tally
{
    std::uint64_t dabs = 0, fallback = 0, endedEarly = 0, empty = 0, whole = 0, fusions = 0, separations = 0;

    void add(const DabReport& report)
    {
        ++dabs;
        fallback += report.outcome == DabOutcome::Fallback;
        endedEarly += report.outcome == DabOutcome::EndedEarly;
        empty += report.outcome == DabOutcome::Empty;
        whole += report.outcome != DabOutcome::Empty && report.reached >= 0.95 * report.asked;
    }

    void print() const
    {
        std::cout << dabs << " dabs: " << fallback << " careful, " << endedEarly << " ended early, " << empty
                  << " empty, " << whole << " reached 95 % of what was asked; " << fusions << " fusions, "
                  << separations << " separations" << std::endl;
    }
};

/// Sculpts a symmetric mesh at random about its plane until it has grown large, checks it, undoes and redoes
/// everything.
class MirrorRun
{
public:
    MirrorRun(const core::TriangleMesh& shape, Symmetry plane, std::uint64_t seed)
        : m_sculptor(sculptable(shape))
        , m_plane(plane)
        , m_fuzzer(seed)
        , m_where("seed " + std::to_string(seed))
    {}

    void go(std::uint64_t dabs, Tally& tally)
    {
        checkSymmetry();
        const std::uint64_t start = m_sculptor.mesh().stateHash(), end = tally.dabs + dabs;
        const auto faces = [&] { return m_sculptor.mesh().live().faces; };
        while (tally.dabs < end && faces() >= minFaces && faces() < maxFaces && m_problem.empty()) {
            sculpt(tally);
            if (m_fuzzer.below(8) == 0) {
                m_sculptor.swap(m_history.back());
                m_history.pop_back();
                checkSymmetry();
            }
        }
        if (m_problem.empty())
            fail(mesh_asserts::unsoundness(m_sculptor.mesh()));
        walkHistory(start);
        tally.fusions += m_sculptor.totals().fusions;
        tally.separations += m_sculptor.totals().separations;
    }

    const std::string& problem() const { return m_problem; }

private:
    void fail(const std::string& what)
    {
        if (m_problem.empty() && !what.empty())
            m_problem = m_where + ", dab " + std::to_string(m_dabs) + ": " + what;
    }

    void checkSymmetry() { fail(asymmetry(m_sculptor.mesh(), m_plane)); }

    void sculpt(Tally& tally)
    {
        core::Stroke stroke = m_fuzzer.stroke(m_sculptor.mesh());
        stroke.settings.symmetry = m_plane;
        m_sculptor.beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples) {
            for (const DabReport& report : m_sculptor.addSample(sample)) {
                ++m_dabs;
                tally.add(report);
                if (report.asymmetric)
                    fail("taken for asymmetric");
            }
            checkSymmetry();
            if (!m_sculptor.indexIsConsistent())
                fail("the octree is wrong");
        }
        m_history.push_back(m_sculptor.endStroke());
        fail(mesh_asserts::brokenLinks(m_sculptor.mesh()));
    }

    void walkHistory(std::uint64_t start)
    {
        const std::uint64_t end = m_sculptor.mesh().stateHash();
        for (auto delta = m_history.rbegin(); delta != m_history.rend(); ++delta)
            m_sculptor.swap(*delta);
        if (m_sculptor.mesh().stateHash() != start)
            fail("undoing everything does not lead to the start");
        for (MeshDelta& delta : m_history)
            m_sculptor.swap(delta);
        if (m_sculptor.mesh().stateHash() != end)
            fail("redoing everything does not lead to the end");
    }

    Sculptor m_sculptor;
    Symmetry m_plane;
    StrokeFuzzer m_fuzzer;
    std::vector<MeshDelta> m_history;
    std::uint64_t m_dabs = 0;
    std::string m_where, m_problem;
};
} // namespace

class TestMirrorMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomStrokes_keepTheSymmetry_data();
    void randomStrokes_keepTheSymmetry();
    void eitherSide_givesTheSameBits();
    void dabAcrossThePlane_movesNothingOffIt();
    void dabAwayFromThePlane_isTwoDabs();
    void strokeAwayFromThePlane_isTheStrokeAlone_data();
    void strokeAwayFromThePlane_isTheStrokeAlone();
    void edgeAcrossThePlane_isPartedOnIt();
    void paint_coloursBothSides();
    void asymmetricModel_getsBothDabs();
    void asymmetricModel_onThePlane_getsOneDab();
    void addedSphere_comesWithItsImage();
    void addedSphere_onThePlane_isItsOwnImage();
    void joinedSphere_onThePlane_isItsOwnImage();
    void joinedSphere_wideAsTheModel_isItsOwnImage();
    void addedSphere_touchingItsImageIsRefused();
    void fingers_joinAcrossThePlane();
    void fingers_joinAlongThePlane();
    void wall_isPiercedAtThePlane();
    void neck_partsAtThePlane();
};

void TestMirrorMap::randomStrokes_keepTheSymmetry_data()
{
    QTest::addColumn<core::TriangleMesh>("shape");
    QTest::addColumn<Symmetry>("plane");
    for (const Symmetry plane : {Symmetry::X, Symmetry::Y, Symmetry::Z}) {
        const auto row = [&](const char* shape) -> QTestData& {
            return QTest::newRow((std::string(shape) + " at " + std::string(name(plane)) + " = 0").c_str());
        };
        row("sphere") << core::icosphere(3, 1) << plane;
        row("icosahedron") << core::icosphere(0, 1) << plane; // has edges across the plane
        row("two fingers") << clay::twoFingers(0.01) << plane;
        row("torus") << symmetrized(shapes::torus(), plane) << plane;
        row("slab") << symmetrized(clay::slab(2, 0.05, 12), plane) << plane;
        row("bowl") << symmetrized(clay::bowl(), plane) << plane;
    }
}

void TestMirrorMap::randomStrokes_keepTheSymmetry()
{
    QFETCH(core::TriangleMesh, shape);
    QFETCH(Symmetry, plane);
    const std::uint64_t dabs = numberFromEnvironment("FETTLE_DABS", isSlowBuild ? 15u : byEffort(15u, 60u));
    Tally tally;
    for (std::uint64_t seed = numberFromEnvironment("FETTLE_SEED", 1); tally.dabs < dabs; ++seed) {
        MirrorRun run(shape, plane, seed);
        run.go(dabs - tally.dabs, tally);
        QVERIFY2(run.problem().empty(), run.problem().c_str());
    }
    tally.print();
}

namespace
{
StrokeSettings mirroredSettings(Tool tool, double radius = 0.3)
{
    StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radius;
    settings.symmetry = Symmetry::X;
    return settings;
}

/// Returns the largest distance from the origin of vertices whose unit direction differs from `direction` by less than
/// 0.25.
double reachIn(const Mesh& mesh, const Vec3& direction)
{
    double farthest = 0;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        const Vec3 p = mesh.point(v).cast<double>();
        if (mesh.isVertex(v) && (p.normalized() - direction.normalized()).norm() < 0.25)
            farthest = std::max(farthest, p.norm());
    }
    return farthest;
}

const Vec3 aside = Vec3(0.7, 0.4, 0.6).normalized(), image(-aside.x(), aside.y(), aside.z());
} // namespace

void TestMirrorMap::eitherSide_givesTheSameBits()
{
    for (const Tool tool : {Tool::Pull, Tool::Push, Tool::Flatten, Tool::Smooth, Tool::Paint}) {
        const auto left = unitBall(), right = unitBall();
        const Vec3 near(0.1, 0.6, 0.8); // the brush sphere crosses the plane
        dabOnce(*right, mirroredSettings(tool), near);
        dabOnce(*left, mirroredSettings(tool), {-near.x(), near.y(), near.z()});
        QCOMPARE(left->mesh().stateHash(), right->mesh().stateHash());
    }
}

void TestMirrorMap::dabAcrossThePlane_movesNothingOffIt()
{
    const auto sculptor = unitBall();
    const DabReport report = dabOnce(*sculptor, mirroredSettings(Tool::Pull), {0.1, 0, 1});
    QCOMPARE(core::name(report.outcome), core::name(DabOutcome::Committed));
    QVERIFY(!report.asymmetric);
    QVERIFY(report.asked > 0.01 && report.asked < 0.031); // the two overlapping dabs must not move the surface twice
    const Mesh& mesh = sculptor->mesh();
    Slot lifted = 0;
    for (Slot v = 0; v < mesh.slots().vertices; ++v)
        lifted += mesh.isVertex(v) && mesh.point(v).x() == 0 && mesh.point(v).norm() > 1.01;
    QVERIFY(lifted >= 3);
    VERIFY_SYMMETRIC(mesh, Symmetry::X);
    VERIFY_VALID(mesh);
}

void TestMirrorMap::dabAwayFromThePlane_isTwoDabs()
{
    const auto sculptor = unitBall(), plain = unitBall();
    StrokeSettings settings = mirroredSettings(Tool::Pull);
    const DabReport both = dabOnce(*sculptor, settings, aside);
    settings.symmetry = Symmetry::None;
    const DabReport one = dabOnce(*plain, settings, aside);
    QCOMPARE(both.touchedVertices, 2 * one.touchedVertices);
    QCOMPARE(both.asked, one.asked);
    QVERIFY(std::abs(reachIn(sculptor->mesh(), aside) - reachIn(plain->mesh(), aside)) < 1e-3);
    QVERIFY(reachIn(sculptor->mesh(), image) == reachIn(sculptor->mesh(), aside));
    QVERIFY(reachIn(plain->mesh(), image) < 1.001);
    VERIFY_SYMMETRIC(sculptor->mesh(), Symmetry::X);
}

void TestMirrorMap::strokeAwayFromThePlane_isTheStrokeAlone_data()
{
    QTest::addColumn<Tool>("tool");
    QTest::addColumn<core::BrushShape>("brush");
    for (const Tool tool : {Tool::Pull, Tool::Push, Tool::Inflate, Tool::Clay, Tool::Layer, Tool::Flatten, Tool::Scrape,
                            Tool::Smooth, Tool::Pinch, Tool::Crease, Tool::Grab, Tool::SnakeHook, Tool::Twist}) {
        for (const core::BrushShape brush : {core::BrushShape::Sphere, core::BrushShape::Ray})
            QTest::addRow("%s, %s", core::name(tool).data(), core::name(brush).data()) << tool << brush;
    }
}

/// Snake Hook used to leave spikes at its root: vertices that the refinement had added moved by the mirrored motion.
void TestMirrorMap::strokeAwayFromThePlane_isTheStrokeAlone()
{
    QFETCH(Tool, tool);
    QFETCH(core::BrushShape, brush);
    StrokeSettings settings = mirroredSettings(tool, 0.2);
    settings.brush = brush;
    std::vector<Vec3> path;
    for (int i = 0; i < 20; ++i)
        path.push_back(isDragTool(tool) ? Vec3((1 + 0.02 * i) * aside)
                                        : Vec3((aside + 0.02 * i * Vec3::UnitY()).normalized()));
    const auto both = unitBall(), alone = unitBall();
    stroke(*both, settings, path);
    settings.symmetry = Symmetry::None;
    stroke(*alone, settings, path);
    const core::TriangleMesh one = mesh_asserts::surfaceOf(both->mesh()),
                             other = mesh_asserts::surfaceOf(alone->mesh());
    for (const auto& [from, to] : {std::pair(&one, &other), std::pair(&other, &one)}) {
        std::vector<core::Vec3f> points;
        std::ranges::copy_if(from->points, std::back_inserter(points),
                             [](const core::Vec3f& p) { return p.x() > 0.1; });
        const float farthest = std::ranges::max(core::distancesTo(*to, points));
        QVERIFY2(farthest < 0.015, qPrintable(QString::number(farthest)));
    }
    VERIFY_SYMMETRIC(both->mesh(), Symmetry::X);
    VERIFY_VALID(both->mesh());
}

void TestMirrorMap::edgeAcrossThePlane_isPartedOnIt()
{
    Sculptor sculptor(sculptable(core::icosphere(0, 1)));
    const auto across = [&] {
        Slot edges = 0;
        const Mesh& mesh = sculptor.mesh();
        for (Slot e = 0; e < mesh.slots().edges; ++e)
            edges += mesh.isEdge(e) && mesh.point(mesh.to(2 * e)).x() * mesh.point(mesh.to(2 * e + 1)).x() < 0;
        return edges;
    };
    QCOMPARE(across(), 2u);
    const Slot v = sculptor.mesh().isVertex(0) ? 0 : 1;
    const DabReport report =
        dabOnce(sculptor, mirroredSettings(Tool::Smooth, 3), sculptor.mesh().point(v).cast<double>());
    QVERIFY(!report.asymmetric && report.outcome != DabOutcome::Empty);
    QCOMPARE(across(), 0u);
    VERIFY_SYMMETRIC(sculptor.mesh(), Symmetry::X);
    VERIFY_VALID(sculptor.mesh());
}

void TestMirrorMap::paint_coloursBothSides()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = mirroredSettings(Tool::Paint);
    settings.color = {255, 0, 0};
    const std::uint64_t before = sculptor->mesh().live().vertices;
    const DabReport report = dabOnce(*sculptor, settings, {0.2, 0, 1});
    std::uint32_t painted = 0, left = 0;
    for (Slot v = 0; v < sculptor->mesh().slots().vertices; ++v) {
        const bool isPainted = sculptor->mesh().isVertex(v) && sculptor->mesh().color(v) != core::Rgb();
        painted += isPainted;
        left += isPainted && sculptor->mesh().point(v).x() < 0;
    }
    QVERIFY(left > 10 && painted > 2 * left && painted <= report.touchedVertices);
    QCOMPARE(sculptor->mesh().live().vertices, before);
    VERIFY_SYMMETRIC(sculptor->mesh(), Symmetry::X);
}

void TestMirrorMap::asymmetricModel_getsBothDabs()
{
    Sculptor sculptor(sculptable(shapes::noisy(core::icosphere(4, 1), 0.004f, 3)));
    QVERIFY(!asymmetry(sculptor.mesh(), Symmetry::X).empty());
    const double right = reachIn(sculptor.mesh(), aside), left = reachIn(sculptor.mesh(), image);
    const DabReport report = dabOnce(sculptor, mirroredSettings(Tool::Pull), aside);
    QVERIFY(report.asymmetric);
    QCOMPARE(core::name(report.outcome), core::name(DabOutcome::Committed));
    QVERIFY(reachIn(sculptor.mesh(), aside) > right + 0.02 && reachIn(sculptor.mesh(), image) > left + 0.02);
    VERIFY_VALID(sculptor.mesh());
}

void TestMirrorMap::asymmetricModel_onThePlane_getsOneDab()
{
    Sculptor mirrored(sculptable(shapes::noisy(core::icosphere(4, 1), 0.004f, 3)));
    Sculptor plain(sculptable(shapes::noisy(core::icosphere(4, 1), 0.004f, 3)));
    StrokeSettings settings = mirroredSettings(Tool::Pull);
    dabOnce(mirrored, settings, {0, 0.6, 0.8});
    settings.symmetry = Symmetry::None;
    dabOnce(plain, settings, {0, 0.6, 0.8});
    QCOMPARE(mirrored.mesh().stateHash(), plain.mesh().stateHash());
}

void TestMirrorMap::addedSphere_comesWithItsImage()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = mirroredSettings(Tool::Pull);
    settings.add = true;
    const DabReport report = dabOnce(*sculptor, settings, 1.7 * image);
    QCOMPARE(core::name(report.outcome), core::name(DabOutcome::Added));
    QCOMPARE(mesh_asserts::eulerNumber(sculptor->mesh()), 6);
    VERIFY_SYMMETRIC(sculptor->mesh(), Symmetry::X);
    VERIFY_VALID(sculptor->mesh());
    dabOnce(*sculptor, settings, 1.9 * image);
    VERIFY_SYMMETRIC(sculptor->mesh(), Symmetry::X);
}

void TestMirrorMap::addedSphere_onThePlane_isItsOwnImage()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = mirroredSettings(Tool::Pull);
    settings.add = true;
    QCOMPARE(core::name(dabOnce(*sculptor, settings, {0, 0.3, 1.9}).outcome), core::name(DabOutcome::Added));
    QCOMPARE(mesh_asserts::eulerNumber(sculptor->mesh()), 4);
    VERIFY_SYMMETRIC(sculptor->mesh(), Symmetry::X);
}

void TestMirrorMap::joinedSphere_onThePlane_isItsOwnImage()
{
    const auto sculptor = unitBall();
    StrokeSettings settings = mirroredSettings(Tool::Pull);
    settings.add = settings.join = true;
    for (const Vec3& place : {Vec3(0, 0.3, 1), Vec3(0, -1, 0.2), Vec3(0, 0.2, 1.25)}) {
        const DabReport report = dabOnce(*sculptor, settings, place);
        QCOMPARE(core::name(report.outcome), core::name(DabOutcome::Added));
        QVERIFY(!report.asymmetric);
        QCOMPARE(mesh_asserts::eulerNumber(sculptor->mesh()), 2);
        VERIFY_SYMMETRIC(sculptor->mesh(), Symmetry::X);
        VERIFY_VALID(sculptor->mesh());
    }
}

/// The ball cuts a wall that is parallel to the plane: faces in parallel planes must not count as faces in the plane.
void TestMirrorMap::joinedSphere_wideAsTheModel_isItsOwnImage()
{
    Sculptor sculptor(sculptable(symmetrized(clay::slab(1, 1, 10), Symmetry::X)));
    StrokeSettings settings = mirroredSettings(Tool::Pull, 0.7);
    settings.add = settings.join = true;
    const DabReport report = dabOnce(sculptor, settings, {0, 0.3, 0});
    QCOMPARE(core::name(report.outcome), core::name(DabOutcome::Added));
    QVERIFY(!report.asymmetric);
    VERIFY_SYMMETRIC(sculptor.mesh(), Symmetry::X);
    VERIFY_VALID(sculptor.mesh());
}

void TestMirrorMap::addedSphere_touchingItsImageIsRefused()
{
    const auto sculptor = unitBall();
    const std::uint64_t before = sculptor->mesh().stateHash();
    StrokeSettings settings = mirroredSettings(Tool::Pull);
    settings.add = true;
    const DabReport report = dabOnce(*sculptor, settings, {0.31, 0.3, 1.9});
    QVERIFY(report.outcome == DabOutcome::Refused && report.refusal == core::Refusal::TooClose);
    QCOMPARE(sculptor->mesh().stateHash(), before);
}

namespace
{
/// Repeats dabs, at most `most`, until the Euler number has changed. Returns the Euler number.
std::int64_t sculptUntilChanged(Sculptor& sculptor, const StrokeSettings& settings, const std::vector<Vec3>& path,
                                int most)
{
    const std::int64_t before = mesh_asserts::eulerNumber(sculptor.mesh());
    for (int i = 0; i < most && mesh_asserts::eulerNumber(sculptor.mesh()) == before; ++i)
        dabOnce(sculptor, settings, path[static_cast<std::size_t>(i) % path.size()]);
    return mesh_asserts::eulerNumber(sculptor.mesh());
}
} // namespace

void TestMirrorMap::fingers_joinAcrossThePlane()
{
    Sculptor sculptor(sculptable(clay::twoFingers(0.1))); // the fingers are side by side in x
    StrokeSettings settings = mirroredSettings(Tool::Pull, 0.15);
    settings.place = core::Placement::Nearest;
    QCOMPARE(sculptUntilChanged(sculptor, settings, {{0.05, 0, 0}}, 40), 2); // Euler number of one part instead of two
    VERIFY_SYMMETRIC(sculptor.mesh(), Symmetry::X);
    VERIFY_VALID(sculptor.mesh());
    QVERIFY(sculptor.totals().fusions > 0);
}

void TestMirrorMap::fingers_joinAlongThePlane()
{
    Sculptor sculptor(sculptable(clay::twoFingers(0.1)));
    StrokeSettings settings = mirroredSettings(Tool::Pull, 0.15);
    settings.symmetry = Symmetry::Z; // the plane goes through both fingers
    settings.place = core::Placement::Nearest;
    QCOMPARE(sculptUntilChanged(sculptor, settings, {{-0.05, 0, 0}, {0.05, 0, 0}}, 40), 2);
    VERIFY_SYMMETRIC(sculptor.mesh(), Symmetry::Z);
    VERIFY_VALID(sculptor.mesh());
}

void TestMirrorMap::wall_isPiercedAtThePlane()
{
    // the slab is parallel to the plane and centred on it
    Sculptor sculptor(sculptable(symmetrized(clay::slab(1, 0.1, 16), Symmetry::Y)));
    StrokeSettings settings = mirroredSettings(Tool::Push, 0.2);
    settings.symmetry = Symmetry::Y;
    settings.place = core::Placement::Nearest;
    QCOMPARE(sculptUntilChanged(sculptor, settings, {{0, 0.05, 0}}, 60), 0); // Euler number of a ring
    VERIFY_SYMMETRIC(sculptor.mesh(), Symmetry::Y);
    VERIFY_VALID(sculptor.mesh());
}

void TestMirrorMap::neck_partsAtThePlane()
{
    const std::vector<Vec3> profile = {{0, -1, 0},     {0.5, -0.9, 0}, {0.6, -0.6, 0}, {0.25, -0.2, 0}, {0.12, 0, 0},
                                       {0.25, 0.2, 0}, {0.6, 0.6, 0},  {0.5, 0.9, 0},  {0, 1, 0}};
    // a solid of revolution in the shape of an hourglass
    Sculptor sculptor(sculptable(symmetrized(clay::revolved(profile, 24), Symmetry::Y)));
    StrokeSettings settings = mirroredSettings(Tool::Push, 0.25);
    settings.symmetry = Symmetry::Y;
    QCOMPARE(sculptUntilChanged(sculptor, settings, {{0.12, 0, 0}, {-0.06, 0, 0.1}, {-0.06, 0, -0.1}}, 60),
             4); // Euler number of two parts
    VERIFY_SYMMETRIC(sculptor.mesh(), Symmetry::Y);
    VERIFY_VALID(sculptor.mesh());
}

FETTLE_TEST(TestMirrorMap, QCoreApplication)
#include "tst_mirror_map.moc"
