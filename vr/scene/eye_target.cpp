#include "vr/scene/eye_target.h"

#include <QOpenGLExtraFunctions>

#include <algorithm>

namespace vr
{
void EyeTarget::create(QOpenGLExtraFunctions* gl, int samples)
{
    m_gl = gl;
    m_wanted = samples;
    m_gl->glGenFramebuffers(1, &m_drawn);
    m_gl->glGenFramebuffers(1, &m_resolved);
    m_gl->glGenRenderbuffers(1, &m_color);
    m_gl->glGenRenderbuffers(1, &m_depth);
}

void EyeTarget::destroy()
{
    if (!m_gl)
        return;
    m_gl->glDeleteFramebuffers(1, &m_drawn);
    m_gl->glDeleteFramebuffers(1, &m_resolved);
    m_gl->glDeleteRenderbuffers(1, &m_color);
    m_gl->glDeleteRenderbuffers(1, &m_depth);
    *this = {};
}

unsigned int EyeTarget::framebufferFor(const EyeImage& image)
{
    const EyeImage wanted{0, image.format, image.width, image.height, 0, image.depthFormat};
    if (wanted != m_made) {
        m_made = wanted;
        GLint maxSamples = 0;
        m_gl->glGetIntegerv(GL_MAX_SAMPLES, &maxSamples);
        m_samples = std::min(m_wanted, static_cast<int>(maxSamples));
        while (!(m_isComplete = allocate(image, m_samples)) && m_samples > 0)
            m_samples /= 2;
    }
    return m_isComplete ? m_drawn : 0;
}

bool EyeTarget::allocate(const EyeImage& image, int samples)
{
    m_gl->glBindRenderbuffer(GL_RENDERBUFFER, m_color);
    m_gl->glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, image.format, image.width, image.height);
    m_gl->glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    const GLenum depthFormat =
        image.depthFormat ? image.depthFormat : GL_DEPTH_COMPONENT24; // resolving requires equal formats
    m_gl->glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, depthFormat, image.width, image.height);
    m_gl->glBindRenderbuffer(GL_RENDERBUFFER, 0);
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_drawn);
    m_gl->glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_color);
    m_gl->glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
    return m_gl->glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

/// GL_FRAMEBUFFER_SRGB is enabled so that the samples are averaged as linear light, not as encoded values.
bool EyeTarget::resolve(const EyeImage& image)
{
    m_gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, m_drawn);
    m_gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved);
    const auto attach = [this](GLenum attachment, unsigned int texture) {
        m_gl->glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
    };
    attach(GL_COLOR_ATTACHMENT0, image.texture);
    attach(GL_DEPTH_ATTACHMENT, image.depthTexture);
    const bool isComplete =
        m_isComplete && m_gl->glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (isComplete) {
        m_gl->glEnable(GL_FRAMEBUFFER_SRGB);
        m_clock.run([&] {
            const GLbitfield what = GL_COLOR_BUFFER_BIT | (image.depthTexture ? GL_DEPTH_BUFFER_BIT : 0U);
            m_gl->glBlitFramebuffer(0, 0, image.width, image.height, 0, 0, image.width, image.height, what, GL_NEAREST);
        });
    }
    attach(GL_COLOR_ATTACHMENT0, 0); // the runtime may delete the textures
    attach(GL_DEPTH_ATTACHMENT, 0);
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return isComplete;
}
} // namespace vr
