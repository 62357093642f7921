#include "sphere_model.h"
#include "ui_test.h"

#include <QImage>
#include <QOpenGLExtraFunctions>

using ui::Scene;

namespace
{
constexpr QSize size{240, 180};

/// The scene's context is current, as it is after render().
QImage read(const Scene::Image& image)
{
    QOpenGLExtraFunctions* gl = QOpenGLContext::currentContext()->extraFunctions();
    gl->glWaitSync(static_cast<GLsync>(image.ready), 0, GL_TIMEOUT_IGNORED);
    gl->glDeleteSync(static_cast<GLsync>(image.ready));
    GLuint framebuffer = 0;
    gl->glGenFramebuffers(1, &framebuffer);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.texture, 0);
    QImage picture(size, QImage::Format_RGBA8888);
    gl->glReadPixels(0, 0, size.width(), size.height(), GL_RGBA, GL_UNSIGNED_BYTE, picture.bits());
    gl->glDeleteFramebuffers(1, &framebuffer);
    return picture.mirrored();
}

int differing(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

ui::OrbitCamera cameraOn(const SphereModel& model)
{
    ui::OrbitCamera camera;
    camera.setViewport(size.width(), size.height());
    camera.frame(model.box());
    return camera;
}
} // namespace

/// Clay, ground and cursor in one image, the way the driver allows and the other way.
class TestScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void qt3dDrawsIntoOurFramebufferHere()
    {
        const Scene scene;
        QVERIFY(scene.usable());
        QCOMPARE(scene.mode(), Scene::Mode::InQt3dContext);
    }

    void everythingIsDrawn_data()
    {
        QTest::addColumn<bool>("layered");
        QTest::newRow("in Qt3D's context") << false;
        QTest::newRow("in layers") << true;
    }

    void everythingIsDrawn()
    {
        QFETCH(bool, layered);
        const SphereModel model;
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene(layered ? Scene::Mode::Layered : Scene::Mode::InQt3dContext);
        QVERIFY(scene.usable());
        scene.placeGround(model.box());

        const QImage without = read(scene.render(camera, size, 1));
        scene.clay().apply(model.whole());
        const QImage with = read(scene.render(camera, size, 1));
        const QColor clay = with.pixelColor(size.width() / 2, size.height() / 2);
        QVERIFY(clay.red() > clay.blue() + 20); // warm
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

    /// A ring that lies behind the ball is dimmed, not gone.
    void whatClayHidesIsDimmed()
    {
        const SphereModel model;
        const ui::OrbitCamera camera = cameraOn(model);
        Scene scene;
        scene.clay().apply(model.whole());
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

    /// From the front: a line through the middle of the ball, nothing else on it, and a pane's border beyond it.
    void thePlaneOfSymmetryIsShown_data()
    {
        QTest::addColumn<bool>("layered");
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false << false;
        QTest::newRow("dark") << false << true;
        QTest::newRow("in layers") << true << false;
    }

    void thePlaneOfSymmetryIsShown()
    {
        QFETCH(bool, layered);
        QFETCH(bool, dark);
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        Scene scene(layered ? Scene::Mode::Layered : Scene::Mode::InQt3dContext);
        scene.setDark(dark);
        scene.clay().apply(model.whole());
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
        QCOMPARE(differing(without, picture()) > 500, !layered); // the pane, around the ball
        scene.showPlane(core::Symmetry::None, model.box());
        QCOMPARE(differing(without, picture()), 0);
    }

    void aNewSizeIsRightAtOnce()
    {
        const SphereModel model;
        ui::OrbitCamera camera = cameraOn(model);
        for (const auto mode : {Scene::Mode::InQt3dContext, Scene::Mode::Layered}) {
            Scene scene(mode);
            scene.clay().apply(model.whole());
            scene.placeCursor(*model.hit(camera.ray({120, 90})), 15, Qt::white);
            const QImage before = read(scene.render(camera, size, 1));
            const Scene::Image other = scene.render(camera, size * 2, 2);
            QVERIFY(other.texture);
            QOpenGLContext::currentContext()->extraFunctions()->glDeleteSync(static_cast<GLsync>(other.ready));
            QCOMPARE(differing(before, read(scene.render(camera, size, 1))), 0);
        }
    }
};

UI_TEST_MAIN(TestScene)
#include "tst_scene.moc"
