#include "tests/support/test_main.h"
#include "tests/ui/scene/scene_picture.h"
#include "tests/ui/sphere_model.h"
#include "tests/ui/ui_test.h"

#include <QSet>

#include <numbers>

using ui::Scene;

namespace
{
constexpr QSize size{240, 180};

QImage read(const Scene::Image& image)
{
    return pixelsOf(image, size);
}

int differing(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

/// Returns the number of pixels in which a colour channel differs by more than `most`.
int unlike(const QImage& a, const QImage& b, int most)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            count += std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()),
                               std::abs(p.blue() - q.blue())}) > most;
        }
    return count;
}

void addModes()
{
    QTest::addColumn<Scene::Mode>("mode");
    QTest::newRow("by Qt3D") << Scene::Mode::Qt3d;
    QTest::newRow("by OpenGL") << Scene::Mode::OpenGl;
}

ui::OrbitCamera cameraOn(const SphereModel& model)
{
    ui::OrbitCamera camera;
    camera.setViewport(size.width(), size.height());
    camera.frame(model.box());
    return camera;
}
} // namespace

/// Tests clay and overlays in one image, with overlays drawn by Qt3D and by OpenGL.
class TestScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void qt3dDrawsIntoOurFramebufferHere()
    {
        const Scene scene;
        QVERIFY(scene.usable());
        QCOMPARE(scene.mode(), FETTLE_HAS_QT3D ? Scene::Mode::Qt3d : Scene::Mode::OpenGl);
    }

    void bothDrawTheSame_data();
    void bothDrawTheSame();

    void everythingIsDrawn_data() { addModes(); }

    void everythingIsDrawn()
    {
        QFETCH(Scene::Mode, mode);
        const SphereModel model;
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene(mode);
        QVERIFY(scene.usable());
        scene.placeGround(model.box());

        const QImage without = read(scene.render(camera, size, 1));
        scene.meshBuffer().apply(model.whole());
        const QImage with = read(scene.render(camera, size, 1));
        const QColor clay = with.pixelColor(size.width() / 2, size.height() / 2);
        QVERIFY(clay.red() > clay.blue() + 20); // warm clay colour
        QVERIFY(differing(without, with) > size.width() * size.height() / 8);
        QCOMPARE(with.pixel(2, 2), without.pixel(2, 2));

        const auto hit = model.hit(camera.ray({120, 90}));
        QVERIFY(hit);
        scene.placeCursor(*hit, 15, Qt::white);
        const QImage cursor = read(scene.render(camera, size, 1));
        QVERIFY(differing(with, cursor) > 50);
        QVERIFY(differing(with, cursor) < 2000);
        scene.hideCursor();
        QCOMPARE(differing(with, read(scene.render(camera, size, 1))), 0);
    }

    /// The part of a ring behind the ball is dimmed, not hidden.
    void whatClayHidesIsDimmed()
    {
        const SphereModel model;
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene;
        scene.meshBuffer().apply(model.whole());
        const QImage bare = read(scene.render(camera, size, 1));
        const auto change = [&](const core::Vec3& at) {
            scene.placeCursor({at, -camera.viewDirection(), 0, 0}, 10, Qt::white);
            const QImage picture = read(scene.render(camera, size, 1));
            double sum = 0;
            for (int y = 0; y < size.height(); ++y)
                for (int x = 0; x < size.width(); ++x)
                    sum += std::abs(qGray(picture.pixel(x, y)) - qGray(bare.pixel(x, y)));
            return sum;
        };
        const core::Vec3 front = -51 * camera.viewDirection();
        const double seen = change(front), hidden = change(-front);
        QVERIFY(hidden > 0);
        QVERIFY(hidden < seen / 2);
    }

    /// Seen from the front, the plane of symmetry X is a line through the middle of the ball, and Z is a border around
    /// the ball.
    void thePlaneOfSymmetryIsShown_data()
    {
        QTest::addColumn<Scene::Mode>("mode");
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << Scene::Mode::Qt3d << false;
        QTest::newRow("dark") << Scene::Mode::Qt3d << true;
        QTest::newRow("by OpenGL") << Scene::Mode::OpenGl << false;
    }

    void thePlaneOfSymmetryIsShown()
    {
        QFETCH(Scene::Mode, mode);
        QFETCH(bool, dark);
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        Scene scene(mode);
        scene.setAppearance({}, dark);
        scene.meshBuffer().apply(model.whole());
        const auto picture = [&] { return read(scene.render(camera, size, 1)); };
        const auto changes = [&](const QImage& a, const QImage& b, int x) { return a.pixel(x, 90) != b.pixel(x, 90); };

        camera.turnTo(ui::OrbitCamera::Side::Front);
        const QImage without = picture();
        scene.showPlane(core::Symmetry::X, model.box());
        const QImage edgeOn = picture();
        QVERIFY(changes(without, edgeOn, 119) && changes(without, edgeOn, 120));
        for (const int aside : {90, 110, 130, 150})
            QVERIFY(!changes(without, edgeOn, aside));

        scene.showPlane(core::Symmetry::Z, model.box());
        QVERIFY(differing(without, picture()) > 500); // the border of plane Z around the ball
        scene.showPlane(core::Symmetry::None, model.box());
        QCOMPARE(differing(without, picture()), 0);
    }

    void whereSectorsMeetIsShown_data() { thePlaneOfSymmetryIsShown_data(); }

    /// Sector borders, seen from above, are lines around the ball: to the front and at each quarter turn. Nothing is
    /// drawn between the lines or on the ball.
    void whereSectorsMeetIsShown()
    {
        QFETCH(Scene::Mode, mode);
        QFETCH(bool, dark);
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        camera.setProjection(ui::OrbitCamera::Projection::Orthographic);
        camera.turnTo(ui::OrbitCamera::Side::Top);
        Scene scene(mode);
        scene.setAppearance({}, dark);
        scene.meshBuffer().apply(model.whole());
        const auto picture = [&] { return read(scene.render(camera, size, 1)); };
        const QImage without = picture();
        scene.showSectors(4, core::Symmetry::None, model.box());
        const QImage with = picture();
        const double reach = 1.15 * model.box().max().x();
        const auto isLineAt = [&](double degrees) {
            const double angle = degrees * std::numbers::pi / 180;
            const core::Vec3 along(std::sin(angle), 0, std::cos(angle));
            const auto at = camera.project(reach * along + model.box().min().y() * core::Vec3::UnitY());
            const QPoint pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
            return with.pixel(pixel) != without.pixel(pixel);
        };
        for (const double degrees : {0.0, 90.0, 180.0, 270.0})
            QVERIFY(isLineAt(degrees));
        for (const double degrees : {30.0, 45.0, 135.0, 225.0, 300.0})
            QVERIFY(!isLineAt(degrees));
        QCOMPARE(with.pixel(130, 95), without.pixel(130, 95));
        scene.showSectors(1, core::Symmetry::None, model.box());
        QCOMPARE(differing(without, picture()), 0);
    }

    void eachMaterialAndBackgroundLooksDifferent()
    {
        const SphereModel model;
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene;
        scene.meshBuffer().apply(model.whole());
        QSet<QRgb> clays, corners;
        for (const auto& row : ui::materials) {
            scene.setAppearance({.material = row.value}, false);
            clays << read(scene.render(camera, size, 1)).pixel(105, 75);
        }
        QCOMPARE(clays.size(), qsizetype(ui::materials.size()));
        for (const auto& row : ui::backgrounds) {
            scene.setAppearance({.background = row.value}, false);
            corners << read(scene.render(camera, size, 1)).pixel(2, 2);
        }
        QVERIFY(corners.contains(qRgb(255, 255, 255)) && corners.contains(qRgb(0, 0, 0)));
        QCOMPARE(corners.size(), qsizetype(ui::backgrounds.size() - 1)); // Theme equals Light here
        scene.setAppearance({}, true);
        const QRgb themed = read(scene.render(camera, size, 1)).pixel(2, 2);
        scene.setAppearance({.background = ui::Background::Dark}, false);
        QCOMPARE(read(scene.render(camera, size, 1)).pixel(2, 2), themed);
    }

    /// Blue paint appears blue, whatever the clay's colour.
    void paintIsShownAsItIs()
    {
        SphereModel model;
        core::MeshPatch patch = model.whole();
        for (core::DrawVertex& vertex : patch.vertices)
            vertex.color = {40, 80, 220, 255};
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene;
        scene.meshBuffer().apply(patch);
        scene.setAppearance({.material = ui::Material::Paint}, false);
        const QColor seen = read(scene.render(camera, size, 1)).pixelColor(size.width() / 2, size.height() / 2);
        QVERIFY(std::abs(seen.hsvHue() - QColor(40, 80, 220).hsvHue()) < 15);
    }

    /// Flat shading has a step where two triangles meet.
    void flatShadesWholeTriangles()
    {
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        camera.zoom(0.45, {120, 90});
        Scene scene;
        scene.meshBuffer().apply(model.whole());
        const auto steepest = [&](bool flat) {
            scene.setAppearance({.flat = flat}, false);
            const QImage picture = read(scene.render(camera, size, 1));
            int most = 0;
            for (int y = 60; y < 120; ++y)
                for (int x = 60; x < 180; ++x)
                    most = std::max(most, std::abs(qGray(picture.pixel(x, y)) - qGray(picture.pixel(x - 1, y))));
            return most;
        };
        QVERIFY(steepest(true) >= 3 * std::max(steepest(false), 1));
    }

    /// Wires are drawn along the edges and nowhere else; free faces have none.
    void wiresLieOnTheEdges()
    {
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        camera.zoom(0.45, {120, 90});
        Scene scene;
        scene.meshBuffer().apply(model.whole());
        const QImage bare = read(scene.render(camera, size, 1));
        scene.setAppearance({.wireframe = true}, false);
        const QImage wired = read(scene.render(camera, size, 1));
        const auto darkerAt = [&](const core::Vec3& point) {
            const ui::OrbitCamera::Pixel at = camera.project(point);
            const QPoint p(static_cast<int>(at.x()), static_cast<int>(at.y()));
            int most = -1;
            for (const QPoint q : {p, p + QPoint(1, 0), p - QPoint(1, 0), p + QPoint(0, 1), p - QPoint(0, 1)})
                if (bare.rect().contains(q))
                    most = std::max(most, qGray(bare.pixel(q)) - qGray(wired.pixel(q)));
            return most;
        };
        int edges = 0;
        for (const core::Triangle& face : model.mesh.triangles) {
            const core::Vec3 a = model.mesh.points[face[0]].cast<double>(),
                             b = model.mesh.points[face[1]].cast<double>(),
                             c = model.mesh.points[face[2]].cast<double>();
            if ((b - a).cross(c - a).normalized().dot(camera.viewDirection()) > -0.9 || darkerAt(0.5 * (a + b)) < 0)
                continue;
            ++edges;
            QVERIFY(darkerAt(0.5 * (a + b)) > 10);
            QVERIFY(darkerAt((a + b + c) / 3) <= 0);
        }
        QVERIFY(edges > 4);
    }

    /// The vertices of the footprint are tinted, and no others, on every clay. A new tint replaces the earlier one.
    void whatTheBrushWouldTakeIsTinted_data() { addModes(); }

    void whatTheBrushWouldTakeIsTinted()
    {
        QFETCH(Scene::Mode, mode);
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        camera.turnTo(ui::OrbitCamera::Side::Front);
        Scene scene(mode);
        scene.meshBuffer().apply(model.whole());
        core::StrokeSettings brush;
        brush.radius = 15;
        const auto at = [&](double x) { return core::Vec3(x, 0, std::sqrt(2500 - x * x)); };
        const auto footprint = [&](const core::Vec3& center) {
            core::Footprint made;
            for (core::Slot v = 0; v < model.vertices(); ++v) {
                const double x = (model.mesh.points[v].cast<double>() - center).norm() / brush.radius;
                if (x <= 1) {
                    made.slots.push_back(v);
                    made.weights.push_back(static_cast<std::uint8_t>(1 + 254 * core::falloff(x, brush.falloff)));
                }
            }
            return std::make_shared<const core::Footprint>(made);
        };
        const auto picture = [&] { return read(scene.render(camera, size, 1)); };
        const auto differs = [&](const QImage& a, const QImage& b, const core::Vec3& place) {
            const ui::OrbitCamera::Pixel p = camera.project(place);
            const QColor one = a.pixelColor(static_cast<int>(p.x()), static_cast<int>(p.y()));
            const QColor other = b.pixelColor(static_cast<int>(p.x()), static_cast<int>(p.y()));
            return std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                             std::abs(one.blue() - other.blue())});
        };
        for (const auto& row : ui::materials) {
            scene.setAppearance({.material = row.value}, false);
            const QImage bare = picture();
            scene.tintBall(at(20), brush);
            const QImage ball = picture();
            QVERIFY(differs(bare, ball, at(20)) > 15 && differs(bare, ball, at(30)) > 0);
            QCOMPARE(differs(bare, ball, at(-20)), 0);
            scene.tint(footprint(at(-20)));
            const QImage slots = picture();
            QVERIFY(differs(bare, slots, at(-20)) > 15 && differs(bare, slots, at(-30)) > 0);
            QCOMPARE(differs(bare, slots, at(20)), 0);
            scene.tint(footprint(at(20)));
            QVERIFY(unlike(ball, picture(), 3) < 20); // per-vertex tints are interpolated, so small differences remain
            QCOMPARE(differs(bare, picture(), at(-20)), 0);
            brush.symmetry = core::Symmetry::X;
            scene.tintBall(at(20), brush);
            QVERIFY(differs(bare, picture(), at(20)) > 15 && differs(bare, picture(), at(-20)) > 15);
            brush.symmetry = core::Symmetry::None;
            brush.radial = 8;
            scene.tintBall(at(20), brush);
            QVERIFY(differs(bare, picture(), at(20)) > 15 && differs(bare, picture(), at(-20)) > 15);
            brush.radial = 1;
            scene.tint(nullptr);
            QCOMPARE(differing(bare, picture()), 0);
        }
    }

    /// A tint does not survive a new mesh, in whichever order tint and patch arrive; invalid slots are ignored.
    void aTintOutlivesNoModel()
    {
        const SphereModel model, small(50, 2);
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene;
        scene.meshBuffer().apply(small.whole());
        const QImage bare = read(scene.render(camera, size, 1));
        const auto all = [](core::Slot slots) {
            core::Footprint made;
            for (core::Slot v = 0; v < slots; ++v)
                made.slots.push_back(v);
            made.weights.assign(slots, 255);
            return std::make_shared<const core::Footprint>(made);
        };
        scene.meshBuffer().apply(model.whole());
        scene.tint(all(model.vertices()));
        scene.meshBuffer().apply(small.whole());
        QCOMPARE(differing(bare, read(scene.render(camera, size, 1))), 0);
        scene.tint(all(model.vertices()));
        QVERIFY(differing(bare, read(scene.render(camera, size, 1))) > 1000);
        scene.tint(nullptr);
        QCOMPARE(differing(bare, read(scene.render(camera, size, 1))), 0);
    }

    void theGroundCanBeHidden()
    {
        const SphereModel model;
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene;
        scene.placeGround(model.box());
        const QImage with = read(scene.render(camera, size, 1));
        scene.setAppearance({.ground = false}, false);
        const QImage without = read(scene.render(camera, size, 1));
        QVERIFY(differing(with, without) > 1000);
        scene.placeGround(model.box());
        QCOMPARE(differing(without, read(scene.render(camera, size, 1))), 0);
    }

    void aNewSizeIsRightAtOnce()
    {
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        for (const auto mode : {Scene::Mode::Qt3d, Scene::Mode::OpenGl}) {
            Scene scene(mode);
            scene.meshBuffer().apply(model.whole());
            scene.placeCursor(*model.hit(camera.ray({120, 90})), 15, Qt::white);
            const QImage before = read(scene.render(camera, size, 1));
            const Scene::Image other = scene.render(camera, size * 2, 2);
            QVERIFY(other.texture);
            QOpenGLContext::currentContext()->extraFunctions()->glDeleteSync(static_cast<GLsync>(other.ready));
            QCOMPARE(differing(before, read(scene.render(camera, size, 1))), 0);
        }
    }
};

void TestScene::bothDrawTheSame_data()
{
    QTest::addColumn<ui::OrbitCamera::Projection>("projection");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<double>("pixelRatio");
    using enum ui::OrbitCamera::Projection;
    QTest::newRow("perspective") << Perspective << false << 1.0;
    QTest::newRow("perspective, dark") << Perspective << true << 2.0;
    QTest::newRow("orthographic") << Orthographic << false << 2.0;
}

/// Checks that pictures with all overlays differ in hardly any pixel, whichever renderer draws them, from several
/// sides.
void TestScene::bothDrawTheSame()
{
    QFETCH(ui::OrbitCamera::Projection, projection);
    QFETCH(bool, dark);
    QFETCH(double, pixelRatio);
    const SphereModel model;
    ui::OrbitCamera camera = cameraOn(model);
    camera.setProjection(projection);
    Scene byQt3d(Scene::Mode::Qt3d), byOpenGl(Scene::Mode::OpenGl);
    if (!FETTLE_HAS_QT3D)
        QSKIP("This build has no Qt3D to compare with");
    QCOMPARE(byQt3d.mode(), Scene::Mode::Qt3d);
    const auto picture = [&](Scene& scene, bool withOverlays) {
        scene.setAppearance({.ground = withOverlays}, dark);
        scene.meshBuffer().apply(model.whole());
        scene.placeGround(model.box());
        if (withOverlays) {
            const core::Vec3 top(0, model.box().max().y(), 0), side(model.box().max().x(), 0, 0);
            scene.placeCursor({top, core::Vec3::UnitY(), 0, 0}, 15, Qt::white);
            scene.showMark(side, core::Vec3::UnitX(), 10);
            scene.showPlane(core::Symmetry::X, model.box());
            scene.showSectors(6, core::Symmetry::X, model.box());
        } else {
            scene.hideCursor();
            scene.hideMark();
            scene.showPlane(core::Symmetry::None, model.box());
            scene.showSectors(1, core::Symmetry::None, model.box());
        }
        return read(scene.render(camera, size, pixelRatio));
    };
    for (int view = 0; view < 6; ++view) {
        camera.orbit({37, view == 5 ? -90 : 11});
        const QImage a = picture(byQt3d, true), b = picture(byOpenGl, true);
        QVERIFY(unlike(a, picture(byQt3d, false), 8) > 800);
        // rounded matrices cover or hide a sample more or less at some edges
        QVERIFY2(unlike(a, b, 2) <= size.width() * size.height() / 1000, qPrintable(QString::number(unlike(a, b, 2))));
        QCOMPARE(unlike(a, b, 32), 0);
    }
}

FETTLE_TEST(TestScene, ui::TestApplication)
#include "tst_scene.moc"
