#pragma once

#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace vr
{
/// An OpenGL context for another thread. Made and destroyed on the gui thread, where Qt wants that; used on the one that takes it.
class GlContext
{
public:
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// From here on it belongs to the thread that calls, and is current there. False where there is no OpenGL 3.3, or not on other threads.
    bool take();
    /// Again: a runtime may put its own in its place whenever it is called. Costs next to nothing where it has not.
    void makeCurrent();
    /// Current again, and returns when all that was drawn with it is done.
    void finish();
    /// By the thread that took it, before that ends. It cannot be taken again.
    void destroy();

    QOpenGLContext& context() { return *m_context; }

private:
    std::unique_ptr<QOffscreenSurface> m_surface;
    std::unique_ptr<QOpenGLContext> m_context;
};
} // namespace vr
