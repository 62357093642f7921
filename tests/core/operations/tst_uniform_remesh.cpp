#include "core/mesh/mesh_builder.h"
#include "core/mesh/surface_query.h"
#include "core/operations/model_command.h"
#include "core/operations/uniform_remesh.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace core;

namespace
{
using mesh_asserts::volumeOf;

struct Remeshed
{
    std::unique_ptr<Mesh> mesh;
    ModelChange change;
    double detail;
};

Remeshed remeshed(const TriangleMesh& shape, double timesDetail)
{
    Remeshed result{buildMesh(shape).mesh, {}, 0};
    result.detail = timesDetail * result.mesh->uniformDetail();
    result.change = applyToCopy(*result.mesh, RemeshUniformly{result.detail});
    if (result.change.changes)
        result.mesh->swap(result.change.delta);
    return result;
}

/// Returns the largest distance of a mesh from the other surface, measured at vertices, midpoints of edges and centres
/// of faces.
double farthestFrom(const Mesh& other, const Mesh& mesh)
{
    const FaceOctree octree(other);
    double farthest = 0;
    const auto look = [&](const Vec3& p) { farthest = std::max(farthest, nearestPoint(other, octree, p)->distance); };
    for (Slot f = 0; f < mesh.slots().faces; ++f) {
        if (!mesh.isFace(f))
            continue;
        std::array<Vec3, 3> p;
        std::ranges::transform(mesh.corners(f), p.begin(), [&](Slot v) { return mesh.point(v).cast<double>(); });
        look((p[0] + p[1] + p[2]) / 3);
        for (std::size_t i = 0; i < 3; ++i) {
            look(p[i]);
            look((p[i] + p[(i + 1) % 3]) / 2);
        }
    }
    return farthest;
}

/// Returns the absolute change of volume as a share of the original volume.
double volumeChange(const Remeshed& result, const TriangleMesh& shape)
{
    const double volume = checkMesh(shape).volume.value();
    return std::abs(volumeOf(*result.mesh) - volume) / volume;
}

/// Returns the distance between the surfaces, measured both ways, in units of d, the shortest edge length that
/// remeshing aims at.
double distanceApart(const Remeshed& result, const TriangleMesh& shape)
{
    const auto before = buildMesh(shape).mesh;
    const double apart = std::max(farthestFrom(*before, *result.mesh), farthestFrom(*result.mesh, *before));
    return apart / edgeBounds(result.detail).minimum;
}

/// Returns the shape remeshed uniformly to this d_detail.
TriangleMesh madeEven(const TriangleMesh& shape, double detail)
{
    return extractMesh(*remeshed(shape, detail / buildMesh(shape).mesh->uniformDetail()).mesh);
}

/// Returns a cylinder about the y axis with a sharp rim at its top and bottom.
TriangleMesh cylinder()
{
    std::vector<Vec3> profile = {{0, -1, 0}};
    for (int i = 1; i <= 16; ++i)
        profile.push_back({i / 16.0, -1, 0});
    for (int i = 1; i <= 32; ++i)
        profile.push_back({1, -1 + i / 16.0, 0});
    for (int i = 15; i >= 0; --i)
        profile.push_back({i / 16.0, 1, 0});
    return clay::revolved(profile, 96);
}
} // namespace

#define VERIFY_AT_MOST(value, most) QVERIFY2((value) <= (most), qPrintable(QStringLiteral(#value " is %1").arg(value)))

class TestUniformRemesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anyShape_staysSound_data();
    void anyShape_staysSound();
    void roundShapes_becomeUniform_data();
    void roundShapes_becomeUniform();
    void sharpShapes_keepTheirEdges_data();
    void sharpShapes_keepTheirEdges();
    void cube_keepsItsCorners();
    void thinWalls_keepTheirVolume_data();
    void thinWalls_keepTheirVolume();
    void remeshedAgainAndAgain_keepsTheVolume();
    void defaultLength_isFourThirdsOfTheMeanEdge();
    void undo_restoresTheState();
    void coloursAreCarriedThrough();
    void evenMesh_isLeftAlone();
    void sameMesh_givesTheSame();
    void tooFine_isRefused();
    void stopped_changesNothing();
};

void TestUniformRemesh::anyShape_staysSound_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<double>("timesDetail");
    for (const double times : {0.4, 1.0, 2.5}) {
        QTest::addRow("ball %g", times) << icosphere(3, 50) << times;
        QTest::addRow("cube %g", times) << shapes::cube(20) << times / 4;
        QTest::addRow("torus %g", times) << shapes::torus() << times;
        QTest::addRow("nested shells %g", times) << shapes::nestedSpheres(true) << times;
        QTest::addRow("bowl %g", times) << clay::bowl() << times;
        QTest::addRow("near fingers %g", times) << clay::twoFingers(0.0005) << times;
        QTest::addRow("thin slab %g", times) << clay::slab(2, 0.001, 8) << times;
        QTest::addRow("noisy ball %g", times) << shapes::noisy(icosphere(3, 50), 0.3f, 5) << times;
    }
}

void TestUniformRemesh::anyShape_staysSound()
{
    QFETCH(TriangleMesh, shape);
    QFETCH(double, timesDetail);
    const std::int64_t euler = mesh_asserts::eulerNumber(*buildMesh(shape).mesh);
    const Remeshed result = remeshed(shape, timesDetail);
    QVERIFY(result.change.refusal == ModelRefusal::None);
    VERIFY_VALID(*result.mesh);
    QCOMPARE(mesh_asserts::eulerNumber(*result.mesh), euler);
    QCOMPARE(evennessOf(*result.mesh, edgeBounds(result.detail)).tooLong, std::size_t(0));
}

void TestUniformRemesh::roundShapes_becomeUniform_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<double>("timesDetail");
    for (const double times : {0.3, 0.5, 0.9, 1.5, 3.0}) {
        QTest::addRow("ball %g", times) << icosphere(4, 50) << times;
        QTest::addRow("torus %g", times) << shapes::torus({3, 1, 96, 48}) << times;
        QTest::addRow("cube %g", times) << shapes::cube(20) << times / 8;
    }
}

void TestUniformRemesh::roundShapes_becomeUniform()
{
    QFETCH(TriangleMesh, shape);
    QFETCH(double, timesDetail);
    const Remeshed result = remeshed(shape, timesDetail);
    QVERIFY(result.change.refusal == ModelRefusal::None);
    const Evenness evenness = evennessOf(*result.mesh, edgeBounds(result.detail));
    QVERIFY2(evenness.isUniform(),
             qPrintable(QStringLiteral("%1 of %2 too short").arg(evenness.tooShort).arg(evenness.edges)));
    if (result.change.changes)
        QCOMPARE(result.mesh->uniformDetail(), result.detail);
    VERIFY_AT_MOST(volumeChange(result, shape), 0.01);
    if (timesDetail > 0.5) // smaller details have too many faces for this check
        VERIFY_AT_MOST(distanceApart(result, shape), 0.4);
}

void TestUniformRemesh::sharpShapes_keepTheirEdges_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<double>("detail");
    const TriangleMesh cube = madeEven(shapes::cube(20), 1), plate = madeEven(clay::slab(2, 0.2, 8), 0.05);
    for (const double detail : {3.0, 6.0})
        QTest::addRow("cube %g", detail) << cube << detail;
    for (const double detail : {0.15, 0.3})
        QTest::addRow("plate %g", detail) << plate << detail;
    for (const double detail : {0.15, 0.4})
        QTest::addRow("cylinder %g", detail) << cylinder() << detail;
}

void TestUniformRemesh::sharpShapes_keepTheirEdges()
{
    QFETCH(TriangleMesh, shape);
    QFETCH(double, detail);
    const Remeshed result = remeshed(shape, detail / buildMesh(shape).mesh->uniformDetail());
    QVERIFY(result.change.refusal == ModelRefusal::None);
    VERIFY_VALID(*result.mesh);
    VERIFY_AT_MOST(volumeChange(result, shape), 0.004);
    VERIFY_AT_MOST(distanceApart(result, shape), 0.5);
}

void TestUniformRemesh::cube_keepsItsCorners()
{
    const TriangleMesh after = madeEven(madeEven(shapes::cube(20), 1), 5);
    QVERIFY(after.triangles.size() < 1000);
    for (const Vec3f& corner : shapes::cube(20).points)
        QVERIFY(std::ranges::find(after.points, corner) != after.points.end());
}

void TestUniformRemesh::thinWalls_keepTheirVolume_data()
{
    QTest::addColumn<TriangleMesh>("shape");
    QTest::addColumn<double>("detail");
    for (const double thickness : {0.05, 0.01, 0.001}) {
        QTest::addRow("coarse plate %g", thickness) << clay::slab(2, thickness, 8) << 0.1;
        QTest::addRow("fine plate %g", thickness) << clay::slab(2, thickness, 64) << 0.1;
    }
    QTest::addRow("bowl") << clay::bowl() << 0.3;
}

void TestUniformRemesh::thinWalls_keepTheirVolume()
{
    QFETCH(TriangleMesh, shape);
    QFETCH(double, detail);
    const Remeshed result = remeshed(shape, detail / buildMesh(shape).mesh->uniformDetail());
    QVERIFY(result.change.refusal == ModelRefusal::None);
    VERIFY_VALID(*result.mesh);
    VERIFY_AT_MOST(volumeChange(result, shape), 0.01);
}

void TestUniformRemesh::remeshedAgainAndAgain_keepsTheVolume()
{
    const TriangleMesh torus = shapes::torus({3, 1, 96, 48});
    TriangleMesh shape = torus;
    for (int i = 0; i < 5; ++i)
        shape = madeEven(madeEven(shape, 0.3), 0.6);
    const double volume = checkMesh(torus).volume.value();
    VERIFY_AT_MOST(std::abs(checkMesh(shape).volume.value() - volume) / volume, 0.03);
}

void TestUniformRemesh::defaultLength_isFourThirdsOfTheMeanEdge()
{
    const auto mesh = buildMesh(shapes::torus()).mesh;
    const ModelChange unnamed = applyToCopy(*mesh, RemeshUniformly{});
    const ModelChange named = applyToCopy(*mesh, RemeshUniformly{mesh->uniformDetail()});
    QVERIFY(unnamed.changes);
    QCOMPARE(unnamed.delta.meshHash, named.delta.meshHash);
}

void TestUniformRemesh::undo_restoresTheState()
{
    for (const double times : {0.5, 2.0}) {
        const auto mesh = buildMesh(clay::bowl()).mesh;
        const std::uint64_t before = mesh->stateHash();
        ModelChange change = applyToCopy(*mesh, RemeshUniformly{times * mesh->uniformDetail()});
        QVERIFY(change.changes);
        mesh->swap(change.delta);
        const std::uint64_t after = mesh->stateHash();
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), before);
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), after);
    }
}

/// A ball red above and blue below keeps its colours, except for a band of mixtures between them.
void TestUniformRemesh::coloursAreCarriedThrough()
{
    TriangleMesh ball = icosphere(4, 50);
    for (const Vec3f& p : ball.points)
        ball.colors.push_back(p.y() > 0 ? Rgb{255, 0, 0} : Rgb{0, 0, 255});
    for (const double times : {0.5, 2.0}) {
        const Remeshed result = remeshed(ball, times);
        const TriangleMesh after = extractMesh(*result.mesh);
        const float band = static_cast<float>(3 * std::max(result.detail, result.detail / times));
        for (std::size_t v = 0; v < after.points.size(); ++v) {
            if (after.points[v].y() > band)
                QVERIFY((after.colors[v] == Rgb{255, 0, 0}));
            if (after.points[v].y() < -band)
                QVERIFY((after.colors[v] == Rgb{0, 0, 255}));
        }
    }
}

void TestUniformRemesh::evenMesh_isLeftAlone()
{
    const auto mesh = buildMesh(icosphere(4, 50)).mesh;
    QVERIFY(!applyToCopy(*mesh, RemeshUniformly{}).changes);
}

void TestUniformRemesh::sameMesh_givesTheSame()
{
    const auto mesh = buildMesh(clay::twoFingers(0.01)).mesh;
    const RemeshUniformly command{0.7 * mesh->uniformDetail()};
    QCOMPARE(applyToCopy(*mesh, command).delta.meshHash, applyToCopy(*mesh, command).delta.meshHash);
}

void TestUniformRemesh::tooFine_isRefused()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const ModelChange many = applyToCopy(*mesh, RemeshUniformly{0.05});
    QVERIFY(many.refusal == ModelRefusal::TooFine && !many.changes);
    QVERIFY(many.faces > ModelLimits::maxFaces);
    QVERIFY(applyToCopy(*mesh, RemeshUniformly{mesh->lattice().minDetail() / 2}).refusal == ModelRefusal::TooFine);
}

void TestUniformRemesh::stopped_changesNothing()
{
    const auto mesh = buildMesh(icosphere(5, 50)).mesh;
    for (const int stopAt : {1, 5, 11}) {
        std::stop_source source;
        int calls = 0;
        double last = 0;
        const JobControl control{source.get_token(), [&](double share) {
                                     QVERIFY(share >= last && share <= 1);
                                     last = share;
                                     if (++calls == stopAt)
                                         source.request_stop();
                                 }};
        const ModelChange change = applyToCopy(*mesh, RemeshUniformly{0.5 * mesh->uniformDetail()}, control);
        QCOMPARE(calls, stopAt); // cancelling takes effect at once
        QVERIFY(!change.changes && change.delta.empty());
    }
}

FETTLE_TEST(TestUniformRemesh)
#include "tst_uniform_remesh.moc"
