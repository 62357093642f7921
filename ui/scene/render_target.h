#pragma once

#include <QSize>

class QOpenGLFunctions_3_3_Core;

namespace ui
{
/// A multisampled framebuffer with depth, and a texture that receives its resolved image. Thread: the texture may be
/// read in any context of the share group; everything else only in the context that was current at create().
class RenderTarget
{
public:
    void create(QOpenGLFunctions_3_3_Core* gl, int samples);
    void destroy();

    /// Resizes the buffers unless the size is unchanged. Returns false if the driver cannot create them.
    bool resize(QSize pixels);
    QSize size() const { return m_size; }

    void bind() const;
    /// Copies the samples into the texture. Leaves the multisampled framebuffer bound for drawing.
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
