#include "core/sculpt/sculptor.h"
#include "core/sculpt/selection_quality.h"
#include "tests/support/clay.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>

using core::Mesh;
using core::Region;
using core::Slot;
using core::Vec3;
using mesh_asserts::sculptable;

namespace
{
bool near(double a, double b)
{
    return std::abs(a - b) < 1e-6;
}

Region regionOf(const Mesh& mesh, const std::function<bool(const Vec3&)>& takes)
{
    Region region;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (takes(mesh.point(v).cast<double>()))
            region.add(v, 0);
    }
    return region;
}

bool always(const Vec3&)
{
    return true;
}
} // namespace

class TestSelectionQuality : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tetrahedron_isMeasuredByHand();
    void shareCountsTheLongEdges();
    void onlyWhatIsSelectedCounts();
    void onePercentOfTheFacesIsExcused();
    void nothingSelected_hasNoQuality();
    void sculptor_measuresWhatTheLastDabSelected();
};

void TestSelectionQuality::tetrahedron_isMeasuredByHand()
{
    core::TriangleMesh mesh; // a regular tetrahedron with edges of 2 sqrt(2)
    mesh.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    const auto built = sculptable(std::move(mesh));
    const double edge = 2 * std::sqrt(2.0);
    const auto quality = selectionQuality(*built, regionOf(*built, always), {2 * edge, edge / 2});
    QVERIFY(quality);
    QVERIFY(near(quality->longestEdge, 0.5));
    QVERIFY(near(quality->conformingShare, 1));
    QVERIFY(near(quality->smallestAngleSine, std::sqrt(3.0) / 2)); // angle of 60 degrees
}

/// The cube has 12 edges of length 2 and 6 face diagonals.
void TestSelectionQuality::shareCountsTheLongEdges()
{
    const auto mesh = sculptable(shapes::cube(2));
    const Region region = regionOf(*mesh, always);
    const auto share = [&](double least) { return selectionQuality(*mesh, region, {10, least})->conformingShare; };
    QVERIFY(near(share(2), 1)); // edges of length exactly d conform
    QVERIFY(near(share(2.1), 6.0 / 18));
    QVERIFY(near(share(3), 0));
    QVERIFY(near(selectionQuality(*mesh, region, {1, 1})->longestEdge, std::sqrt(8.0)));
    QVERIFY(near(selectionQuality(*mesh, region, {1, 1})->smallestAngleSine, std::sqrt(0.5))); // angle of 45 degrees
}

void TestSelectionQuality::onlyWhatIsSelectedCounts()
{
    const auto mesh = sculptable(clay::slab(8, 1, 8)); // unit squares, each divided into two triangles
    const auto quality =
        selectionQuality(*mesh, regionOf(*mesh, [](const Vec3& p) { return p.y() > 0 && p.norm() < 2.5; }), {1, 1});
    QVERIFY(quality);
    QVERIFY(near(quality->longestEdge, std::sqrt(2.0)));
    const auto edge =
        selectionQuality(*mesh, regionOf(*mesh, [](const Vec3& p) { return p.y() > 0 && p.z() == 0; }), {1, 1});
    QVERIFY(!edge); // a row of vertices contains no face
}

void TestSelectionQuality::onePercentOfTheFacesIsExcused()
{
    core::TriangleMesh mesh = clay::slab(20, 1, 20);
    for (core::Vec3f& p : mesh.points) { // makes the faces around one vertex of each side slivers: 12 of 1760
        if (p.x() == 0 && p.z() == 0)
            p.x() = 0.95f;
    }
    const auto built = sculptable(std::move(mesh));
    const Region all = regionOf(*built, always);
    QVERIFY(near(selectionQuality(*built, all, {1, 1})->smallestAngleSine, std::sqrt(0.5)));
    const Region few = regionOf(*built, [](const Vec3& p) { return std::abs(p.x()) < 4 && std::abs(p.z()) < 4; });
    QVERIFY(selectionQuality(*built, few, {1, 1})->smallestAngleSine < 0.1);
}

void TestSelectionQuality::nothingSelected_hasNoQuality()
{
    const auto mesh = sculptable(shapes::cube(2));
    QVERIFY(!selectionQuality(*mesh, Region(), {1, 1}));
}

void TestSelectionQuality::sculptor_measuresWhatTheLastDabSelected()
{
    core::Sculptor sculptor(sculptable(core::icosphere(4, 1)));
    QVERIFY(!sculptor.selectionQuality());
    std::vector<core::DabReport> heard;
    sculptor.setAfterDab([&](const core::DabReport& report) { heard.push_back(report); });
    core::StrokeSettings settings;
    settings.radius = 0.3;
    sculptor.beginStroke(settings);
    core::StrokeSample sample;
    sample.position = {0, 0, 1};
    for (int dab = 0; dab < 10; ++dab) {
        const core::DabReport report = sculptor.addSample(sample).at(0);
        const auto quality = sculptor.selectionQuality();
        QVERIFY(quality);
        QVERIFY(quality->longestEdge > 0.5 && quality->longestEdge <= 1); // upper bound: d_detail
        QVERIFY(quality->conformingShare >= 0.95);
        QVERIFY(quality->smallestAngleSine >= 0.342); // sine of 20 degrees
        QCOMPARE(heard.size(), std::size_t(dab + 1));
        QCOMPARE(heard.back().touchedVertices, report.touchedVertices);
    }
    sample.position = {0, 0, 3};
    sculptor.addSample(sample);
    QVERIFY(!sculptor.selectionQuality());
    QCOMPARE(heard.size(), std::size_t(11));
    sculptor.endStroke();
    VERIFY_LINKED(sculptor.mesh());
}

FETTLE_TEST(TestSelectionQuality)
#include "tst_selection_quality.moc"
