#include "tests/support/cgal_judge.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include "core/analysis/mesh_check.h"
#include "core/geometry/face_geometry.h"
#include "core/geometry/lattice.h"
#include "core/io/placed_mesh.h"
#include "core/util/file_error.h"

#include <QTest>

using core::TriangleMesh;
using core::Vec3;
using core::Vec3f;

namespace
{
TriangleMesh onLattice(TriangleMesh mesh)
{
    for (Vec3f& p : mesh.points)
        p = core::Lattice(20).snap(p.cast<double>());
    return mesh;
}

/// Returns two balls of radius 1 with edges of about 0.06, separated by a gap of 0.001.
TriangleMesh balls()
{
    const TriangleMesh ball = core::icosphere(4, 1);
    return onLattice(shapes::together(ball, shapes::moved(ball, {2.001F, 0.0003F, 0.0002F})));
}

TriangleMesh rounded(TriangleMesh mesh, const Vec3& place)
{
    for (Vec3f& p : mesh.points)
        p = (p.cast<double>() + place).cast<float>();
    return mesh;
}
} // namespace

class TestPlacedMesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void near_isExact();
    void far_isSoundOrRefused();
};

void TestPlacedMesh::near_isExact()
{
    const Vec3 place(3, -2, 0.5);
    const TriangleMesh there = core::placedMesh("a.stl", balls(), place);
    for (std::size_t i = 0; i < there.points.size(); ++i)
        QCOMPARE(there.points[i].cast<double>(), Vec3(balls().points[i].cast<double>() + place));
}

/// Rounding alone can make faces intersect far from the origin. Other nearby float positions are then used, as long as
/// enough exist.
void TestPlacedMesh::far_isSoundOrRefused()
{
    std::size_t rescued = 0, refused = 0;
    for (const double away : {1e3, 3e4, 1e5, 2e5, 1e7}) {
        const Vec3 place(away, away / 3, 0);
        try {
            const TriangleMesh there = core::placedMesh("a.stl", balls(), place);
            const auto verdict = judgedByCgal(there);
            QVERIFY(verdict && verdict->allWell());
            QVERIFY((core::boxOf(there).center() - core::boxOf(balls()).center() - place).norm() < 1e-6 * away);
            rescued += core::checkMesh(rounded(balls(), place)).printReady() ? 0U : 1U;
        } catch (const core::FileError& error) {
            QVERIFY(error.kind == core::FileErrorKind::TooFar && away > 5e4);
            ++refused;
        }
    }
    QVERIFY2(rescued > 0 && refused > 0, qPrintable(QStringLiteral("%1, %2").arg(rescued).arg(refused)));
}

FETTLE_TEST(TestPlacedMesh)
#include "tst_placed_mesh.moc"
