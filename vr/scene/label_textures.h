#pragma once

#include "vr/gl/texture.h"

#include <QHash>
#include <QString>

#include <optional>

namespace vr
{
/// A texture, valid until the next startFrame(), and its width / height.
struct LabelTexture
{
    unsigned int texture = 0;
    double aspect = 1;
};

/// Textures of short texts on small dark plates. Each is painted when it is first needed, and kept at least while it is
/// used. Cost: a fraction of a millisecond for a new text, of which each frame paints at most one; a look-up for the
/// other texts.
class LabelTextures
{
public:
    /// Cost: loads the font, which takes some time.
    void create(QOpenGLExtraFunctions* gl);
    void destroy();

    /// To be called once a frame, before any find().
    void startFrame();
    /// Returns the texture of a text; none if it is not painted yet. A later frame paints it.
    std::optional<LabelTexture> find(const QString& text);

private:
    struct Entry
    {
        Texture picture;
        unsigned long usedIn = 0; ///< number of the last frame that used the texture
    };
    void dropUnused();

    QOpenGLExtraFunctions* m_gl = nullptr;
    QHash<QString, Entry> m_entries;
    unsigned long m_frame = 0;
    bool m_mayPaint = false;
};
} // namespace vr
