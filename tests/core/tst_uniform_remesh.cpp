#include "core/mesh_build.h"
#include "core/model_command.h"
#include "core/uniform_remesh.h"
#include "tests/support/clay.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"

#include <QTest>

using namespace core;

namespace
{
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
    result.change = tryOn(*result.mesh, RemeshUniformly{result.detail});
    if (result.change.changes)
        result.mesh->swap(result.change.delta);
    return result;
}
} // namespace

class TestUniformRemesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anyShape_staysSound_data();
    void anyShape_staysSound();
    void roundShapes_becomeUniform_data();
    void roundShapes_becomeUniform();
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
    QTest::addColumn<double>("radius"); // of its sharpest curve; 0: flat
    for (const double times : {0.3, 0.5, 0.9, 1.5, 3.0}) {
        QTest::addRow("ball %g", times) << icosphere(4, 50) << times << 50.0;
        QTest::addRow("torus %g", times) << shapes::torus({3, 1, 96, 48}) << times << 1.0;
        QTest::addRow("cube %g", times) << shapes::cube(20) << times / 8 << 0.0;
    }
}

void TestUniformRemesh::roundShapes_becomeUniform()
{
    QFETCH(TriangleMesh, shape);
    QFETCH(double, timesDetail);
    QFETCH(double, radius);
    const double volume = checkMesh(shape).volume.value();
    const Remeshed result = remeshed(shape, timesDetail);
    QVERIFY(result.change.refusal == ModelRefusal::None);
    const Evenness evenness = evennessOf(*result.mesh, edgeBounds(result.detail));
    QVERIFY2(evenness.isUniform(), qPrintable(QStringLiteral("%1 of %2 too short").arg(evenness.tooShort).arg(evenness.edges)));
    if (result.change.changes)
        QCOMPARE(result.mesh->uniformDetail(), result.detail);
    const double after = checkMesh(extractMesh(*result.mesh)).volume.value();
    // With each vertex on it, a tube of this radius loses (edge / radius)^2 / 6 to n = 2 pi radius / edge flat sides.
    const double edge = radius > 0 ? 0.8 * result.detail / radius : 0;
    QVERIFY2(std::abs(after - volume) < std::max(0.05, edge * edge / 6) * volume, qPrintable(QString::number(after / volume)));
}

void TestUniformRemesh::defaultLength_isFourThirdsOfTheMeanEdge()
{
    const auto mesh = buildMesh(shapes::torus()).mesh;
    const ModelChange unnamed = tryOn(*mesh, RemeshUniformly{});
    const ModelChange named = tryOn(*mesh, RemeshUniformly{mesh->uniformDetail()});
    QVERIFY(unnamed.changes);
    QCOMPARE(unnamed.delta.meshHash, named.delta.meshHash);
}

void TestUniformRemesh::undo_restoresTheState()
{
    for (const double times : {0.5, 2.0}) {
        const auto mesh = buildMesh(clay::bowl()).mesh;
        const std::uint64_t before = mesh->stateHash();
        ModelChange change = tryOn(*mesh, RemeshUniformly{times * mesh->uniformDetail()});
        QVERIFY(change.changes);
        mesh->swap(change.delta);
        const std::uint64_t after = mesh->stateHash();
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), before);
        mesh->swap(change.delta);
        QCOMPARE(mesh->stateHash(), after);
    }
}

/// Red above, blue below: so it stays but for a band of mixtures.
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
    QVERIFY(!tryOn(*mesh, RemeshUniformly{}).changes);
}

void TestUniformRemesh::sameMesh_givesTheSame()
{
    const auto mesh = buildMesh(clay::twoFingers(0.01)).mesh;
    const RemeshUniformly command{0.7 * mesh->uniformDetail()};
    QCOMPARE(tryOn(*mesh, command).delta.meshHash, tryOn(*mesh, command).delta.meshHash);
}

void TestUniformRemesh::tooFine_isRefused()
{
    const auto mesh = buildMesh(icosphere(3, 50)).mesh;
    const ModelChange many = tryOn(*mesh, RemeshUniformly{0.05});
    QVERIFY(many.refusal == ModelRefusal::TooFine && !many.changes);
    QVERIFY(many.faces > ModelLimits::mostFaces);
    QVERIFY(tryOn(*mesh, RemeshUniformly{mesh->lattice().minDetail() / 2}).refusal == ModelRefusal::TooFine);
}

void TestUniformRemesh::stopped_changesNothing()
{
    const auto mesh = buildMesh(icosphere(5, 50)).mesh;
    for (const int stopAt : {1, 5, 11}) {
        std::stop_source source;
        int calls = 0;
        double last = 0;
        const JobWatch watch{source.get_token(), [&](double share) {
                                 QVERIFY(share >= last && share <= 1);
                                 last = share;
                                 if (++calls == stopAt)
                                     source.request_stop();
                             }};
        const ModelChange change = tryOn(*mesh, RemeshUniformly{0.5 * mesh->uniformDetail()}, watch);
        QCOMPARE(calls, stopAt); // stops at once
        QVERIFY(!change.changes && change.delta.empty());
    }
}

QTEST_APPLESS_MAIN(TestUniformRemesh)
#include "tst_uniform_remesh.moc"
