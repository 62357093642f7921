#include "tests/support/mesh_asserts.h"
#include "tests/support/stroke_fuzzer.h"
#include "tests/support/test_main.h"
#include "tests/ui/sphere_model.h"
#include "tests/vr/gl/offscreen_gl.h"
#include "tests/vr/scene/counted_allocations.h"
#include "tests/vr/scene/example_scene.h"

#include "vr/gl/texture.h"
#include "vr/scene/label_layout.h"
#include "vr/scene/light.h"
#include "vr/scene/scene.h"

namespace
{
constexpr QSize size(270, 300);
constexpr Tangents leftEye{1.39, 1.23, 1.47, 1.46}, rightEye{1.23, 1.39, 1.47, 1.46}; ///< as of a Vive
constexpr double eyeDistance = 0.063;

using vr::SceneState;
using vr::WandPart;
using vr::WandSpot;

int differing(const QImage& a, const QImage& b, int tolerance = 0)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            count += std::abs(qRed(p) - qRed(q)) > tolerance || std::abs(qGreen(p) - qGreen(q)) > tolerance ||
                     std::abs(qBlue(p) - qBlue(q)) > tolerance;
        }
    return count;
}

/// Returns the pixel, from the top left, at which an eye sees a point of the room.
QPointF pixelOf(const core::Vec3& point, const vr::EyeView& eye)
{
    const Eigen::Vector4f clip = eye.projection * (eye.view * core::Vec3f(point.cast<float>())).homogeneous();
    return {(1 + clip.x() / clip.w()) / 2 * static_cast<float>(eye.width),
            (1 - clip.y() / clip.w()) / 2 * static_cast<float>(eye.height)};
}

QColor colorAt(const QImage& picture, const QPointF& at)
{
    return picture.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

/// Returns an image of one colour, with premultiplied alpha.
QImage plain(const QColor& color)
{
    QImage image(64, 64, QImage::Format_ARGB32_Premultiplied);
    image.fill(color);
    return image;
}
} // namespace

class TestHeadsetScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void cleanupTestCase() { m_image.reset(); }

    void ball_coversThePixelsThatItShould_data();
    void ball_coversThePixelsThatItShould();
    void eyes_seeTheBallApart();
    void eyes_seeTheSameDome();
    void passthrough_isWhereNothingIsDrawn();
    void bareHand_isDrawnAtItsJoints();
    void patches_showWhatAWholePatchShows();
    void largeModel_isSeenWhenItIsThereWhole();
    void images_ofLightAndOfSrgbShowTheSame();
    void clayBehindTheEye_changesNothing();
    void noClay_isNoTrouble();
    void brush_tintsWhatItWouldTake();
    void footprint_isTinted();
    void ray_endsAtItsHit();
    void plane_isSeenAroundTheClay();
    void panels_areBlendedByTheirAlpha();
    void panels_hideWhatIsBehindThem_data();
    void panels_hideWhatIsBehindThem();
    void panels_turnTheirBack();
    void wand_isShownWhereItIs();
    void wandParts_lightUp_data();
    void wandParts_lightUp();
    void labels_standWhereTheyAreLaidOut();
    void holdRing_fills();
    void hiddenArea_isNotDrawn();
    void steadyState_allocatesNothing();
    void floor_isSeenBelow();

private:
    vr::EyeView eye(const vr::Pose& head, const Tangents& tangents = {}) const
    {
        return eyeAt(head, tangents, *m_image);
    }
    QImage picture(const SceneState& state) { return picture(state, eye(state.head)); }
    QImage picture(const SceneState& state, const vr::EyeView& view);
    /// Returns a scene with only a dome, and a place for a model in mm, 1 m in front of the head.
    static SceneState bare();
    unsigned int texture(const QColor& color);

    std::unique_ptr<OffscreenGl> m_offscreen;
    std::unique_ptr<TestImage> m_image;
    vr::Scene m_scene;
    std::vector<vr::Texture> m_textures;
};

void TestHeadsetScene::initTestCase()
{
    m_offscreen = std::make_unique<OffscreenGl>();
    if (!m_offscreen->isUsable())
        QSKIP("no OpenGL 3.3 here");
    m_image = std::make_unique<TestImage>(m_offscreen->gl(), size);
}

void TestHeadsetScene::init()
{
    QVERIFY(m_scene.create(m_offscreen->gl()));
}

void TestHeadsetScene::cleanup()
{
    m_scene.destroy();
    for (vr::Texture& made : m_textures)
        made.destroy();
    m_textures.clear();
    QCOMPARE(m_offscreen->error(), 0U);
}

QImage TestHeadsetScene::picture(const SceneState& state, const vr::EyeView& view)
{
    for (int i = 0; i < 20; ++i)
        m_scene.prepare(state); // until all labels are painted
    m_scene.draw(view);
    if (m_offscreen->error() != 0)
        QTest::qFail("OpenGL found fault with what was drawn", __FILE__, __LINE__);
    return m_image->read();
}

SceneState TestHeadsetScene::bare()
{
    SceneState state;
    state.head.position = {0, 1.6, 0};
    state.model = Eigen::Translation3d(0, 1.6, -1) * Eigen::UniformScaling(1e-3);
    state.shading.tint = {0.93F, 0.527F, 0.361F};
    state.hasFloor = false;
    return state;
}

unsigned int TestHeadsetScene::texture(const QColor& color)
{
    m_textures.emplace_back().create(m_offscreen->gl());
    m_textures.back().upload(plain(color));
    return m_textures.back().id();
}

void TestHeadsetScene::ball_coversThePixelsThatItShould_data()
{
    QTest::addColumn<Tangents>("tangents");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<double>("radius");
    QTest::newRow("in the middle") << Tangents() << 0.0 << 1.6 << -1.0 << 0.2;
    QTest::newRow("aside") << Tangents() << 0.4 << 1.3 << -0.8 << 0.15;
    QTest::newRow("left eye") << leftEye << 0.3 << 1.7 << -0.6 << 0.2;
    QTest::newRow("right eye") << rightEye << -0.5 << 1.4 << -0.7 << 0.25;
    QTest::newRow("skew") << Tangents{0.3, 1.9, 0.4, 1.1} << 0.6 << 1.3 << -1.2 << 0.3;
    QTest::newRow("half out of view") << Tangents() << 1.0 << 1.6 << -1.0 << 0.3;
}

/// Compares the pixels covered by the ball with rays from the eye, computed without OpenGL.
void TestHeadsetScene::ball_coversThePixelsThatItShould()
{
    QFETCH(Tangents, tangents);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    QFETCH(double, radius);
    SceneState state = bare();
    state.head.rotation = Eigen::AngleAxisd(0.1, core::Vec3(1, 2, 3).normalized());
    const core::Vec3 center(x, y, z);
    state.model = Eigen::Translation3d(center) * Eigen::AngleAxisd(0.8, core::Vec3(1, 1, 0).normalized()) *
                  Eigen::UniformScaling(radius / 50);
    const vr::EyeView view = eye(state.head, tangents);
    const QImage without = picture(state, view);
    m_scene.apply(SphereModel(50, 5).whole());
    const QImage with = picture(state, view);
    int wrong = 0, covered = 0;
    for (int row = 0; row < size.height(); ++row)
        for (int column = 0; column < size.width(); ++column) {
            const core::Vec3 own((column + 0.5) / size.width() * (tangents.left + tangents.right) - tangents.left,
                                 tangents.up - (row + 0.5) / size.height() * (tangents.up + tangents.down), -1);
            const core::Vec3 direction = (state.head.rotation * own).normalized(), to = center - state.head.position;
            const double miss = to.cross(direction).norm() - radius, pixel = to.norm() * 2 / size.height();
            const bool isCovered = with.pixel(column, row) != without.pixel(column, row);
            covered += isCovered;
            wrong += std::abs(miss) > 1.5 * pixel && isCovered != (miss < 0);
        }
    QVERIFY(covered > 500);
    QCOMPARE(wrong, 0);
}

/// Checks the shift of the ball between the eyes' images, in pixels, against the eyes' distance and the ball's depth.
void TestHeadsetScene::eyes_seeTheBallApart()
{
    SceneState state = bare();
    m_scene.apply(SphereModel(50, 4).whole());
    const auto middle = [&](double sideways) {
        vr::Pose pose = state.head;
        pose.position.x() += sideways;
        const vr::EyeView view = eye(pose);
        SceneState gone = state;
        gone.model.translation() = core::Vec3(0, 1.6, 5);
        const QImage with = picture(state, view), without = picture(gone, view);
        double sum = 0, count = 0;
        for (int y = 0; y < size.height(); ++y)
            for (int x = 0; x < size.width(); ++x)
                if (with.pixel(x, y) != without.pixel(x, y)) {
                    sum += x;
                    ++count;
                }
        return sum / count;
    };
    for (const double distance : {0.4, 1.0}) {
        state.model.translation().z() = -distance;
        const double expected = eyeDistance / distance * size.width() / 2;
        QVERIFY(std::abs(middle(-eyeDistance / 2) - middle(eyeDistance / 2) - expected) < 0.6);
    }
}

/// Checks that eyes with different fields of view see the same colour of the dome in the same direction.
void TestHeadsetScene::eyes_seeTheSameDome()
{
    SceneState state = bare();
    state.head.rotation = Eigen::AngleAxisd(0.4, core::Vec3(1, 0.3, 1).normalized());
    const vr::EyeView one = eye(state.head, {1, 1, 1, 1}), other = eye(state.head, {0.5, 2.5, 0.7, 2});
    const QImage seenByOne = picture(state, one), seenByOther = picture(state, other);
    int darkest = 255, lightest = 0;
    for (double x = -0.45; x < 1; x += 0.1)
        for (double y = -0.95; y < 0.65; y += 0.1) {
            const core::Vec3 at = state.head * core::Vec3(x, y, -1);
            const int gray = qGray(colorAt(seenByOne, pixelOf(at, one)).rgb());
            QVERIFY(std::abs(gray - qGray(colorAt(seenByOther, pixelOf(at, other)).rgb())) <= 1);
            darkest = std::min(darkest, gray);
            lightest = std::max(lightest, gray);
        }
    QVERIFY(darkest > 20); // not black anywhere
    QVERIFY(lightest > darkest + 15);
}

/// Checks that with passthrough the picture is opaque where the model is, and black with the alpha value 0 where
/// nothing is, and that it is opaque everywhere otherwise.
void TestHeadsetScene::passthrough_isWhereNothingIsDrawn()
{
    core::Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(3, 50)));
    m_scene.apply(sculptor.wholePatch());
    SceneState state = bare();
    state.model = Eigen::Translation3d(0, 1.6, -0.6) * Eigen::UniformScaling(2e-3);
    state.head = looking({0, 1.6, 0}, {0, 1.6, -0.6});
    state.hasFloor = false;
    vr::EyeView view = eye(state.head);
    const QImage room = picture(state, view);
    view.hasPassthrough = true;
    const QImage seen = picture(state, view);
    const QPoint middle(size.width() / 2, size.height() / 2);
    QCOMPARE(seen.pixel(middle), room.pixel(middle));
    QCOMPARE(seen.pixelColor(middle).alpha(), 255);
    for (const QPoint corner : {QPoint(2, 2), QPoint(size.width() - 3, size.height() - 3)}) {
        QCOMPARE(seen.pixelColor(corner), QColor(0, 0, 0, 0));
        QCOMPARE(room.pixelColor(corner).alpha(), 255);
        QVERIFY(qGray(room.pixel(corner)) > 20);
    }
}

/// Checks that a bare hand covers its joints and the bones between them, and has no wand.
void TestHeadsetScene::bareHand_isDrawnAtItsJoints()
{
    SceneState state = bare();
    state.head = looking({0, 1.6, 0}, {0, 1.6, -0.4});
    state.hasFloor = false;
    vr::EyeView view = eye(state.head);
    view.hasPassthrough = true; // alpha tells what is drawn
    vr::HandJoints joints;
    for (std::size_t i = 0; i < vr::jointCount; ++i)
        joints[i].position =
            core::Vec3(0.02 * static_cast<double>(i / 5) - 0.05, 1.55 + 0.02 * static_cast<double>(i % 5), -0.4);
    const auto isDrawn = [&](const QImage& seen, const core::Vec3& at) {
        return colorAt(seen, pixelOf(at, view)).alpha() == 255;
    };
    vr::ShownWand& hand = state.wands[1];
    hand.isShown = true;
    hand.grip.position = core::Vec3(0.15, 1.6, -0.4);
    QVERIFY(isDrawn(picture(state, view), hand.grip.position));
    hand.pinch = core::Vec3(-0.15, 1.6, -0.4);
    const QImage bead = picture(state, view);
    QVERIFY(isDrawn(bead, *hand.pinch) && !isDrawn(bead, hand.grip.position) && !isDrawn(bead, joints[8].position));
    hand.joints = joints;
    const QImage seen = picture(state, view);
    QVERIFY(isDrawn(seen, *hand.pinch) && !isDrawn(seen, hand.grip.position));
    for (std::size_t i = 0; i < vr::jointCount; ++i) {
        QVERIFY(isDrawn(seen, joints[i].position));
        QVERIFY(isDrawn(seen, (joints[i].position + joints[vr::jointBefore(i)].position) / 2));
    }
}

/// Compares patches applied one by one with a whole patch, after strokes and after their undo, which frees slots.
void TestHeadsetScene::patches_showWhatAWholePatchShows()
{
    core::Sculptor sculptor(mesh_asserts::sculptable(core::icosphere(3, 50)));
    m_scene.apply(sculptor.wholePatch());
    sculptor.takePatch();
    SceneState state = bare();
    state.model = Eigen::Translation3d(0, 1.6, -0.6) * Eigen::UniformScaling(6e-3);
    state.isFlat = true; // makes each triangle visible
    const auto isAsWhole = [&] {
        const QImage seen = picture(state);
        m_scene.destroy();
        m_scene.create(m_offscreen->gl());
        m_scene.apply(sculptor.wholePatch());
        return differing(seen, picture(state)) == 0;
    };
    StrokeFuzzer random(20240812);
    std::vector<core::MeshDelta> undo;
    QImage before = picture(state);
    for (int i = 0; i < 6; ++i) {
        const core::Stroke stroke = random.stroke(sculptor.mesh());
        sculptor.beginStroke(stroke.settings);
        for (const core::StrokeSample& sample : stroke.samples) {
            sculptor.addSample(sample);
            m_scene.apply(sculptor.takePatch());
        }
        undo.push_back(sculptor.endStroke());
        m_scene.apply(sculptor.takePatch());
        QVERIFY(isAsWhole());
    }
    QVERIFY(differing(before, picture(state)) > 100);
    for (; !undo.empty(); undo.pop_back()) {
        sculptor.swap(undo.back());
        m_scene.apply(sculptor.takePatch());
    }
    QVERIFY(isAsWhole());
    QCOMPARE(differing(before, picture(state)), 0);
}

/// Checks that a large model replaces the one before only when loaded completely, over several frames. In the first
/// frame of a visit it is loaded at once.
void TestHeadsetScene::largeModel_isSeenWhenItIsThereWhole()
{
    const SceneState state = bare();
    const vr::EyeView view = eye(state.head);
    const SphereModel small(80, 3), large(50, 7);
    const auto frame = [&] {
        m_scene.prepare(state);
        m_scene.draw(view);
        return m_image->read();
    };
    m_scene.apply(large.whole());
    const QImage wanted = frame();
    m_scene.apply(small.whole());
    const QImage before = frame();
    QVERIFY(differing(before, wanted) > 100);
    m_scene.apply(large.whole());
    int frames = 0;
    for (QImage seen = frame(); m_scene.isLoading(); seen = frame(), ++frames)
        QCOMPARE(differing(seen, before), 0);
    QVERIFY(frames > 2);
    QCOMPARE(differing(frame(), wanted), 0);
    QCOMPARE(m_scene.wholeUploads(), 3U);
}

/// Checks that images in linear and sRGB formats look the same. OpenXR interprets formats that are not sRGB as linear.
void TestHeadsetScene::images_ofLightAndOfSrgbShowTheSame()
{
    const SphereModel model;
    m_scene.apply(model.whole());
    SceneState state = example::scene(model.box());
    state.panels = {
        {looking({-0.4, 1.4, -0.6}, {-0.8, 1.2, -1.2}), {0.4, 0.3}, texture(QColor(30, 90, 200, 120)), 0.8F}};
    const vr::EyeView view = eye(state.head, leftEye);
    const QImage srgb = picture(state, view);
    TestImage light(m_offscreen->gl(), size, GL_RGBA16F);
    vr::EyeView other = view;
    other.framebuffer = light.framebuffer();
    m_scene.draw(other);
    const std::vector<float> values = light.readFloats();
    int most = 0;
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            const float* value = &values[static_cast<std::size_t>((size.height() - 1 - y) * size.width() + x) * 4];
            const QRgb seen = srgb.pixel(x, y);
            const int colors[] = {qRed(seen), qGreen(seen), qBlue(seen)};
            for (int channel = 0; channel < 3; ++channel)
                most = std::max(
                    most, std::abs(colors[channel] - core::io::srgbFromLinear(static_cast<double>(value[channel]))));
            QVERIFY(std::abs(value[3] - 1) < 0.01F); // transparent shapes leave the image opaque
            QCOMPARE(qAlpha(seen), 255);
        }
    QVERIFY2(most <= 3, qPrintable(QString::number(most))); // blending rounds the values of each layer
}

void TestHeadsetScene::clayBehindTheEye_changesNothing()
{
    SceneState state = bare();
    const QImage without = picture(state);
    m_scene.apply(SphereModel().whole());
    for (const core::Vec3& at :
         {core::Vec3(0, 1.6, 2), core::Vec3(9, 1.6, -1), core::Vec3(0, 1.6, -500), core::Vec3(0, 1.6, -0.001)}) {
        state.model.translation() = at;
        state.model.linear() = Eigen::Matrix3d::Identity() * (at.z() < -100 ? 1e-3 : 5e-5);
        QCOMPARE(differing(without, picture(state)), 0);
    }
}

void TestHeadsetScene::noClay_isNoTrouble()
{
    SceneState state = example::scene(SphereModel().box());
    const QImage before = picture(state);
    QVERIFY(differing(before, picture(bare())) > 1000);
    core::MeshPatch nothing;
    m_scene.apply(nothing);
    QCOMPARE(differing(before, picture(state)), 0);
    nothing.whole = true;
    m_scene.apply(nothing);
    QCOMPARE(differing(before, picture(state)), 0);
    m_scene.tint(nullptr);
    QCOMPARE(differing(before, picture(state)), 0);
}

/// Checks the tint at the brush and at its mirror image. The brush is black and can only darken, so lighter pixels are
/// tinted.
void TestHeadsetScene::brush_tintsWhatItWouldTake()
{
    m_scene.apply(SphereModel(200, 5).whole());
    SceneState state = bare();
    state.brushColor = {0, 0, 0};
    const QImage without = picture(state);
    const core::Vec3 at = state.model * core::Vec3(70, 40, 183), image = state.model * core::Vec3(-70, 40, 183);
    state.brush = vr::BallBrush{at, 0.05, 4};
    const auto blue = [&](const QImage& seen, const core::Vec3& place) {
        return colorAt(seen, pixelOf(place, eye(state.head))).blue();
    };
    const QImage with = picture(state);
    QVERIFY(blue(with, at) > blue(without, at) + 15);
    QVERIFY(blue(with, image) == blue(without, image));
    state.symmetry = core::Symmetry::X;
    QVERIFY(blue(picture(state), image) > blue(without, image) + 15);
    std::get<vr::BallBrush>(state.brush).center.z() += 0.2; // moves the brush away from the model
    QVERIFY(blue(picture(state), at) <= blue(without, at));
}

void TestHeadsetScene::footprint_isTinted()
{
    const SphereModel model(200, 5);
    m_scene.apply(model.whole());
    const SceneState state = bare();
    const QImage without = picture(state);
    core::Footprint footprint;
    for (core::Slot v = 0; v < model.vertices(); ++v)
        if (model.mesh.points[v].x() > 0)
            footprint.slots.push_back(v);
    footprint.weights.assign(footprint.slots.size(), 255);
    m_scene.tint(&footprint);
    const QImage with = picture(state);
    const auto changed = [&](const core::Vec3& at) {
        const QPointF pixel = pixelOf(state.model * at, eye(state.head));
        return colorAt(with, pixel) != colorAt(without, pixel);
    };
    QVERIFY(changed({60, 0, 190}));
    QVERIFY(!changed({-60, 0, 190}));
    m_scene.tint(nullptr);
    QCOMPARE(differing(without, picture(state)), 0);
}

void TestHeadsetScene::ray_endsAtItsHit()
{
    m_scene.apply(SphereModel(200, 5).whole());
    SceneState state = bare();
    const QImage without = picture(state);
    const core::Vec3 from(0.3, 1.3, -0.3), point = state.model * core::Vec3(0, 0, 200);
    const vr::EyeView view = eye(state.head);
    const auto changed = [&](const QImage& seen, const core::Vec3& at) {
        return colorAt(seen, pixelOf(at, view)) != colorAt(without, pixelOf(at, view));
    };

    state.brush = vr::RayBrush{{from, point - from}, vr::RayBrush::Hit{point, core::Vec3::UnitZ(), 0.08}};
    const QImage hit = picture(state);
    QVERIFY(changed(hit, from + 0.5 * (point - from)));
    QVERIFY(!changed(hit, from + 1.3 * (point - from)));
    QVERIFY(changed(hit, point));  // the dot
    for (int i = 0; i < 16; ++i) { // the ring; between ring and dot nothing changes
        const double turn = 2 * std::numbers::pi * i / 16;
        const core::Vec3 out(std::cos(turn), std::sin(turn), 0);
        QVERIFY(changed(hit, point + 0.079 * out));
        QVERIFY(i == 11 || i == 12 || i == 13 || i == 14 ||
                !changed(hit, point + 0.05 * out)); // except where the ray passes
    }
    state.symmetry = core::Symmetry::Z; // the mirror image is on the far side, where clay hides it almost completely
    QVERIFY(differing(hit, picture(state)) > 0);

    state.symmetry = core::Symmetry::None;
    state.brush = vr::RayBrush{{from, core::Vec3(0.3, 0.2, -1)}, {}};
    const QImage miss = picture(state);
    QVERIFY(changed(miss, from + core::Vec3(0.3, 0.2, -1)));
    QVERIFY(!changed(miss, point));
}

void TestHeadsetScene::plane_isSeenAroundTheClay()
{
    const SphereModel model(200, 5);
    m_scene.apply(model.whole());
    SceneState state = bare();
    state.box = model.box();
    const QImage without = picture(state);
    state.symmetry = core::Symmetry::Z; // across the view
    const QImage with = picture(state);
    const vr::EyeView view = eye(state.head);
    const auto changed = [&](const core::Vec3& at) {
        return colorAt(with, pixelOf(state.model * at, view)) != colorAt(without, pixelOf(state.model * at, view));
    };
    QVERIFY(changed({210, 210, 0}) && changed({-210, 210, 0}) && changed({230, 0, 0}));
    QVERIFY(!changed({0, 0, 200}) && !changed({80, 60, 100})); // clay hides the plane there
    QVERIFY(!changed({300, 0, 0}));
    state.box.setEmpty();
    QVERIFY(differing(with, picture(state)) > 100);
}

void TestHeadsetScene::panels_areBlendedByTheirAlpha()
{
    SceneState state = bare();
    const vr::EyeView view = eye(state.head);
    const core::Vec3 at(0.2, 1.5, -1);
    const QImage without = picture(state);
    const auto shown = [&](const QColor& color, float opacity) {
        state.panels = {{{Eigen::Quaterniond::Identity(), at}, {0.4, 0.3}, texture(color), opacity}};
        return picture(state);
    };
    const QPointF middle = pixelOf(at, view);
    const auto light = [](int seen) { return core::io::linearFromSrgb(static_cast<std::uint8_t>(seen)); };
    const struct
    {
        QColor color;
        float opacity;
    } cases[] = {{QColor(200, 120, 40), 1},
                 {QColor(200, 120, 40, 128), 1},
                 {QColor(240, 240, 240), 0.25F},
                 {QColor(10, 200, 90, 64), 0.5F},
                 {QColor(200, 10, 10), 0}};
    for (const auto& c : cases) {
        const QImage with = shown(c.color, c.opacity);
        const double alpha = c.color.alphaF() * static_cast<double>(c.opacity);
        const QColor seen = colorAt(with, middle), behind = colorAt(without, middle);
        QVERIFY(std::abs(seen.red() - core::io::srgbFromLinear(alpha * light(c.color.red()) +
                                                               (1 - alpha) * light(behind.red()))) <= 3);
        QVERIFY(std::abs(seen.green() - core::io::srgbFromLinear(alpha * light(c.color.green()) +
                                                                 (1 - alpha) * light(behind.green()))) <= 3);
        // No change beside the panel.
        QCOMPARE(colorAt(with, pixelOf(at + core::Vec3(0.22, 0, 0), view)),
                 colorAt(without, pixelOf(at + core::Vec3(0.22, 0, 0), view)));
        QCOMPARE(colorAt(with, pixelOf(at + core::Vec3(0, 0.17, 0), view)),
                 colorAt(without, pixelOf(at + core::Vec3(0, 0.17, 0), view)));
    }
}

void TestHeadsetScene::panels_hideWhatIsBehindThem_data()
{
    QTest::addColumn<bool>("nearFirst");
    QTest::newRow("near first") << true;
    QTest::newRow("far first") << false;
}

/// Checks that panels hide rays, labels and panels behind them, in whatever order they are given.
void TestHeadsetScene::panels_hideWhatIsBehindThem()
{
    QFETCH(bool, nearFirst);
    SceneState state = bare();
    const vr::Panel near{{Eigen::Quaterniond::Identity(), {0, 1.6, -0.6}}, {0.3, 0.3}, texture(QColor(200, 0, 0)), 1};
    const vr::Panel far{{Eigen::Quaterniond::Identity(), {0.1, 1.6, -1}}, {0.5, 0.5}, texture(QColor(0, 200, 0)), 1};
    state.panels = nearFirst ? std::vector{near, far} : std::vector{far, near};
    state.lasers[1] = vr::Laser{{-1, 1.6, -0.8}, {1, 1.6, -0.8}};
    const QImage seen = picture(state);
    // in front of panel and laser
    QCOMPARE(colorAt(seen, QPointF(size.width() / 2, size.height() / 2)), QColor(200, 0, 0));
    QCOMPARE(colorAt(seen, pixelOf({0.32, 1.7, -1}, eye(state.head))), QColor(0, 200, 0));
    for (vr::Panel& panel : state.panels)
        panel.opacity = panel.textureId == near.textureId ? 0.5F : 1;
    const QColor through = colorAt(picture(state), QPointF(size.width() / 2, size.height() / 2));
    QVERIFY(through.red() > 120 && through.green() > 120);
}

void TestHeadsetScene::panels_turnTheirBack()
{
    SceneState state = bare();
    state.panels = {{{Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, core::Vec3::UnitY())), {0, 1.6, -1}},
                     {0.5, 0.5},
                     texture(QColor(255, 255, 255)),
                     1}};
    QVERIFY(colorAt(picture(state), QPointF(size.width() / 2, size.height() / 2)).lightness() < 60);
}

void TestHeadsetScene::wand_isShownWhereItIs()
{
    SceneState state = bare();
    const QImage without = picture(state);
    vr::ShownWand& wand = state.wands[1];
    wand.grip = {Eigen::Quaterniond(Eigen::AngleAxisd(0.9, core::Vec3(1, 0.2, 0).normalized())), {0.1, 1.5, -0.45}};
    QCOMPARE(differing(without, picture(state)), 0); // not tracked
    wand.isShown = true;
    const QImage with = picture(state);
    const vr::EyeView view = eye(state.head);
    for (const core::Vec3& own : {core::Vec3(0, 0, 0.09), core::Vec3(0, 0, 0), core::Vec3(0, 0, -0.05), vr::wandTip()})
        QVERIFY(colorAt(with, pixelOf(wand.grip * own, view)) != colorAt(without, pixelOf(wand.grip * own, view)));
    for (const core::Vec3& own : {core::Vec3(0, 0, 0.13), core::Vec3(0.06, 0, 0), core::Vec3(0, 0, -0.16)})
        QCOMPARE(colorAt(with, pixelOf(wand.grip * own, view)), colorAt(without, pixelOf(wand.grip * own, view)));
}

void TestHeadsetScene::wandParts_lightUp_data()
{
    QTest::addColumn<int>("part");
    QTest::addColumn<int>("spot");
    const auto row = [](const char* name, WandPart part, WandSpot spot) {
        QTest::newRow(name) << static_cast<int>(part) << static_cast<int>(spot);
    };
    row("pad up", WandPart::PadUp, WandSpot::PadUp);
    row("pad down", WandPart::PadDown, WandSpot::PadDown);
    row("pad left", WandPart::PadLeft, WandSpot::PadLeft);
    row("pad right", WandPart::PadRight, WandSpot::PadRight);
    row("pad middle", WandPart::PadMiddle, WandSpot::PadMiddle);
    row("menu", WandPart::Menu, WandSpot::Menu);
}

void TestHeadsetScene::wandParts_lightUp()
{
    QFETCH(int, part);
    QFETCH(int, spot);
    SceneState state = bare();
    vr::ShownWand& wand = state.wands[0];
    wand.isShown = true;
    wand.grip = {Eigen::Quaterniond(Eigen::AngleAxisd(1.4, core::Vec3::UnitX())),
                 {0, 1.6, -0.16}}; // its pad faces the user
    const QImage before = picture(state);
    wand.isLit[static_cast<std::size_t>(part)] = true;
    const QImage after = picture(state);
    const QPointF at = pixelOf(wand.grip * vr::placeOf(static_cast<WandSpot>(spot)), eye(state.head));
    QVERIFY(colorAt(after, at).blue() > colorAt(before, at).blue() + 40);
    QVERIFY(differing(before, after) < 600);
}

void TestHeadsetScene::labels_standWhereTheyAreLaidOut()
{
    SceneState state = bare();
    vr::ShownWand& wand = state.wands[0];
    wand.isShown = true;
    wand.grip = {Eigen::Quaterniond(Eigen::AngleAxisd(1.0, core::Vec3::UnitX())), {0, 1.5, -0.4}};
    const QImage without = picture(state);
    vr::WandLabel& label = wand.labels[static_cast<std::size_t>(WandSpot::PadLeft)];
    label.text = QStringLiteral("Undo");
    label.opacity = 0;
    QCOMPARE(differing(without, picture(state)), 0);
    label.opacity = 0.3F;
    const int faint = differing(without, picture(state), 20);
    label.opacity = 1;
    const QImage with = picture(state);
    QVERIFY(differing(without, with, 20) > faint);
    vr::LabelAspects aspects;
    aspects[static_cast<std::size_t>(WandSpot::PadLeft)] = 2;
    const auto place = vr::labelPlaces(wand.grip, state.head, aspects)[static_cast<std::size_t>(WandSpot::PadLeft)];
    const vr::EyeView view = eye(state.head);
    QVERIFY(colorAt(with, pixelOf(place->center, view)) != colorAt(without, pixelOf(place->center, view)));
    const core::Vec3 above = place->center + 1.3 * place->halfY;
    QCOMPARE(colorAt(with, pixelOf(above, view)), colorAt(without, pixelOf(above, view)));
}

void TestHeadsetScene::holdRing_fills()
{
    SceneState state = bare();
    vr::ShownWand& wand = state.wands[0];
    wand.isShown = true;
    wand.grip = {Eigen::Quaterniond(Eigen::AngleAxisd(1.2, core::Vec3::UnitX())), {0, 1.6, -0.2}};
    const auto amber = [&](double hold) {
        wand.holdProgress = hold;
        const QImage seen = picture(state);
        int count = 0;
        for (int y = 0; y < size.height(); ++y)
            for (int x = 0; x < size.width(); ++x)
                count += seen.pixelColor(x, y).red() > seen.pixelColor(x, y).blue() + 80;
        return count;
    };
    QCOMPARE(amber(0), 0);
    const int full = amber(1);
    QVERIFY(full > 200);
    for (const double hold : {0.25, 0.5, 0.75})
        QVERIFY(std::abs(amber(hold) - hold * full) < 0.08 * full);
    QCOMPARE(amber(1.7), full);
}

/// Draws a hidden area of either winding across the ball. It must stay black, without a change beside it.
void TestHeadsetScene::hiddenArea_isNotDrawn()
{
    m_scene.apply(SphereModel(200, 4).whole());
    SceneState state = bare();
    state.hasFloor = true;
    const vr::EyeView whole = eye(state.head);
    const QImage before = picture(state, whole);
    for (const bool isTurned : {false, true}) {
        vr::HiddenArea area{{-0.1F, -0.1F}, {0.2F, -0.1F}, {-0.1F, 0.2F}};
        if (isTurned)
            std::swap(area[1], area[2]);
        vr::EyeView view = whole;
        view.hidden = &area;
        const QImage after = picture(state, view);
        int hidden = 0;
        for (int y = 0; y < size.height(); ++y)
            for (int x = 0; x < size.width(); ++x) {
                const bool isBlack = after.pixelColor(x, y) == QColor(Qt::black);
                hidden += isBlack;
                QVERIFY(isBlack || after.pixelColor(x, y) == before.pixelColor(x, y));
            }
        const Eigen::Vector2f scale = whole.projection.diagonal().head<2>() / 2;
        const double share = 0.045 * scale.x() * scale.y();
        QVERIFY(std::abs(hidden / double(size.width() * size.height()) - share) < 0.002);
    }
}

void TestHeadsetScene::steadyState_allocatesNothing()
{
    SceneState state = example::scene(SphereModel().box());
    state.panels.assign(5, {{}, {0.1, 0.1}, texture(Qt::white), 1});
    picture(state);
    SceneState moved = state;
    moved.head.position += core::Vec3(0.1, 0.02, 0.3);
    const long before = allocations;
    m_scene.prepare(moved);
    m_scene.prepare(state);
    QCOMPARE(allocations - before, 0L);
}

void TestHeadsetScene::floor_isSeenBelow()
{
    SceneState state = bare();
    const QImage without = picture(state);
    state.hasFloor = true;
    const QImage with = picture(state);
    int above = 0, below = 0;
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x)
            (y < size.height() / 2 ? above : below) += with.pixel(x, y) != without.pixel(x, y);
    QCOMPARE(above, 0);
    QVERIFY(below > 500);
}

FETTLE_TEST(TestHeadsetScene, vr::GlTestApplication)
#include "tst_headset_scene.moc"
