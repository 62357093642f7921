#include "vr/gl/gl_context.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QThread>

namespace vr
{
namespace
{
/// Returns the format of a surface that is never drawn to: all drawing is done into textures.
QSurfaceFormat plainFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapInterval(0);
    return format;
}
} // namespace

/// Detaches the context from the gui thread, so that any thread can claim it.
GlContext::GlContext() : m_surface(new QOffscreenSurface), m_context(std::make_unique<QOpenGLContext>())
{
    m_context->setFormat(plainFormat());
    if (m_context->create()) {
        m_surface->setFormat(m_context->format());
        m_surface->create();
    }
    m_context->moveToThread(nullptr);
}

GlContext::~GlContext() = default;

void GlContext::DeleteOnGuiThread::operator()(QOffscreenSurface* surface) const
{
    if (surface->thread() == QThread::currentThread())
        delete surface;
    else
        surface->deleteLater();
}

bool GlContext::isGoodEnough() const
{
    return m_context->isValid() && m_surface->isValid() && QOpenGLContext::supportsThreadedOpenGL() &&
           !m_context->isOpenGLES() && m_context->format().version() >= std::pair(3, 3);
}

bool GlContext::claim()
{
    m_context->moveToThread(QThread::currentThread());
    if (!isGoodEnough() || !m_context->makeCurrent(m_surface.get()))
        return false;
    m_connection = separateConnection();
    if (m_connection && !m_connection->makeCurrent())
        m_connection.reset();
    return m_connection || m_context->makeCurrent(m_surface.get());
}

void GlContext::makeCurrent()
{
    if (m_connection)
        m_connection->makeCurrent();
    else
        m_context->makeCurrent(m_surface.get());
}

void GlContext::finish()
{
    makeCurrent();
    m_context->functions()->glFinish();
}

void GlContext::destroy()
{
    m_connection.reset();
    if (QOpenGLContext::currentContext() == m_context.get())
        m_context->doneCurrent();
    m_context.reset();
}
} // namespace vr
