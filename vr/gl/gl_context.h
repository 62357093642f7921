#pragma once

#include "vr/gl/gl_connection.h"

#include <memory>

class QOffscreenSurface;
class QOpenGLContext;

namespace vr
{
/// An OpenGL context for another thread. It is made on the gui thread, as Qt requires, and used on the thread that
/// calls claim(). Any thread may destroy the object; a claimed context needs destroy() first.
class GlContext
{
public:
    GlContext();
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Moves the context to the calling thread and makes it current. Returns false if OpenGL 3.3 is missing, or if it
    /// cannot be used outside the gui thread.
    bool claim();
    /// Makes the context current again: any call into the runtime may replace the current context. Cost: negligible if
    /// the context is still current.
    void makeCurrent();
    /// Makes the context current and waits until everything drawn with it is complete.
    void finish();
    /// Destroys the context, which cannot be claimed again. Precondition: called on the thread that claimed it, before
    /// that thread ends.
    void destroy();

    /// Returns the Qt context whose OpenGL functions are to be called. Qt considers it current even while the context
    /// of m_connection is the one that draws.
    QOpenGLContext& context() { return *m_context; }

private:
    bool isGoodEnough() const;

    /// Deletes the surface on the gui thread, which made it: at once if that is the calling thread, else later.
    struct DeleteOnGuiThread
    {
        void operator()(QOffscreenSurface* surface) const;
    };

    std::unique_ptr<QOffscreenSurface, DeleteOnGuiThread> m_surface;
    std::unique_ptr<QOpenGLContext> m_context;
    std::unique_ptr<GlConnection> m_connection; ///< context that draws in place of m_context; null: m_context draws
};
} // namespace vr
