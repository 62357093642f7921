#include "ui/scene/render_target.h"

#include <QOpenGLFunctions_3_3_Core>

#include <algorithm>

namespace ui
{
void RenderTarget::create(QOpenGLFunctions_3_3_Core* gl, int samples)
{
    m_gl = gl;
    GLint max = 0;
    m_gl->glGetIntegerv(GL_MAX_SAMPLES, &max);
    m_samples = std::min(samples, static_cast<int>(max));
    m_gl->glGenFramebuffers(1, &m_drawn);
    m_gl->glGenFramebuffers(1, &m_resolved);
    m_gl->glGenRenderbuffers(1, &m_color);
    m_gl->glGenRenderbuffers(1, &m_depth);
    m_gl->glGenTextures(1, &m_texture);
}

void RenderTarget::destroy()
{
    if (!m_gl)
        return;
    m_gl->glDeleteFramebuffers(1, &m_drawn);
    m_gl->glDeleteFramebuffers(1, &m_resolved);
    m_gl->glDeleteRenderbuffers(1, &m_color);
    m_gl->glDeleteRenderbuffers(1, &m_depth);
    m_gl->glDeleteTextures(1, &m_texture);
    *this = {};
}

bool RenderTarget::resize(QSize pixels)
{
    if (pixels == m_size)
        return true;
    m_size = pixels;
    const int w = pixels.width(), h = pixels.height();
    m_gl->glBindRenderbuffer(GL_RENDERBUFFER, m_color);
    m_gl->glRenderbufferStorageMultisample(GL_RENDERBUFFER, m_samples, GL_RGBA8, w, h);
    m_gl->glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    m_gl->glRenderbufferStorageMultisample(GL_RENDERBUFFER, m_samples, GL_DEPTH_COMPONENT24, w, h);
    m_gl->glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_gl->glBindTexture(GL_TEXTURE_2D, 0);

    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_resolved);
    m_gl->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
    const bool texture = m_gl->glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_drawn);
    m_gl->glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_color);
    m_gl->glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
    return texture && m_gl->glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void RenderTarget::bind() const
{
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_drawn);
    m_gl->glViewport(0, 0, m_size.width(), m_size.height());
}

void RenderTarget::resolve() const
{
    const int w = m_size.width(), h = m_size.height();
    m_gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, m_drawn);
    m_gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved);
    m_gl->glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    m_gl->glBindFramebuffer(GL_FRAMEBUFFER, m_drawn);
}
} // namespace ui
