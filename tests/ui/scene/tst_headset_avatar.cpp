#include "tests/support/test_main.h"
#include "tests/ui/sphere_model.h"
#include "tests/ui/ui_test.h"

#include "core/geometry/rotation.h"
#include "ui/viewport/head_tracking.h"

#include <QOpenGLExtraFunctions>
#include <QSignalSpy>
#include <QWheelEvent>

#include <numbers>

using ui::HeadsetAvatar;
using ui::OrbitCamera;
using ui::PointerInput;
using ui::ViewNavigation;
using ui::Viewport;

namespace
{
const QPoint onModel{200, 150}, besideModel{30, 40};

/// Model millimetres for each metre of the room. The model has been enlarged in VR, so people are small beside it.
constexpr double metre = 120;

/// A viewport with a ball, and answers to its hover requests.
struct Stage
{
    Stage()
    {
        viewport.resize(400, 300);
        viewport.setPatchSource([this] { return std::exchange(next, std::nullopt); });
        QObject::connect(
            viewport.input(), &PointerInput::hoverRequested, &viewport,
            [this](const core::Ray& ray) { viewport.input()->setHover(model.hit(ray)); }, Qt::QueuedConnection);
        viewport.showModel(model.box());
        viewport.show();
        QVERIFY(QTest::qWaitForWindowExposed(&viewport));
        next = model.whole();
        viewport.patchReady();
        QTRY_COMPARE(viewport.stats().patches, quint64(1));
    }

    QImage picture() { return viewport.grabFramebuffer(); }
    const OrbitCamera& camera() const { return viewport.camera(); }
    /// Returns the point at a pixel, at the depth of the model's centre.
    core::Vec3 at(QPoint pixel) const
    {
        return camera().acrossPivot(camera().ray({double(pixel.x()), double(pixel.y())}));
    }

    void drag(QPoint from, Qt::MouseButton button)
    {
        sendMouse(&viewport, QEvent::MouseButtonPress, from, button);
        for (int i = 1; i <= 5; ++i)
            sendMouse(&viewport, QEvent::MouseMove, from + QPoint(4 * i, 2 * i));
        sendMouse(&viewport, QEvent::MouseButtonRelease, from + QPoint(20, 10), button);
        QCoreApplication::processEvents();
    }

    SphereModel model;
    std::optional<core::MeshPatch> next;
    ui::BrushSettings brush;
    Viewport viewport{&brush};
};

Eigen::Isometry3d poseAt(const core::Vec3& place)
{
    return Eigen::Isometry3d(Eigen::Translation3d(place));
}

/// Returns a head pose at `place` that looks at the origin.
Eigen::Isometry3d lookingAtOrigin(const core::Vec3& place)
{
    Eigen::Isometry3d pose = poseAt(place);
    pose.linear() = core::rotationBetween(-core::Vec3::UnitZ(), -place).toRotationMatrix();
    return pose;
}

/// Returns a ball of 5 cm radius at `place`.
ui::GhostMesh ballAt(const core::Vec3& place)
{
    static const auto shape = [] {
        const SphereModel ball(0.05, 3);
        auto arrays = std::make_shared<core::DrawArrays>();
        for (const core::Vec3f& point : ball.mesh.points)
            arrays->vertices.push_back(SphereModel::draw(point));
        arrays->faces = ball.mesh.triangles;
        return arrays;
    }();
    return {shape, poseAt(place)};
}

HeadsetAvatar avatarAt(const core::Vec3& place)
{
    HeadsetAvatar avatar;
    avatar.head = lookingAtOrigin(place);
    avatar.metre = metre;
    return avatar;
}

QRect around(QPoint pixel, int distance)
{
    return QRect(pixel - QPoint(distance, distance), pixel + QPoint(distance, distance));
}

double turnOf(const OrbitCamera& camera, const Eigen::Isometry3d& head)
{
    return std::acos(std::clamp(camera.viewDirection().dot(-head.linear().col(2)), -1.0, 1.0));
}

OrbitCamera cameraOnBall()
{
    OrbitCamera camera;
    camera.setViewport(400, 300);
    camera.frame(core::Box(core::Vec3::Constant(-50), core::Vec3::Constant(50)));
    return camera;
}
} // namespace

/// Tests how the viewport shows the person in VR.
class TestHeadsetAvatar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKIP_WITHOUT_GRAPHICS(); }

    void ghosts_areWhereTheyShouldBe_data();
    void ghosts_areWhereTheyShouldBe();
    void clay_hidesThem();
    void bothModes_showThem();
    void drawing_isCoalesced();
    void pressOnAGhost_isAPressBesideTheModel();
    void modelAndView_areNotTheirs();

    void following_isTheSameInFewStepsAndInMany();
    void following_staysLevel();
    void following_standsStraightUpAndDown();
    void following_goesWhereTheHeadIs();
    void following_showsNoHead();
    void following_needsAnAvatar();
    void following_ends_data();
    void following_ends();
    void following_goesOnWithAnotherModel();
    void following_waitsForAStroke();
    void appearanceChanges_areReported();
};

void TestHeadsetAvatar::ghosts_areWhereTheyShouldBe_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("reach"); // mm, extent of the visible part
    QTest::newRow("head") << QStringLiteral("head") << 28;
    QTest::newRow("left hand") << QStringLiteral("left") << 7;
    QTest::newRow("right hand") << QStringLiteral("right") << 7;
    QTest::newRow("brush") << QStringLiteral("brush") << 11;
}

void TestHeadsetAvatar::ghosts_areWhereTheyShouldBe()
{
    QFETCH(QString, what);
    QFETCH(int, reach);
    Stage s;
    const QImage bare = s.picture();
    const QPoint pixel(60, 100);
    HeadsetAvatar avatar;
    avatar.metre = metre;
    if (what == QStringLiteral("head"))
        avatar.head = lookingAtOrigin(s.at(pixel));
    else if (what == QStringLiteral("brush"))
        avatar.brush = core::Sphere{s.at(pixel), 10};
    else
        avatar.hands[what == QStringLiteral("left") ? 0 : 1] = ballAt(s.at(pixel));

    s.viewport.showAvatar(avatar);
    const QRect area = changed(bare, s.picture());
    QVERIFY(around(pixel, qCeil(reach * s.camera().pixelsPerMm(s.at(pixel))) + 1).contains(area));
    QVERIFY(area.contains(pixel) && area.width() > 10 && area.height() > 10);

    s.viewport.showAvatar({});
    QCOMPARE(changed(bare, s.picture()), QRect());
}

void TestHeadsetAvatar::clay_hidesThem()
{
    Stage s;
    const QImage bare = s.picture();
    s.viewport.showAvatar(avatarAt(85 * s.camera().viewDirection()));
    QCOMPARE(changed(bare, s.picture()), QRect());
    s.viewport.showAvatar(avatarAt(-85 * s.camera().viewDirection()));
    QVERIFY(changed(bare, s.picture()).contains(onModel));
}

void TestHeadsetAvatar::bothModes_showThem()
{
    constexpr QSize size(400, 300);
    const SphereModel model;
    const OrbitCamera camera = cameraOnBall();
    for (const auto mode : {ui::Scene::Mode::Qt3d, ui::Scene::Mode::OpenGl}) {
        ui::Scene scene(mode);
        scene.meshBuffer().apply(model.whole());
        const auto picture = [&] {
            const ui::Scene::Image image = scene.render(camera, size, 1);
            auto* gl = QOpenGLContext::currentContext()->extraFunctions();
            gl->glDeleteSync(static_cast<GLsync>(image.ready));
            QImage read(size, QImage::Format_RGBA8888);
            unsigned int framebuffer = 0;
            gl->glGenFramebuffers(1, &framebuffer);
            gl->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            gl->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.texture, 0);
            gl->glReadPixels(0, 0, size.width(), size.height(), GL_RGBA, GL_UNSIGNED_BYTE, read.bits());
            gl->glDeleteFramebuffers(1, &framebuffer);
            return read;
        };
        const QImage bare = picture();
        scene.showAvatar(avatarAt(-85 * camera.viewDirection()));
        QVERIFY(changed(bare, picture()).width() > 20);
        scene.showAvatar({});
        QCOMPARE(changed(bare, picture()), QRect());
    }
}

/// Many avatar updates while the window is busy cause few frames. The test sends one second of headset frames.
void TestHeadsetAvatar::drawing_isCoalesced()
{
    Stage s;
    QCoreApplication::processEvents();
    const quint64 frames = s.viewport.stats().frames;
    for (int i = 0; i < 90; ++i)
        s.viewport.showAvatar(avatarAt({100, i / 10.0, 0}));
    QTRY_VERIFY(s.viewport.stats().frames > frames);
    QTest::qWait(50);
    QVERIFY(s.viewport.stats().frames <= frames + 2);
}

void TestHeadsetAvatar::pressOnAGhost_isAPressBesideTheModel()
{
    Stage s;
    QSignalSpy began(s.viewport.input(), &PointerInput::strokeBegan);
    s.viewport.showAvatar(avatarAt(s.at(besideModel)));
    s.picture();
    const core::Vec3 direction = s.camera().viewDirection();
    s.drag(besideModel, Qt::LeftButton);
    QTRY_VERIFY(s.camera().viewDirection() != direction);
    QCOMPARE(began.size(), 0);

    s.viewport.showAvatar(avatarAt(-85 * s.camera().viewDirection())); // between the eye and the model
    s.picture();
    s.drag(onModel, Qt::LeftButton);
    QTRY_COMPARE(began.size(), 1);
}

void TestHeadsetAvatar::modelAndView_areNotTheirs()
{
    Stage s;
    const core::Box box = s.viewport.navigation()->box();
    const core::Vec3 eye = s.camera().eye();
    s.viewport.showAvatar(avatarAt({900, 0, 0}));
    s.picture();
    QVERIFY(s.viewport.navigation()->box().isApprox(box));
    s.viewport.navigation()->frame();
    QVERIFY(s.camera().eye().isApprox(eye));
}

void TestHeadsetAvatar::following_isTheSameInFewStepsAndInMany()
{
    const Eigen::Isometry3d head = lookingAtOrigin({200, 150, -90});
    OrbitCamera few = cameraOnBall(), many = cameraOnBall();
    for (int i = 0; i < 5; ++i)
        few.setPose(ui::headTrackingStep(few, head, 1.0 / 5));
    for (int i = 0; i < 144; ++i)
        many.setPose(ui::headTrackingStep(many, head, 1.0 / 144));
    QVERIFY(few.eye().isApprox(many.eye(), 1e-9));
    QVERIFY(few.viewDirection().isApprox(many.viewDirection(), 1e-9));

    const double left = (few.eye() - head.translation()).norm() / (cameraOnBall().eye() - head.translation()).norm();
    QVERIFY(std::abs(left - std::exp(-1 / 0.3)) < 1e-9);
}

/// The followed view is level, even if the head is tilted sideways.
void TestHeadsetAvatar::following_staysLevel()
{
    Eigen::Isometry3d head = lookingAtOrigin({0, 40, 200});
    const core::Vec3 ahead = -head.linear().col(2);
    head.linear() = head.linear() * Eigen::AngleAxisd(0.5, core::Vec3::UnitZ());
    OrbitCamera camera = cameraOnBall();
    camera.setPose(ui::headTrackingStep(camera, head, 60));
    QVERIFY(camera.viewDirection().isApprox(ahead, 1e-3));
    QCOMPARE(camera.right().y(), 0.0);
}

void TestHeadsetAvatar::following_standsStraightUpAndDown()
{
    for (const double pitch : {-0.5 * std::numbers::pi, 0.5 * std::numbers::pi}) {
        Eigen::Isometry3d head = poseAt({0, 200, 0});
        head.linear() = (Eigen::AngleAxisd(0.7, core::Vec3::UnitY()) * Eigen::AngleAxisd(pitch, core::Vec3::UnitX()))
                            .toRotationMatrix();
        OrbitCamera camera = cameraOnBall();
        camera.setPose(ui::headTrackingStep(camera, head, 60));
        QVERIFY(camera.viewDirection().isApprox(-head.linear().col(2), 1e-6));
        // the camera's up is the head's up, so the picture does not turn
        QVERIFY(camera.up().isApprox(head.linear().col(1), 1e-6));
    }
}

void TestHeadsetAvatar::following_goesWhereTheHeadIs()
{
    Stage s;
    const HeadsetAvatar avatar = avatarAt({180, 120, 100});
    s.viewport.showAvatar(avatar);
    QSignalSpy changes(s.viewport.navigation(), &ViewNavigation::followingChanged);
    s.viewport.navigation()->setFollowing(true);
    QVERIFY(s.viewport.navigation()->isFollowing());
    QTRY_VERIFY((s.camera().eye() - avatar.head->translation()).norm() < 0.5);
    QVERIFY(turnOf(s.camera(), *avatar.head) < 0.01);

    s.viewport.navigation()->setFollowing(false);
    QCOMPARE(changes.size(), 2);
    QVERIFY(s.camera().pivot().norm() < 50); // the pivot is still on the model
    s.viewport.navigation()->turnTo(OrbitCamera::Side::Front);
    s.viewport.navigation()->frame();
    OrbitCamera framed = cameraOnBall();
    framed.setPose(s.camera().pose());
    framed.frame(s.model.box());
    QVERIFY(s.camera().eye().isApprox(framed.eye(), 1e-6));
}

void TestHeadsetAvatar::following_showsNoHead()
{
    Stage s;
    const QImage bare = s.picture();
    s.viewport.showAvatar(avatarAt(s.at(besideModel)));
    QVERIFY(changed(bare, s.picture()).isValid());
    s.viewport.navigation()->setFollowing(true);
    QCOMPARE(changed(bare, s.picture()), QRect());
}

void TestHeadsetAvatar::following_needsAnAvatar()
{
    Stage s;
    QSignalSpy changes(s.viewport.navigation(), &ViewNavigation::followingChanged);
    s.viewport.navigation()->setFollowing(true);
    QVERIFY(!s.viewport.navigation()->isFollowing());
    s.viewport.showAvatar(avatarAt({100, 0, 0}));
    s.viewport.navigation()->setFollowing(true);
    s.viewport.showAvatar({});
    QVERIFY(!s.viewport.navigation()->isFollowing());
    QCOMPARE(changes.size(), 2);
}

void TestHeadsetAvatar::following_ends_data()
{
    QTest::addColumn<QString>("by");
    for (const char* by : {"turn", "move", "wheel", "frame", "side", "flight"})
        QTest::newRow(by) << QString::fromLatin1(by);
}

void TestHeadsetAvatar::following_ends()
{
    QFETCH(QString, by);
    Stage s;
    s.viewport.showAvatar(avatarAt({100, 0, 300}));
    s.viewport.navigation()->setFollowing(true);
    if (by == QStringLiteral("turn"))
        s.drag(besideModel, Qt::MiddleButton);
    else if (by == QStringLiteral("move"))
        s.drag(besideModel, Qt::RightButton);
    else if (by == QStringLiteral("wheel")) {
        QWheelEvent event(onModel, s.viewport.mapToGlobal(onModel), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&s.viewport, &event);
    } else if (by == QStringLiteral("frame"))
        s.viewport.navigation()->frame();
    else if (by == QStringLiteral("side"))
        s.viewport.navigation()->turnTo(OrbitCamera::Side::Top);
    else
        s.viewport.navigation()->flyTo({0, 50, 0}, {0, 1, 0}, 10);
    QVERIFY(!s.viewport.navigation()->isFollowing());
}

void TestHeadsetAvatar::following_goesOnWithAnotherModel()
{
    Stage s;
    s.viewport.showAvatar(avatarAt({100, 0, 300}));
    s.viewport.navigation()->setFollowing(true);
    s.viewport.showModel(s.model.box());
    s.viewport.navigation()->setView({});
    QVERIFY(s.viewport.navigation()->isFollowing());
}

/// Following the head waits until a stroke ends, because the pointer would otherwise lose its place on the model.
void TestHeadsetAvatar::following_waitsForAStroke()
{
    Stage s;
    sendMouse(&s.viewport, QEvent::MouseButtonPress, onModel, Qt::LeftButton);
    QTRY_VERIFY(s.viewport.input()->strokeOpen());
    s.viewport.showAvatar(avatarAt({300, 0, 0}));
    s.viewport.navigation()->setFollowing(true);
    const core::Vec3 eye = s.camera().eye();
    QTest::qWait(100);
    QCOMPARE(s.camera().eye(), eye);
    sendMouse(&s.viewport, QEvent::MouseButtonRelease, onModel, Qt::LeftButton);
    QTRY_VERIFY((s.camera().eye() - eye).norm() > 1);
}

void TestHeadsetAvatar::appearanceChanges_areReported()
{
    Stage s;
    QSignalSpy changes(&s.viewport, &Viewport::appearanceChanged);
    ui::ViewAppearance appearance = s.viewport.appearance();
    s.viewport.setAppearance(appearance);
    QCOMPARE(changes.size(), 0);
    appearance.material = ui::Material::Wax;
    s.viewport.setAppearance(appearance);
    QCOMPARE(changes.size(), 1);
    QCOMPARE(ui::shadingOf(s.viewport.appearance().material), ui::shadingOf(ui::Material::Wax));
}

FETTLE_TEST(TestHeadsetAvatar, ui::TestApplication)
#include "tst_headset_avatar.moc"
