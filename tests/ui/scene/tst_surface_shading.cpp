// Sharp edges, cavity shading and the brush's tint, checked in the pixels of the picture.
#include "core/mesh/dirty_slots.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/sharp_shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/scene/scene_picture.h"
#include "tests/ui/sphere_model.h"
#include "tests/ui/ui_test.h"

using ui::Scene;

namespace
{
constexpr QSize imageSize{240, 180};

core::MeshPatch patchOf(const core::TriangleMesh& mesh)
{
    return core::wholePatchOf(*mesh_asserts::sculptable(mesh));
}

/// Returns the patch with unchanged normals but without sharp edges.
core::MeshPatch smoothed(core::MeshPatch patch)
{
    for (core::DrawVertex& vertex : patch.vertices)
        vertex.crease = {};
    return patch;
}

/// Returns an orthographic camera, in whose picture a plane has a single shade.
ui::OrbitCamera parallelCamera(double radius, bool isFromTheSide = false)
{
    ui::OrbitCamera camera;
    camera.setViewport(imageSize.width(), imageSize.height());
    camera.setProjection(ui::OrbitCamera::Projection::Orthographic);
    if (isFromTheSide)
        camera.turnTo(ui::OrbitCamera::Side::Front);
    camera.frame(core::Box(core::Vec3::Constant(-radius), core::Vec3::Constant(radius)));
    return camera;
}

QImage shot(Scene& scene, const ui::OrbitCamera& camera)
{
    return pixelsOf(scene.render(camera, imageSize, 1), imageSize);
}

QColor colorAt(const QImage& picture, const ui::OrbitCamera& camera, const core::Vec3& place)
{
    const ui::OrbitCamera::Pixel at = camera.project(place);
    return picture.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

int difference(const QColor& a, const QColor& b)
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

/// Returns the largest difference in colour between the first place and the others.
int spread(const QImage& picture, const ui::OrbitCamera& camera, const std::vector<core::Vec3>& places)
{
    int most = 0;
    for (const core::Vec3& place : places)
        most = std::max(most, difference(colorAt(picture, camera, place), colorAt(picture, camera, places.front())));
    return most;
}
} // namespace

class TestSurfaceShading : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void sharpEdge_castsNoBands_data()
    {
        QTest::addColumn<int>("cuts");
        QTest::newRow("coarse") << 2;
        QTest::newRow("fine") << 20;
    }

    /// Each side of a box has a single shade up to its edges. Without the marks of sharp edges, it does not.
    void sharpEdge_castsNoBands()
    {
        QFETCH(int, cuts);
        const core::MeshPatch box = patchOf(gridBox({40, 40, 40}, cuts));
        const ui::OrbitCamera camera = parallelCamera(40);
        Scene scene;
        const auto bands = [&](const core::MeshPatch& patch) {
            scene.meshBuffer().apply(patch);
            const QImage picture = shot(scene, camera);
            int most = 0, seen = 0;
            for (int axis = 0; axis < 3; ++axis)
                for (const double side : {-1.0, 1.0}) {
                    const core::Vec3 out = side * core::Vec3::Unit(axis);
                    if (out.dot(camera.viewDirection()) > -0.3)
                        continue;
                    std::vector<core::Vec3> places;
                    for (const double u : {-37.0, -20.0, 0.0, 20.0, 37.0})
                        for (const double v : {-37.0, -20.0, 0.0, 20.0, 37.0}) {
                            core::Vec3 place = 40 * out;
                            place[(axis + 1) % 3] = u;
                            place[(axis + 2) % 3] = v;
                            places.push_back(place);
                        }
                    ++seen;
                    most = std::max(most, spread(picture, camera, places));
                }
            return seen >= 2 ? most : -1;
        };
        const int sharp = bands(box);
        QVERIFY2(sharp >= 0 && sharp <= 2, qPrintable(QString::number(sharp)));
        QVERIFY(bands(smoothed(box)) > 30);
    }

    /// The round side of a drum with a sharp rim keeps its shade along its height, and around it no triangles are
    /// visible.
    void roundSideBesideASharpEdge_staysSmooth()
    {
        const core::MeshPatch drum =
            patchOf(turned({{0, -20}, {30, -20}, {40, -20}, {40, -7}, {40, 7}, {40, 20}, {30, 20}, {0, 20}}, 32));
        const ui::OrbitCamera camera = parallelCamera(40, true);
        Scene scene;
        scene.meshBuffer().apply(drum);
        const QImage picture = shot(scene, camera);
        scene.setAppearance({.flat = true}, false);
        const QImage flat = shot(scene, camera);
        const auto on = [](double degrees, double height) {
            const double angle = degrees * std::numbers::pi / 180;
            return core::Vec3(40 * std::sin(angle), height, 40 * std::cos(angle));
        };
        int steepest = 0, steepestFlat = 0;
        for (double degrees = -50; degrees <= 50; degrees += 1) {
            QVERIFY(spread(picture, camera, {on(degrees, 18.5), on(degrees, 10), on(degrees, 0)}) <= 3);
            const auto step = [&](const QImage& image) {
                return difference(colorAt(image, camera, on(degrees, 18.5)),
                                  colorAt(image, camera, on(degrees + 1, 18.5)));
            };
            steepest = std::max(steepest, step(picture));
            steepestFlat = std::max(steepestFlat, step(flat));
        }
        QVERIFY2(2 * steepest < steepestFlat, qPrintable(QStringLiteral("%1, %2").arg(steepest).arg(steepestFlat)));
    }

    /// Cavity shading darkens a groove, lightens a rim and leaves flat areas unchanged. Switching it off restores the
    /// picture.
    void cavity_darkensValleysAndLightensRidges()
    {
        const core::MeshPatch drum = patchOf(turned({{0, -20},
                                                     {36, -20},
                                                     {40, -20},
                                                     {40, -12},
                                                     {40, -5},
                                                     {36, 0},
                                                     {40, 5},
                                                     {40, 12},
                                                     {40, 20},
                                                     {36, 20},
                                                     {0, 20}},
                                                    96));
        const ui::OrbitCamera camera = parallelCamera(40, true);
        Scene scene;
        scene.meshBuffer().apply(drum);
        const QImage without = shot(scene, camera);
        scene.setAppearance({.cavity = true}, false);
        const QImage with = shot(scene, camera);
        const auto change = [&](const core::Vec3& place) {
            return colorAt(with, camera, place).lightness() - colorAt(without, camera, place).lightness();
        };
        QVERIFY(change({0, 0, 36}) < -8);
        QVERIFY(change({0, 19, 40}) > 4);
        QVERIFY(std::abs(change({0, 12, 40})) <= 4);
        scene.setAppearance({}, false);
        QCOMPARE(shot(scene, camera), without);
    }

    void tint_isRoundOnACoarseMesh_data()
    {
        QTest::addColumn<int>("falloff");
        QTest::newRow("no weighting") << 0;
        QTest::newRow("n = 4") << 4;
    }

    /// The tint's border follows the brush's sphere, even on large triangles.
    void tint_isRoundOnACoarseMesh()
    {
        QFETCH(int, falloff);
        const ui::OrbitCamera camera = parallelCamera(40, true);
        Scene scene;
        scene.meshBuffer().apply(patchOf(gridBox({40, 40, 40}, 2)));
        const QImage bare = shot(scene, camera);
        core::StrokeSettings brush;
        brush.radius = 25;
        brush.falloff = falloff;
        scene.tintBall({7, 3, 40}, brush);
        const QImage tinted = shot(scene, camera);
        const auto change = [&](double degrees, double radii) {
            const double angle = degrees * std::numbers::pi / 180;
            const core::Vec3 place =
                core::Vec3(7, 3, 40) + radii * brush.radius * core::Vec3(std::cos(angle), std::sin(angle), 0);
            return difference(colorAt(bare, camera, place), colorAt(tinted, camera, place));
        };
        for (int degrees = 0; degrees < 360; degrees += 10) {
            QVERIFY(change(degrees, 0.1) > 12);
            QVERIFY(change(degrees, 0.5) > 6);
            QVERIFY(std::abs(change(degrees, 0.7) - change(0, 0.7)) <= 3);
            QCOMPARE(change(degrees, 1.05), 0);
        }
    }

    /// Snake Hook moves everything within half its radius equally; Pull's weight decreases continuously. The tint shows
    /// this.
    void tint_isAsTheToolWeighs()
    {
        const ui::OrbitCamera camera = parallelCamera(40, true);
        Scene scene;
        scene.meshBuffer().apply(patchOf(gridBox({40, 40, 40}, 2)));
        const QImage bare = shot(scene, camera);
        const auto change = [&](core::Tool tool, double radii) {
            core::StrokeSettings brush;
            brush.tool = tool;
            brush.radius = 30;
            scene.tintBall({0, 0, 40}, brush);
            const core::Vec3 place(radii * brush.radius, 0, 40);
            return difference(colorAt(bare, camera, place), colorAt(shot(scene, camera), camera, place));
        };
        QVERIFY(change(core::Tool::SnakeHook, 0.45) >= change(core::Tool::SnakeHook, 0) - 1);
        QVERIFY(change(core::Tool::Pull, 0.45) < change(core::Tool::Pull, 0) - 3);
        QVERIFY(change(core::Tool::SnakeHook, 0.9) < change(core::Tool::SnakeHook, 0.45) - 3);
    }

    void tint_canBeSwitchedOff()
    {
        const ui::OrbitCamera camera = parallelCamera(40, true);
        Scene scene;
        const core::MeshPatch box = patchOf(gridBox({40, 40, 40}, 2));
        scene.meshBuffer().apply(box);
        const QImage bare = shot(scene, camera);
        core::StrokeSettings brush;
        brush.radius = 25;
        core::Footprint footprint;
        for (core::Slot v = 0; v < box.vertexSlots; ++v)
            footprint.slots.push_back(v);
        footprint.weights.assign(box.vertexSlots, 255);
        const auto all = std::make_shared<const core::Footprint>(footprint);
        for (const bool isBall : {true, false}) {
            if (isBall)
                scene.tintBall({0, 0, 40}, brush);
            else
                scene.tint(all);
            scene.setAppearance({}, false);
            QVERIFY(shot(scene, camera) != bare);
            scene.setAppearance({.tint = false}, false);
            QCOMPARE(shot(scene, camera), bare);
        }
    }
};

FETTLE_TEST(TestSurfaceShading, ui::TestApplication)
#include "tst_surface_shading.moc"
