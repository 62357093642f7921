#include "core/lesson/model_facts.h"
#include "core/primitives/starter_models.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace core;

namespace
{
constexpr double radius = 50;

TriangleMesh scaled(TriangleMesh mesh, const Vec3f& by)
{
    for (Vec3f& p : mesh.points)
        p = p.cwiseProduct(by);
    return mesh;
}

TriangleMesh moved(TriangleMesh mesh, const Vec3f& by)
{
    for (Vec3f& p : mesh.points)
        p += by;
    return mesh;
}

TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other)
{
    const auto before = static_cast<Slot>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
    return mesh;
}

/// Returns a ball whose profile has `waves` grooves in its middle half, `depth` deep as a share of the radius.
TriangleMesh wavy(int waves, double depth)
{
    TriangleMesh mesh = icosphere(6, radius);
    for (Vec3f& p : mesh.points) {
        // position within the middle half of the height: 0 at its bottom, 1 at its top
        const double share = static_cast<double>(p.y()) / radius + 0.5;
        if (share <= 0 || share >= 1)
            continue;
        const double wave = std::sin(waves * std::numbers::pi * share);
        const auto swing = static_cast<float>(1 - depth * wave * wave);
        p.x() *= swing;
        p.z() *= swing;
    }
    return mesh;
}
} // namespace

class TestModelFacts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The width is measured in all horizontal directions: twice the radius, or the long axis. The height does not
    /// count.
    void widest_isSeenFromAbove()
    {
        const TriangleMesh ball = icosphere(5, radius);
        QVERIFY(std::abs(widestOf(ball) - 2 * radius) < 0.01);
        QVERIFY(std::abs(widestOf(scaled(ball, {1, 3, 1})) - 2 * radius) < 0.01);
        const TriangleMesh longer = scaled(ball, {2, 1, 1});
        QVERIFY(std::abs(widestOf(longer) - 4 * radius) < 0.01);
        for (const double degrees : {10.0, 45.0, 133.0}) {
            TriangleMesh turned = longer;
            const Eigen::AngleAxisf turn(static_cast<float>(degrees * std::numbers::pi / 180), Vec3f::UnitY());
            for (Vec3f& p : turned.points)
                p = turn * p;
            QVERIFY(std::abs(widestOf(turned) - 4 * radius) < 0.01);
        }
        TriangleMesh unused = ball;
        unused.points.push_back({1000, 0, 0});
        QCOMPARE(widestOf(unused), widestOf(ball));
    }

    void feet_areCountedAtTheBottom()
    {
        const TriangleMesh ball = icosphere(5, radius);
        QCOMPARE(feetOf(ball), 1);
        QCOMPARE(feetOf(starterModel(Starter::Torus)), 1);
        QCOMPARE(feetOf(together(ball, moved(ball, {150, 0, 0}))), 2);
        QCOMPARE(feetOf(together(ball, moved(ball, {150, 20, 0}))), 1); // the second ball is 20 mm above the bed
        QCOMPARE(feetOf({}), 0);
    }

    void base_isWhatLiesFlatOnTheBed()
    {
        const TriangleMesh ball = icosphere(5, radius), cube = moved(shapes::cube(20), {3, 7, -40});
        QCOMPARE(baseAreaOf(ball, checkMesh(ball)), 0.0);
        QVERIFY(std::abs(baseAreaOf(cube, checkMesh(cube)) - 400) < 0.01);
    }

    void grooves_goAllAround()
    {
        QCOMPARE(groovesOf(icosphere(5, radius)), 0);
        QCOMPARE(groovesOf({}), 0);
        for (const int waves : {1, 2, 3})
            QCOMPARE(groovesOf(wavy(waves, 0.2)), static_cast<std::size_t>(waves));
        QCOMPARE(groovesOf(wavy(3, 0.005)), 0); // grooves too shallow to count
        TriangleMesh oneSided = wavy(3, 0.2);
        const TriangleMesh ball = icosphere(6, radius);
        for (std::size_t v = 0; v < ball.points.size(); ++v)
            if (ball.points[v].x() > 0)
                oneSided.points[v] = ball.points[v];
        QCOMPARE(groovesOf(oneSided), 0);
    }
};

FETTLE_TEST(TestModelFacts)
#include "tst_model_facts.moc"
