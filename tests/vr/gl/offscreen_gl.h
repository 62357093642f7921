#pragma once

#include "tests/support/display.h"
#include "vr/gl/eye_image.h"
#include "vr/util/pose.h"

#include <QGuiApplication>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QTest>

#include <cmath>
#include <vector>

namespace vr
{
/// A test's QGuiApplication. Without a display it uses Qt's offscreen platform, where tests that need OpenGL skip
/// themselves.
class GlTestApplication
{
public:
    GlTestApplication(int& argc, char** argv) : m_application(prepared(argc), argv) {}

private:
    static int& prepared(int& argc)
    {
        test::useOffscreenUnless(test::hasDisplay());
        return argc;
    }

    QGuiApplication m_application;
};
} // namespace vr

/// An OpenGL 3.3 core context without a window.
class OffscreenGl
{
public:
    OffscreenGl()
    {
        QSurfaceFormat format;
        format.setVersion(3, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        m_surface.setFormat(format);
        m_surface.create();
        m_context.setFormat(format);
        m_isUsable =
            m_context.create() && m_context.makeCurrent(&m_surface) && m_context.format().version() >= qMakePair(3, 3);
    }

    bool isUsable() const { return m_isUsable; }
    QOpenGLExtraFunctions* gl() const { return m_context.extraFunctions(); }
    unsigned int error() const { return gl()->glGetError(); }

private:
    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    bool m_isUsable = false;
};

/// A texture like those of an OpenXR runtime, with a framebuffer of one sample around it.
class TestImage
{
public:
    TestImage(QOpenGLExtraFunctions* gl, QSize size, unsigned int format = GL_SRGB8_ALPHA8)
        : m_gl(gl)
        , m_size(size)
        , m_format(format)
    {
        const int w = size.width(), h = size.height();
        m_gl->glGenTextures(1, &m_texture);
        m_gl->glBindTexture(GL_TEXTURE_2D, m_texture);
        m_gl->glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        m_gl->glGenRenderbuffers(1, &m_depth);
        m_gl->glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
        m_gl->glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, w, h);
        m_gl->glGenFramebuffers(1, &m_framebuffer);
        m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        m_gl->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
        m_gl->glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
        m_gl->glBindTexture(GL_TEXTURE_2D, 0);
    }
    ~TestImage()
    {
        m_gl->glDeleteFramebuffers(1, &m_framebuffer);
        m_gl->glDeleteRenderbuffers(1, &m_depth);
        m_gl->glDeleteTextures(1, &m_texture);
    }
    TestImage(const TestImage&) = delete;
    TestImage& operator=(const TestImage&) = delete;

    unsigned int framebuffer() const { return m_framebuffer; }
    unsigned int texture() const { return m_texture; }
    unsigned int format() const { return m_format; }
    QSize size() const { return m_size; }

    /// Returns the image as stored: for an sRGB format, the values a screen would show.
    QImage read() const
    {
        QImage picture(m_size, QImage::Format_RGBA8888);
        m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        m_gl->glDisable(GL_FRAMEBUFFER_SRGB);
        m_gl->glReadPixels(0, 0, m_size.width(), m_size.height(), GL_RGBA, GL_UNSIGNED_BYTE, picture.bits());
        return picture.mirrored();
    }
    /// Returns red, green, blue and alpha of each pixel as floats, the lowest line first.
    std::vector<float> readFloats() const
    {
        std::vector<float> values(static_cast<std::size_t>(m_size.width() * m_size.height()) * 4);
        m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        m_gl->glReadPixels(0, 0, m_size.width(), m_size.height(), GL_RGBA, GL_FLOAT, values.data());
        return values;
    }

private:
    QOpenGLExtraFunctions* m_gl;
    QSize m_size;
    unsigned int m_format, m_texture = 0, m_depth = 0, m_framebuffer = 0;
};

/// Tangents of the angles from an eye's view direction to each side of its field of view. All are positive.
struct Tangents
{
    double left = 1, right = 1, up = 1, down = 1;
};

inline Eigen::Matrix4f projectionOf(const Tangents& t, double nearest = 0.03, double farthest = 60)
{
    Eigen::Matrix4d p = Eigen::Matrix4d::Zero();
    p(0, 0) = 2 / (t.right + t.left);
    p(0, 2) = (t.right - t.left) / (t.right + t.left);
    p(1, 1) = 2 / (t.up + t.down);
    p(1, 2) = (t.up - t.down) / (t.up + t.down);
    p(2, 2) = -(farthest + nearest) / (farthest - nearest);
    p(2, 3) = -2 * farthest * nearest / (farthest - nearest);
    p(3, 2) = -1;
    return p.cast<float>();
}

/// Returns an eye at this pose, which draws into the image.
inline vr::EyeView eyeAt(const vr::Pose& pose, const Tangents& tangents, const TestImage& image)
{
    vr::EyeView eye;
    eye.framebuffer = image.framebuffer();
    eye.width = image.size().width();
    eye.height = image.size().height();
    eye.projection = projectionOf(tangents);
    eye.view = Eigen::Isometry3f(pose.inverse().matrix().matrix().cast<float>());
    return eye;
}

/// Returns the pose of a level head at `from` that looks at `at`.
inline vr::Pose looking(const core::Vec3& from, const core::Vec3& at)
{
    const core::Vec3 back = (from - at).normalized(), right = core::Vec3::UnitY().cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    return {Eigen::Quaterniond(axes), from};
}
