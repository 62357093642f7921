#pragma once

#include <QSize>

class QImage;
class QOpenGLExtraFunctions;

namespace vr
{
/// A mip-mapped texture of a panel or a label. Its colours are sRGB-encoded, with premultiplied alpha.
/// Precondition: the context of create() is current at every call.
class Texture
{
public:
    void create(QOpenGLExtraFunctions* gl);
    void destroy();

    /// Replaces the picture. Cost: copies its bytes, and makes the mip levels; a new size needs new memory too.
    void upload(const QImage& picture);

    unsigned int id() const { return m_id; }
    QSize size() const { return m_size; } ///< pixels; empty before upload()

private:
    QOpenGLExtraFunctions* m_gl = nullptr;
    unsigned int m_id = 0;
    QSize m_size;
};
} // namespace vr
