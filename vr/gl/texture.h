#pragma once

#include <QSize>

class QImage;
class QOpenGLExtraFunctions;

namespace vr
{
/// A texture for a panel or a label: what was painted with premultiplied alpha, as a screen would show it, with smaller
/// copies of itself for the distance. The context that was current at create() must be current at every call.
class Texture
{
public:
    void create(QOpenGLExtraFunctions* gl);
    void destroy();

    /// Cost: the picture's bytes; another size than before costs a new allocation in the driver.
    void upload(const QImage& picture);

    unsigned int id() const { return m_id; }
    QSize size() const { return m_size; } ///< pixels; empty before upload()

private:
    QOpenGLExtraFunctions* m_gl = nullptr;
    unsigned int m_id = 0;
    QSize m_size;
};
} // namespace vr
