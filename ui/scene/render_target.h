#pragma once

#include <QSize>

class QOpenGLFunctions_3_3_Core;

namespace ui
{
/// A multisampled framebuffer with depth, and the texture that its picture is resolved into. The texture may be read in
/// any context of the share group; all else in the one that was current at create().
class RenderTarget
{
public:
    void create(QOpenGLFunctions_3_3_Core* gl, int samples);
    void destroy();

    /// Does nothing if the size is the same. False if the driver cannot make it.
    bool resize(QSize pixels);
    QSize size() const { return m_size; }

    void bind() const;
    /// Leaves the multisampled framebuffer bound for drawing.
    void resolve() const;
    unsigned int framebuffer() const { return m_drawn; }
    unsigned int texture() const { return m_texture; }

private:
    QOpenGLFunctions_3_3_Core* m_gl = nullptr;
    int m_samples = 0;
    QSize m_size;
    unsigned int m_drawn = 0, m_color = 0, m_depth = 0;
    unsigned int m_resolved = 0, m_texture = 0;
};
} // namespace ui
