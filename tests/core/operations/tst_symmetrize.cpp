#include "core/operations/model_command.h"
#include "core/sculpt/sculptor.h"
#include "tests/support/clay.h"
#include "tests/support/mirror_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_asserts.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::Half;
using core::Mesh;
using core::ModelChange;
using core::ModelRefusal;
using core::Slot;
using core::Symmetry;
using core::Vec3;
using core::Vec3f;
using mesh_asserts::sculptable;

class TestSymmetrize : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void half_andItsImage_data();
    void half_andItsImage();
    void keptHalf_keepsItsVertices();
    void otherHalf_goes();
    void symmetricModel_keepsItsShape();
    void plane_throughNothing_isRefused();
    void touchingHalves_areRefused();
    void parts_onTheOtherSide_go();
    void stopped_changesNothing();
};

namespace
{
core::TriangleMesh turnedAboutZ(core::TriangleMesh mesh, double cosine, double sine)
{
    for (Vec3f& p : mesh.points) {
        const Vec3 q = p.cast<double>();
        p = Vec3(cosine * q.x() - sine * q.y(), sine * q.x() + cosine * q.y(), q.z()).cast<float>();
    }
    return mesh;
}

/// Returns the largest extent of the mesh in a direction.
double reach(const Mesh& mesh, const Vec3& direction)
{
    double farthest = -1e300;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v))
            farthest = std::max(farthest, mesh.point(v).cast<double>().dot(direction));
    }
    return farthest;
}

core::TriangleMesh lopsided()
{
    core::TriangleMesh mesh = shapes::noisy(core::icosphere(3, 1), 0.01f, 5);
    for (Vec3f& p : mesh.points)
        p.x() *= p.x() > 0 ? 1.5f : 1;
    return mesh;
}
} // namespace

void TestSymmetrize::half_andItsImage_data()
{
    QTest::addColumn<core::TriangleMesh>("shape");
    QTest::addColumn<Symmetry>("plane");
    QTest::addColumn<Half>("keep");
    const std::pair<const char*, core::TriangleMesh> models[] = {
        {"sphere", core::icosphere(3, 1)},
        {"noisy sphere", lopsided()},
        {"cube", shapes::cube(1)},
        {"torus", shapes::torus()},
        {"turned torus", turnedAboutZ(shapes::torus(), 0.8, 0.6)},
        {"turned cube", turnedAboutZ(shapes::moved(shapes::cube(1), {0.1f, 0.05f, 0.02f}), 0.8, 0.6)},
        {"slab", clay::slab(2, 0.05, 12)},
        {"bowl", clay::bowl()},
        {"nested shells", shapes::nestedSpheres(true)},
        {"two fingers", clay::twoFingers(0.01)}};
    for (const auto& [name, mesh] : models) {
        for (const Symmetry plane : {Symmetry::X, Symmetry::Y, Symmetry::Z}) {
            for (const Half keep : {Half::Positive, Half::Negative})
                QTest::addRow("%s, %s %s 0", name, std::string(core::name(plane)).c_str(),
                              keep == Half::Positive ? ">" : "<")
                    << mesh << plane << keep;
        }
    }
}

void TestSymmetrize::half_andItsImage()
{
    QFETCH(core::TriangleMesh, shape);
    QFETCH(Symmetry, plane);
    QFETCH(Half, keep);
    const auto mesh = sculptable(shape);
    const std::uint64_t before = mesh->stateHash();
    ModelChange change = applyToCopy(*mesh, core::Symmetrize{plane, keep});
    QCOMPARE(static_cast<int>(change.refusal), static_cast<int>(ModelRefusal::None));
    QVERIFY(change.changes);
    QCOMPARE(mesh->stateHash(), before);
    mesh->swap(change.delta);
    VERIFY_SYMMETRIC(*mesh, plane);
    VERIFY_VALID(*mesh);
    const std::uint64_t after = mesh->stateHash();
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), before);
    mesh->swap(change.delta);
    QCOMPARE(mesh->stateHash(), after);
}

void TestSymmetrize::keptHalf_keepsItsVertices()
{
    const auto mesh = sculptable(lopsided()), original = sculptable(lopsided());
    ModelChange change = applyToCopy(*mesh, core::Symmetrize{Symmetry::X, Half::Positive});
    mesh->swap(change.delta);
    for (Slot v = 0; v < original->slots().vertices; ++v) {
        if (original->point(v).x() > 0.05f)
            QVERIFY(mesh->isVertex(v) && mesh->point(v) == original->point(v));
    }
}

void TestSymmetrize::otherHalf_goes()
{
    for (const Half keep : {Half::Positive, Half::Negative}) {
        const auto mesh = sculptable(lopsided()); // extends to 1.5 at x > 0 and to 1 at x < 0
        ModelChange change = applyToCopy(*mesh, core::Symmetrize{Symmetry::X, keep});
        mesh->swap(change.delta);
        const double expected = keep == Half::Positive ? 1.5 : 1;
        QVERIFY(std::abs(reach(*mesh, Vec3::UnitX()) - expected) < 0.02);
        QVERIFY(std::abs(reach(*mesh, -Vec3::UnitX()) - expected) < 0.02);
        QCOMPARE(mesh_asserts::eulerNumber(*mesh), 2);
    }
}

void TestSymmetrize::symmetricModel_keepsItsShape()
{
    const auto mesh = sculptable(core::icosphere(3, 1));
    std::uint64_t hash = 0;
    for (int i = 0; i < 2; ++i) { // the first pass also splits edges that cross the plane
        hash = mesh->meshHash();
        ModelChange change = applyToCopy(*mesh, core::Symmetrize{Symmetry::Y, Half::Negative});
        QVERIFY(change.refusal == ModelRefusal::None);
        mesh->swap(change.delta);
    }
    QCOMPARE(mesh->meshHash(), hash);
}

void TestSymmetrize::plane_throughNothing_isRefused()
{
    const auto mesh = sculptable(shapes::moved(core::icosphere(2, 1), {3, 0, 0}));
    const ModelChange change = applyToCopy(*mesh, core::Symmetrize{Symmetry::X, Half::Negative});
    QVERIFY(change.refusal == ModelRefusal::EmptyHalf && !change.changes && change.delta.empty());
    // the kept sphere and its mirror image
    QVERIFY(applyToCopy(*mesh, core::Symmetrize{Symmetry::X, Half::Positive}).changes);
}

void TestSymmetrize::touchingHalves_areRefused()
{
    core::TriangleMesh octahedron;
    // vertex 0 is on the plane
    octahedron.points = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}};
    octahedron.triangles = {{0, 4, 2}, {0, 3, 4}, {0, 5, 3}, {0, 2, 5}, {1, 2, 4}, {1, 4, 3}, {1, 3, 5}, {1, 5, 2}};
    const auto mesh = sculptable(octahedron);
    VERIFY_VALID(*mesh);
    const ModelChange change = applyToCopy(*mesh, core::Symmetrize{Symmetry::X, Half::Positive});
    QVERIFY(change.refusal == ModelRefusal::HalvesMeet && !change.changes && change.delta.empty());
}

void TestSymmetrize::parts_onTheOtherSide_go()
{
    const auto mesh =
        sculptable(shapes::together(core::icosphere(3, 1), shapes::moved(core::icosphere(2, 0.3), {-2, 0, 0})));
    ModelChange change = applyToCopy(*mesh, core::Symmetrize{Symmetry::X, Half::Positive});
    mesh->swap(change.delta);
    QCOMPARE(mesh_asserts::eulerNumber(*mesh), 2);
    mesh->swap(change.delta);
    change = applyToCopy(*mesh, core::Symmetrize{Symmetry::X, Half::Negative});
    mesh->swap(change.delta);
    QCOMPARE(mesh_asserts::eulerNumber(*mesh), 6);
    VERIFY_SYMMETRIC(*mesh, Symmetry::X);
}

void TestSymmetrize::stopped_changesNothing()
{
    const auto mesh = sculptable(lopsided());
    std::stop_source stop;
    stop.request_stop();
    const ModelChange change =
        applyToCopy(*mesh, core::Symmetrize{Symmetry::X, Half::Positive}, {stop.get_token(), {}});
    QVERIFY(!change.changes && change.delta.empty());
}

FETTLE_TEST(TestSymmetrize, QCoreApplication)
#include "tst_symmetrize.moc"
