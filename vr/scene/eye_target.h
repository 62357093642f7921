#pragma once

#include "vr/gl/eye_image.h"
#include "vr/util/thread_cpu_time.h"

class QOpenGLExtraFunctions;

namespace vr
{
/// A multisampled framebuffer with depth to draw an eye into, one for all images of the same format and size, and the
/// way from there into the image. The context that was current at create() must be current at every call.
class EyeTarget
{
public:
    static constexpr int wantedSamples = 4;

    /// As many samples as are wanted, or else as the driver has.
    void create(QOpenGLExtraFunctions* gl, int samples = wantedSamples);
    void destroy();

    /// The framebuffer to draw into for that image; 0 if the driver can make none. Another format or size than last
    /// time costs an allocation.
    unsigned int framebufferFor(const EyeImage& image);
    /// Resolves what was drawn into the image that framebufferFor() was told of, and its depth where that is wanted.
    /// False if the driver cannot draw into it.
    bool resolve(const EyeImage& image);

    int samples() const { return m_samples; } ///< of the framebuffer as it is; 0 or 1: not multisampled
    double drawCallMs() const { return m_clock.milliseconds(); } ///< CPU time in resolving since create()

private:
    bool allocate(const EyeImage& image, int samples);

    QOpenGLExtraFunctions* m_gl = nullptr;
    DrawCallTimer m_clock;
    int m_wanted = 0, m_samples = 0;
    EyeImage m_made; ///< its format and size are those of the buffers
    bool m_isComplete = false;
    unsigned int m_drawn = 0, m_color = 0, m_depth = 0;
    unsigned int m_resolved = 0;
};
} // namespace vr
