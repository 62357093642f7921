#include "core/mesh/normals.h"
#include "core/sculpt/deform/deform.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

using core::FaceOctree;
using core::Mesh;
using core::Region;
using core::Slot;
using core::Tool;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
/// A mesh whose vertices in a ball are selected and have a planned displacement.
struct Planned
{
    std::unique_ptr<Mesh> mesh;
    Region region;
    double longest = 0;

    Planned(const core::TriangleMesh& shape, Tool tool, const core::Dab& dab, int falloff = 4) : mesh(sculptable(shape))
    {
        const FaceOctree octree(*mesh);
        std::vector<Slot> candidates;
        selectSphere(region, candidates, *mesh, octree, {dab.position, dab.radius});
        core::StrokeSettings settings;
        settings.tool = tool;
        settings.falloff = falloff;
        longest = planDeformation(region, {*mesh, settings, dab, {}});
    }
};

core::Dab poleDab(double strength = 1)
{
    core::Dab d;
    d.position = {0, 0, 1};
    d.radius = 0.4;
    d.strength = strength;
    return d;
}

Vec3 position(const Mesh& mesh, Slot v)
{
    return mesh.point(v).cast<double>();
}

Vec3 meanOfNeighbours(const Mesh& mesh, Slot v)
{
    Vec3 sum = Vec3::Zero();
    mesh.forEachOutgoing(v, [&](Slot h) { sum += position(mesh, mesh.to(h)); });
    return sum / mesh.valence(v);
}
} // namespace

class TestDeform : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void normal_isTheExactSumOfTheFacesAreas();
    void normal_pointsOutwards();
    void pull_goesAlongTheNormalByTheFalloff();
    void push_isTheOppositeOfPull();
    void pushAfterPull_movesOppositelyWithinALatticeUnit();
    void falloffZero_movesAllAlike();
    void smooth_goesTowardsTheNeighboursMean();
    void smooth_saturatesAtStrengthOne();
    void longest_isTheLongestPlan();
};

void TestDeform::normal_isTheExactSumOfTheFacesAreas()
{
    const auto mesh = sculptable(clay::bowl());
    for (Slot v = 0; v < mesh->slots().vertices; ++v) {
        Eigen::Matrix<std::int64_t, 3, 1> sum = Eigen::Matrix<std::int64_t, 3, 1>::Zero();
        mesh->forEachOutgoing(v, [&](Slot h) {
            const core::Triangle& t = mesh->corners(mesh->face(h));
            const auto at = [&](std::size_t i) { return mesh->latticePoint(t[i]).cast<std::int64_t>().eval(); };
            sum += (at(1) - at(0)).cross(at(2) - at(0));
        });
        const double unit = mesh->lattice().unit();
        QVERIFY(vertexNormal(*mesh, v) == unit * unit * sum.cast<double>());
    }
}

void TestDeform::normal_pointsOutwards()
{
    const auto mesh = sculptable(core::icosphere(3, 1));
    for (Slot v = 0; v < mesh->slots().vertices; ++v)
        QVERIFY(vertexNormal(*mesh, v).normalized().dot(position(*mesh, v)) > 0.99);
}

void TestDeform::pull_goesAlongTheNormalByTheFalloff()
{
    const Planned pull(core::icosphere(4, 1), Tool::Pull, poleDab(3));
    QVERIFY(pull.region.size() > 50);
    pull.region.forEach([&](Slot v) {
        const double x = (position(*pull.mesh, v) - poleDab().position).norm() / poleDab().radius;
        const Vec3 expected =
            0.1 * poleDab().radius * 3 * core::falloff(x, 4) * vertexNormal(*pull.mesh, v).normalized();
        QVERIFY((pull.region.plan(v) - expected).norm() < 1e-15);
    });
}

void TestDeform::push_isTheOppositeOfPull()
{
    const Planned pull(core::icosphere(4, 1), Tool::Pull, poleDab()),
        push(core::icosphere(4, 1), Tool::Push, poleDab());
    QCOMPARE(pull.region.size(), push.region.size());
    pull.region.forEach([&](Slot v) { QVERIFY(push.region.plan(v) == -pull.region.plan(v)); });
    QCOMPARE(pull.longest, push.longest);
}

void TestDeform::pushAfterPull_movesOppositelyWithinALatticeUnit()
{
    const Planned pull(core::icosphere(4, 1), Tool::Pull, poleDab()),
        push(core::icosphere(4, 1), Tool::Push, poleDab());
    const core::Lattice& lattice = pull.mesh->lattice();
    pull.region.forEach([&](Slot v) {
        const Vec3 p = position(*pull.mesh, v);
        const Vec3 out = lattice.snap(p + pull.region.plan(v)).cast<double>() - p;
        const Vec3 in = lattice.snap(p + push.region.plan(v)).cast<double>() - p;
        QVERIFY((out + in).cwiseAbs().maxCoeff() <= lattice.unit());
    });
}

void TestDeform::falloffZero_movesAllAlike()
{
    const Planned pull(core::icosphere(4, 1), Tool::Pull, poleDab(), 0);
    pull.region.forEach([&](Slot v) { QVERIFY(std::abs(pull.region.plan(v).norm() - 0.04) < 1e-12); });
}

void TestDeform::smooth_goesTowardsTheNeighboursMean()
{
    const Planned smooth(shapes::noisy(core::icosphere(4, 1), 0.01f, 7), Tool::Smooth, poleDab(0.5));
    smooth.region.forEach([&](Slot v) {
        const Vec3 p = position(*smooth.mesh, v);
        const double x = (p - poleDab().position).norm() / poleDab().radius;
        const Vec3 expected = 0.5 * core::falloff(x, 4) * (meanOfNeighbours(*smooth.mesh, v) - p);
        QVERIFY((smooth.region.plan(v) - expected).norm() < 1e-12);
    });
}

void TestDeform::smooth_saturatesAtStrengthOne()
{
    const core::TriangleMesh rough = shapes::noisy(core::icosphere(4, 1), 0.01f, 7);
    const Planned full(rough, Tool::Smooth, poleDab(1)), more(rough, Tool::Smooth, poleDab(10));
    full.region.forEach([&](Slot v) { QVERIFY(full.region.plan(v) == more.region.plan(v)); });
}

void TestDeform::longest_isTheLongestPlan()
{
    for (Tool tool : {Tool::Pull, Tool::Push, Tool::Smooth}) {
        const Planned planned(shapes::noisy(core::icosphere(4, 1), 0.01f, 7), tool, poleDab(2));
        double longest = 0;
        planned.region.forEach([&](Slot v) { longest = std::max(longest, planned.region.plan(v).norm()); });
        QVERIFY(longest > 0 && std::abs(planned.longest - longest) < 1e-12);
    }
}

FETTLE_TEST(TestDeform)
#include "tst_deform.moc"
