#pragma once

#include "ui/scene/scene.h"

#include <QImage>
#include <QOpenGLExtraFunctions>

/// Returns the pixels of a rendered image. Precondition: the scene's context is current, as after render().
inline QImage pixelsOf(const ui::Scene::Image& image, QSize size)
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
