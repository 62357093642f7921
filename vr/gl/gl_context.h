#pragma once

#include "vr/gl/gl_connection.h"

#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace vr
{
/// An OpenGL context for another thread. Made on the gui thread, where Qt wants that; used on the one that claims it.
/// Any thread may destroy it, except one that was claimed, which has to be destroyed by destroy() first.
class GlContext
{
public:
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// From here on it belongs to the thread that calls, and is current there. False where there is no OpenGL 3.3, or
    /// not on other threads.
    bool claim();
    /// Again: a runtime may put its own in its place whenever it is called. Costs next to nothing where it has not.
    void makeCurrent();
    /// Current again, and returns when all that was drawn with it is done.
    void finish();
    /// By the thread that claimed it, before that ends. It cannot be claimed again.
    void destroy();

    /// Whose functions are to be called: Qt takes it for current wherever ours is, over whichever connection that
    /// draws.
    QOpenGLContext& context() { return *m_context; }

private:
    bool isGoodEnough() const;

    /// Deletes on the gui thread, where it was made; at once if that is this thread.
    struct DeleteOnGuiThread
    {
        void operator()(QOffscreenSurface* surface) const;
    };

    std::unique_ptr<QOffscreenSurface, DeleteOnGuiThread> m_surface;
    std::unique_ptr<QOpenGLContext> m_context;
    std::unique_ptr<GlConnection> m_connection; ///< what draws instead, where there is one
};
} // namespace vr
