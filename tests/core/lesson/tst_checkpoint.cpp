#include "core/analysis/mesh_check.h"
#include "core/lesson/checkpoint.h"
#include "core/primitives/starter_models.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace core;

namespace
{
constexpr double radius = 50;

TriangleMesh moved(TriangleMesh mesh, const Vec3f& by)
{
    for (Vec3f& p : mesh.points)
        p += by;
    return mesh;
}

FactVerdict verdictOf(const FactBounds& asked, const TriangleMesh& mesh)
{
    return evaluate({{asked}, {}}, mesh, nullptr).facts.at(0);
}

TargetVerdict verdictOf(double tolerance, const TriangleMesh& model, const TriangleMesh& target)
{
    return evaluate({{}, CheckpointTarget{"", tolerance}}, model, &target).target.value();
}
} // namespace

class TestCheckpoint : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void facts_areMeasured()
    {
        const TriangleMesh torus = starterModel(Starter::Torus);
        const MeshReport report = checkMesh(torus);
        const std::pair<Fact, double> expected[] = {{Fact::Genus, 1},
                                                    {Fact::Components, 1},
                                                    {Fact::Height, report.size.y()},
                                                    {Fact::Width, 100},
                                                    {Fact::Depth, 100},
                                                    {Fact::Volume, *report.volume},
                                                    {Fact::Faces, static_cast<double>(torus.triangles.size())},
                                                    {Fact::PrintReady, 1}};
        for (const auto& [fact, value] : expected) {
            QCOMPARE(verdictOf({fact, value, value}, torus).measured.value(), value);
            QVERIFY(verdictOf({fact, value, value}, torus).holds);
            QVERIFY(verdictOf({fact, 0, value}, torus).holds);
            QVERIFY(verdictOf({fact, value}, torus).holds);
            QVERIFY(!verdictOf({fact, std::nextafter(value, 1e300)}, torus).holds);
            QVERIFY(value == 0 || !verdictOf({fact, 0, std::nextafter(value, -1)}, torus).holds);
        }
    }

    /// A fact that is undefined for the model does not hold, whatever its range.
    void openModel_hasNoGenusAndIsNotReady()
    {
        TriangleMesh open = starterModel(Starter::Ball);
        open.triangles.pop_back();
        QVERIFY(!verdictOf({Fact::Genus, 0}, open).measured);
        QVERIFY(!verdictOf({Fact::Genus, 0}, open).holds);
        QVERIFY(!verdictOf({Fact::PrintReady, 1, 1}, open).holds);
        QVERIFY(verdictOf({Fact::Height, 99, 101}, open).holds);
    }

    void sameShape_isNowhereApart()
    {
        const TriangleMesh ball = starterModel(Starter::Ball);
        const TargetVerdict verdict = verdictOf(0.001, ball, ball);
        QVERIFY(verdict.holds);
        QCOMPARE(verdict.nearDistance, 0.0);
        QCOMPARE(verdict.largest, 0.0);
        QCOMPARE(verdict.distances.size(), ball.points.size());
    }

    /// Each point of a sphere is as far from a concentric sphere as their radii differ.
    void largerBall_isApartByTheRadius()
    {
        const TriangleMesh small = icosphere(5, radius), large = icosphere(5, radius + 3);
        const TargetVerdict verdict = verdictOf(2.9, large, small);
        QVERIFY(!verdict.holds);
        QVERIFY(std::abs(verdict.nearDistance - 3) < 0.05 && std::abs(verdict.largest - 3) < 0.05);
        for (const float distance : verdict.distances)
            QVERIFY(std::abs(distance - 3) < 0.05);
        QVERIFY(verdictOf(3.1, large, small).holds);
        QVERIFY(verdictOf(3.1, small, large).holds);
    }

    /// Deviations on up to 5 % of the surface are ignored. A missing half counts, although the existing half matches.
    void number_isOfMostOfBothSurfaces()
    {
        const TriangleMesh ball = icosphere(5, radius);
        TriangleMesh thorn = ball;
        thorn.points.front() *= 1.5F;
        const TargetVerdict spiked = verdictOf(0.5, thorn, ball);
        QVERIFY(spiked.holds);
        QVERIFY(spiked.largest > 20);
        TriangleMesh half = ball;
        std::erase_if(half.triangles, [&](const Triangle& t) { return half.points[t[0]].x() < 0; });
        const TargetVerdict missing = verdictOf(5, half, ball);
        QVERIFY(!missing.holds);
        QVERIFY(verdictOf(5, ball, half).nearDistance == missing.nearDistance);
    }

    void place_counts()
    {
        const TriangleMesh ball = icosphere(4, radius);
        QVERIFY(!verdictOf(2, moved(ball, {5, 0, 0}), ball).holds);
        QVERIFY(verdictOf(5.1, moved(ball, {5, 0, 0}), ball).holds);
    }

    void checkpoint_isMetWhenAllHolds()
    {
        const TriangleMesh ball = icosphere(4, radius);
        const Checkpoint both{{{Fact::Genus, 0, 0}}, CheckpointTarget{"", 1}};
        QVERIFY(evaluate(both, ball, &ball).isMet());
        const TriangleMesh far = moved(ball, {9, 0, 0});
        QVERIFY(!evaluate(both, far, &ball).isMet());
        QVERIFY(!evaluate({{{Fact::Genus, 1, 1}}, CheckpointTarget{"", 1}}, ball, &ball).isMet());
        QVERIFY(evaluate({}, ball, nullptr).isMet());
    }
};

FETTLE_TEST(TestCheckpoint)
#include "tst_checkpoint.moc"
