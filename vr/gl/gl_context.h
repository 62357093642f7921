#pragma once

#include "vr/gl/gl_connection.h"

#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace vr
{
/// An OpenGL context for another thread. Made on the gui thread, where Qt wants that; used on the one that takes it. Any thread may destroy
/// it, but for one that was taken, which has to be destroyed by destroy() first.
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

    /// Whose functions are to be called: Qt takes it for current wherever ours is, over whichever connection that draws.
    QOpenGLContext& context() { return *m_context; }

private:
    bool isGoodEnough() const;

    /// By the gui thread, as it was made: here and now if that is this one.
    struct DeleteWhereItIsAtHome
    {
        void operator()(QOffscreenSurface* surface) const;
    };

    std::unique_ptr<QOffscreenSurface, DeleteWhereItIsAtHome> m_surface;
    std::unique_ptr<QOpenGLContext> m_context;
    std::unique_ptr<GlConnection> m_own; ///< what draws instead, where there is one
};
} // namespace vr
