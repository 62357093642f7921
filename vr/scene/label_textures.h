#pragma once

#include "vr/gl/texture.h"

#include <QHash>
#include <QString>

#include <optional>

namespace vr
{
/// A texture, good until the next startFrame(), and how much wider than high it is.
struct LabelTexture
{
    unsigned int texture = 0;
    double aspect = 1;
};

/// Short texts on small dark plates, painted when they are first needed and kept while they are. Costs a fraction of a
/// millisecond for a new text, one in a frame, and no more than a look-up for the others.
class LabelTextures
{
public:
    /// Loads the font, too, which takes its time.
    void create(QOpenGLExtraFunctions* gl);
    void destroy();

    /// To be called once a frame, before any find().
    void startFrame();
    /// Nothing: not painted yet; some frame later it is.
    std::optional<LabelTexture> find(const QString& text);

private:
    struct Entry
    {
        Texture picture;
        unsigned long usedIn = 0; ///< the last frame that needed it
    };
    void dropUnused();

    QOpenGLExtraFunctions* m_gl = nullptr;
    QHash<QString, Entry> m_entries;
    unsigned long m_frame = 0;
    bool m_mayPaint = false;
};
} // namespace vr
