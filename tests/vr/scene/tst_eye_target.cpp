#include "tests/support/test_main.h"
#include "tests/vr/gl/offscreen_gl.h"

#include "vr/gl/gl_program.h"
#include "vr/scene/eye_target.h"

#include <algorithm>
#include <set>

using vr::EyeTarget;

namespace
{
constexpr QSize imageSize(97, 61);

vr::EyeImage asked(const TestImage& image)
{
    return {image.texture(), image.format(), image.size().width(), image.size().height()};
}
} // namespace

class TestEyeTarget : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_offscreen = std::make_unique<OffscreenGl>();
        if (!m_offscreen->isUsable())
            QSKIP("no OpenGL 3.3 here");
        m_gl = m_offscreen->gl();
        m_target.create(m_gl);
    }
    void cleanup() { QCOMPARE(m_offscreen->error(), 0U); }
    void cleanupTestCase() { m_target.destroy(); }

    void whatIsDrawn_comesIntoTheImage_data();
    void whatIsDrawn_comesIntoTheImage();
    void sizesAndFormats_mayChange();
    void edges_areMixedOfLight();
    void samples_areThoseThatThereAre();
    void badImages_areRefused();

private:
    void fill(const vr::EyeImage& image, float light)
    {
        m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_target.framebufferFor(image));
        m_gl->glEnable(GL_FRAMEBUFFER_SRGB);
        m_gl->glViewport(0, 0, image.width, image.height);
        m_gl->glClearColor(light, light, light, 1);
        m_gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    std::unique_ptr<OffscreenGl> m_offscreen;
    QOpenGLExtraFunctions* m_gl = nullptr;
    EyeTarget m_target;
};

void TestEyeTarget::whatIsDrawn_comesIntoTheImage_data()
{
    QTest::addColumn<unsigned int>("format");
    QTest::addColumn<float>("inMemory"); ///< stored value of linear light 0.2140, which is sRGB 127.5
    QTest::newRow("sRGB") << unsigned(GL_SRGB8_ALPHA8) << 0.5F;
    QTest::newRow("half floats") << unsigned(GL_RGBA16F) << 0.214F;
    QTest::newRow("ten bits") << unsigned(GL_RGB10_A2) << 0.214F;
    QTest::newRow("bytes") << unsigned(GL_RGBA8) << 0.214F;
}

void TestEyeTarget::whatIsDrawn_comesIntoTheImage()
{
    QFETCH(unsigned int, format);
    QFETCH(float, inMemory);
    const TestImage image(m_gl, imageSize, format);
    fill(asked(image), 0.214F);
    QVERIFY(m_target.resolve(asked(image)));
    m_gl->glDisable(GL_FRAMEBUFFER_SRGB);
    for (const QPoint at : {QPoint(0, 0), QPoint(96, 60), QPoint(50, 30)})
        QVERIFY(std::abs(image.readFloats()[static_cast<std::size_t>(at.y() * imageSize.width() + at.x()) * 4] -
                         inMemory) < 0.003F);
}

/// Checks that images of the same size and format share a framebuffer, and that a runtime may provide others at any
/// time.
void TestEyeTarget::sizesAndFormats_mayChange()
{
    const TestImage left(m_gl, imageSize), right(m_gl, imageSize), large(m_gl, {300, 211}),
        linear(m_gl, imageSize, GL_RGBA16F);
    QCOMPARE(m_target.framebufferFor(asked(left)), m_target.framebufferFor(asked(right)));
    float light = 0.1F;
    for (const TestImage* image : {&left, &large, &right, &linear, &left}) {
        light += 0.1F;
        QVERIFY(m_target.framebufferFor(asked(*image)) != 0);
        fill(asked(*image), light);
        QVERIFY(m_target.resolve(asked(*image)));
        QVERIFY(m_target.samples() > 1);
        const QColor seen = image->read().pixelColor(image->size().width() - 1, 0);
        const float expected = image == &linear ? light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
        QVERIFY(std::abs(static_cast<float>(seen.redF()) - expected) < 0.01F);
    }
}

/// Checks that antialiasing mixes linear light: a pixel half covered by white is sRGB 188, not 128.
void TestEyeTarget::edges_areMixedOfLight()
{
    struct Plate : vr::Program
    {
        vr::Uniform clip{this, "clip"}, halfX{this, "halfX"}, halfY{this, "halfY"}, color{this, "color"};
    } plate;
    QVERIFY(plate.create(m_gl, "rectangle.vert", "plane.frag"));
    const TestImage image(m_gl, imageSize);
    fill(asked(image), 0);
    plate.use();
    plate.clip.set(Eigen::Matrix4f(Eigen::Matrix4f::Identity()));
    plate.halfX.set(Eigen::Vector3f(0.5F, 0.3F, 0));
    plate.halfY.set(Eigen::Vector3f(-0.3F, 0.5F, 0));
    plate.color.set(Eigen::Vector3f(1, 1, 1));
    unsigned int noVertices = 0;
    m_gl->glGenVertexArrays(1, &noVertices);
    m_gl->glBindVertexArray(noVertices);
    m_gl->glDisable(GL_BLEND);
    m_gl->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_gl->glBindVertexArray(0);
    m_gl->glDeleteVertexArrays(1, &noVertices);
    plate.destroy();
    QVERIFY(m_target.resolve(asked(image)));
    const QImage picture = image.read();
    std::set<int> shades;
    for (int y = 0; y < imageSize.height(); ++y)
        for (int x = 0; x < imageSize.width(); ++x)
            shades.insert(qRed(picture.pixel(x, y)));
    QCOMPARE(m_target.samples(), 4);
    QVERIFY(shades.size() > 3);
    const std::set<int> mixed{0, 137, 188, 225, 255};
    for (const int shade : shades)
        QVERIFY(std::ranges::any_of(mixed, [&](int one) { return std::abs(one - shade) <= 1; }));
}

void TestEyeTarget::samples_areThoseThatThereAre()
{
    const TestImage image(m_gl, imageSize);
    GLint most = 0;
    m_gl->glGetIntegerv(GL_MAX_SAMPLES, &most);
    for (const int samples : {0, 1, 4, 1000}) {
        EyeTarget target;
        target.create(m_gl, samples);
        QVERIFY(target.framebufferFor(asked(image)) != 0);
        QCOMPARE(target.samples(), std::min(samples, static_cast<int>(most)));
        QVERIFY(target.resolve(asked(image)));
        target.destroy();
    }
}

void TestEyeTarget::badImages_areRefused()
{
    QCOMPARE(m_target.framebufferFor({0, GL_SRGB8_ALPHA8, 0, 0}), 0U);
    const TestImage image(m_gl, imageSize);
    vr::EyeImage gone = asked(image);
    gone.texture = 0;
    QVERIFY(m_target.framebufferFor(gone) != 0);
    QVERIFY(!m_target.resolve(gone));
    QVERIFY(m_target.resolve(asked(image)));
}

FETTLE_TEST(TestEyeTarget, vr::GlTestApplication)
#include "tst_eye_target.moc"
