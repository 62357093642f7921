#include "core/mesh/mesh_builder.h"
#include "core/primitives/starter_models.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <set>

using core::Starter;
using core::Vec3f;

class TestStarterModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isSound_data() { starters(); }
    void isSound();
    void is100mmLongAndCentred_data() { starters(); }
    void is100mmLongAndCentred();
    void isSymmetric_data() { starters(); }
    void isSymmetric();
    void edgesAreOfOneKind_data() { starters(); }
    void edgesAreOfOneKind();

private:
    static void starters();
};

void TestStarterModels::starters()
{
    QTest::addColumn<Starter>("starter");
    QTest::addColumn<int>("genus");
    const char* names[] = {"ball", "cube", "torus", "slab", "vase", "head", "tablet"};
    for (const Starter starter : core::starters)
        QTest::newRow(names[static_cast<int>(starter)]) << starter << (starter == Starter::Torus ? 1 : 0);
}

void TestStarterModels::isSound()
{
    QFETCH(Starter, starter);
    QFETCH(int, genus);
    const core::TriangleMesh mesh = core::starterModel(starter);
    const core::BuildResult built = core::buildMesh(mesh, false);
    QVERIFY(built.mesh);
    QVERIFY(built.report.printReady());
    QCOMPARE(built.report.components, std::size_t(1));
    QCOMPARE(built.report.genus, genus);
    QCOMPARE_GE(mesh.points.size(), std::size_t(5000));
    QCOMPARE_LE(mesh.points.size(), std::size_t(16'000));
}

void TestStarterModels::is100mmLongAndCentred()
{
    QFETCH(Starter, starter);
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : core::starterModel(starter).points)
        box.extend(p);
    QVERIFY(std::abs(box.sizes().maxCoeff() - 100) < 1e-3f);
    QVERIFY(box.center().norm() < 1e-3f);
}

void TestStarterModels::isSymmetric()
{
    QFETCH(Starter, starter);
    const core::TriangleMesh mesh = core::starterModel(starter);
    using Place = std::array<float, 3>;
    using Face = std::set<Place>;
    std::set<Face> faces;
    const auto place = [&](core::Slot v, int axis) {
        Vec3f p = mesh.points[v];
        if (axis >= 0)
            p[axis] = -p[axis];
        return Place{p.x() + 0, p.y() + 0, p.z() + 0}; // converts -0 to 0
    };
    const auto face = [&](const core::Triangle& t, int axis) {
        return Face{place(t[0], axis), place(t[1], axis), place(t[2], axis)};
    };
    for (const core::Triangle& t : mesh.triangles)
        faces.insert(face(t, -1));
    for (const core::Triangle& t : mesh.triangles) {
        QVERIFY(faces.contains(face(t, 0)));
        QVERIFY(starter == Starter::Head || faces.contains(face(t, 2)));
    }
}

/// Edges are of similar length without slivers, so that a brush meets a similar mesh everywhere.
void TestStarterModels::edgesAreOfOneKind()
{
    QFETCH(Starter, starter);
    const core::TriangleMesh mesh = core::starterModel(starter);
    double shortest = 1e9, longest = 0;
    for (const core::Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double length = (mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]).norm();
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
        }
    }
    QCOMPARE_LE(longest, 6 * shortest);
}

FETTLE_TEST(TestStarterModels)
#include "tst_starter_models.moc"
