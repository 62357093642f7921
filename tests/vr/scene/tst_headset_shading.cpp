// Compares the clay drawn for the desktop with the clay drawn for an eye of the headset at the same place.
#include "tests/support/test_main.h"
#include "tests/ui/sphere_model.h"
#include "tests/vr/gl/offscreen_gl.h"

#include "ui/scene/mesh_renderer.h"
#include "vr/scene/scene.h"

#include "core/stroke/symmetry_plane.h"

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVersionFunctionsFactory>

namespace
{
constexpr QSize size(240, 180);

struct Difference
{
    int compared = 0, most = 0;
};

/// Compares the pixels where the mask shows clay. Returns their number and the largest difference of a colour channel,
/// 0 to 255.
Difference difference(const QImage& a, const QImage& b, const QImage& mask)
{
    Difference result;
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            if (qAlpha(mask.pixel(x, y)) == 0)
                continue;
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            ++result.compared;
            result.most = std::max({result.most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                    std::abs(qBlue(p) - qBlue(q))});
        }
    return result;
}
} // namespace

class TestHeadsetShading : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanup() { QCOMPARE(m_offscreen->error(), 0U); }
    void cleanupTestCase()
    {
        m_painter.destroy();
        m_scene.destroy();
    }

    void clay_looksAsOnTheDesktop_data();
    void clay_looksAsOnTheDesktop();
    void headsTurn_changesNoShade();

private:
    void show(bool isSharp);
    QImage desktop(const ui::MeshView& picture);
    /// Returns the scene with the model scaled to metres, moved and turned in the room, and with the head at the
    /// desktop camera's place.
    vr::SceneState state(const core::Shading& shading) const;
    /// Returns an eye with the camera's field of view.
    vr::EyeView eye(const vr::Pose& pose, const TestImage& image) const;
    QImage headset(const vr::SceneState& state, const vr::EyeView& view, const TestImage& image);

    std::unique_ptr<OffscreenGl> m_offscreen;
    ui::MeshRenderer m_painter;
    vr::Scene m_scene;
    ui::OrbitCamera m_camera;
    SphereModel m_model;
    QImage m_mask; ///< transparent where there is no clay
};

void TestHeadsetShading::initTestCase()
{
    m_offscreen = std::make_unique<OffscreenGl>();
    if (!m_offscreen->isUsable())
        QSKIP("no OpenGL 3.3 here");
    QVERIFY(m_painter.create(
        QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(QOpenGLContext::currentContext())));
    QVERIFY(m_scene.create(m_offscreen->gl()));
    show(false);
    m_camera.setViewport(size.width(), size.height());
    m_camera.frame(m_model.box());

    m_mask = QImage(size, QImage::Format_ARGB32);
    m_mask.fill(Qt::transparent);
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            const core::Ray ray = m_camera.ray({x + 0.5, y + 0.5});
            const double nearest = ray.origin.cross(ray.direction.normalized()).norm();
            if (nearest < 49)
                m_mask.setPixel(x, y, 0xFFFFFFFF);
        }
}

/// Shows a ball with paint on one side and hollow curvature on the other. `isSharp`: with a sharp edge at each vertex
/// of its top.
void TestHeadsetShading::show(bool isSharp)
{
    core::MeshPatch patch = m_model.whole();
    for (core::DrawVertex& vertex : patch.vertices) {
        if (vertex.position.x() > 20)
            vertex.color = {40, 90, 230, core::DrawVertex::flat};
        else if (vertex.position.x() < -20)
            vertex.color[3] = 40;
        if (isSharp && vertex.position.y() > 10)
            vertex.crease = {127, 0, 0, 127};
    }
    m_painter.meshBuffer().apply(patch);
    m_scene.apply(patch);
}

QImage TestHeadsetShading::desktop(const ui::MeshView& picture)
{
    const TestImage image(m_offscreen->gl(), size, GL_RGBA8);
    m_offscreen->gl()->glDisable(GL_FRAMEBUFFER_SRGB);
    m_offscreen->gl()->glBindFramebuffer(GL_FRAMEBUFFER, image.framebuffer());
    m_offscreen->gl()->glViewport(0, 0, size.width(), size.height());
    m_painter.draw(m_camera, picture);
    return image.read();
}

vr::SceneState TestHeadsetShading::state(const core::Shading& shading) const
{
    vr::SceneState state;
    state.model = Eigen::Translation3d(0.4, 1.2, -0.7) * Eigen::AngleAxisd(1.1, core::Vec3::UnitY()) *
                  Eigen::UniformScaling(0.0037);
    state.box = m_model.box();
    state.shading = shading;
    state.hasFloor = false;
    const Eigen::Matrix4d fromEye = m_camera.viewMatrix().inverse();
    const Eigen::Matrix3d turn = state.model.linear() / std::cbrt(state.model.linear().determinant());
    state.head = {Eigen::Quaterniond(Eigen::Matrix3d(turn * fromEye.topLeftCorner<3, 3>())),
                  state.model * core::Vec3(fromEye.col(3).head<3>())};
    return state;
}

vr::EyeView TestHeadsetShading::eye(const vr::Pose& pose, const TestImage& image) const
{
    vr::EyeView view = eyeAt(pose, {}, image);
    const double upward = 1 / m_camera.projectionMatrix()(1, 1), sideways = 1 / m_camera.projectionMatrix()(0, 0);
    view.projection = projectionOf({sideways, sideways, upward, upward});
    return view;
}

QImage TestHeadsetShading::headset(const vr::SceneState& state, const vr::EyeView& view, const TestImage& image)
{
    m_scene.prepare(state);
    m_scene.draw(view);
    return image.read();
}

void TestHeadsetShading::clay_looksAsOnTheDesktop_data()
{
    QTest::addColumn<int>("material");
    QTest::addColumn<bool>("flat");
    QTest::addColumn<bool>("mirrored");
    QTest::addColumn<bool>("cavity");
    QTest::addColumn<bool>("sharp");
    for (const auto& row : ui::materials)
        QTest::newRow(row.key) << static_cast<int>(row.value) << false << false << false << false;
    QTest::newRow("flat") << 0 << true << false << false << false;
    QTest::newRow("cut by the plane of symmetry") << 0 << false << true << false << false;
    QTest::newRow("cavity") << 0 << false << false << true << false;
    QTest::newRow("sharp edges") << 0 << false << false << false << true;
}

void TestHeadsetShading::clay_looksAsOnTheDesktop()
{
    QFETCH(int, material);
    QFETCH(bool, flat);
    QFETCH(bool, mirrored);
    QFETCH(bool, cavity);
    QFETCH(bool, sharp);
    show(sharp);
    const core::Shading shading = ui::shadingOf(static_cast<ui::Material>(material));
    const core::Symmetry symmetry = mirrored ? core::Symmetry::X : core::Symmetry::None;
    m_painter.setCut({core::planeNormal(symmetry)});
    const QImage onDesktop =
        desktop({.backdrop = {}, .shading = shading, .flat = flat, .cavity = cavity, .pixels = size});

    vr::SceneState shown = state(shading);
    shown.isFlat = flat;
    shown.hasCavity = cavity;
    shown.symmetry = symmetry;
    shown.box.setEmpty(); // no plane in front of the mesh
    const TestImage image(m_offscreen->gl(), size);
    const Difference found = difference(onDesktop, headset(shown, eye(shown.head, image), image), m_mask);
    show(false);
    QVERIFY(found.compared > 5000);
    QVERIFY2(found.most <= 2, qPrintable(QString::number(found.most)));
}

/// Checks that turning the head does not change the shading: the lights follow the viewer's position around the model,
/// but not the head's rotation.
void TestHeadsetShading::headsTurn_changesNoShade()
{
    vr::SceneState shown = state(ui::shadingOf(ui::Material::Clay));
    const TestImage image(m_offscreen->gl(), size);
    const vr::Pose straight = shown.head;
    const vr::EyeView ahead = eye(straight, image);
    const QImage before = headset(shown, ahead, image);
    shown.head.rotation = shown.head.rotation * Eigen::AngleAxisd(0.15, core::Vec3(1, 1, 0.7).normalized());
    const vr::EyeView aside = eye(shown.head, image);
    const QImage after = headset(shown, aside, image);
    const auto seen = [&](const QImage& picture, const vr::EyeView& view, const core::Vec3& point) {
        const core::Vec3f eyeSpace = view.view * (shown.model * point).cast<float>();
        const Eigen::Vector4f clip = view.projection * eyeSpace.homogeneous();
        return qGray(
            picture.pixel(static_cast<int>((1 + clip.x() / clip.w()) / 2 * static_cast<float>(size.width())),
                          static_cast<int>((1 - clip.y() / clip.w()) / 2 * static_cast<float>(size.height()))));
    };
    const core::Vec3 back = shown.model.linear().transpose() * (straight.position - shown.model.translation());
    int compared = 0, darkest = 255, lightest = 0;
    for (const core::Vec3f& vertex : m_model.mesh.points) {
        const core::Vec3 point = vertex.cast<double>();
        if (point.normalized().dot(back.normalized()) < 0.6 ||
            std::abs(point.x() - 20) < 6) // near the rim, or where the paint ends
            continue;
        ++compared;
        const int gray = seen(before, ahead, point);
        QVERIFY(std::abs(gray - seen(after, aside, point)) <= 4);
        darkest = std::min(darkest, gray);
        lightest = std::max(lightest, gray);
    }
    QVERIFY(compared > 100);
    QVERIFY(lightest > darkest + 60);
}

FETTLE_TEST(TestHeadsetShading, vr::GlTestApplication)
#include "tst_headset_shading.moc"
