#pragma once

#include "vr/gl/eye_image.h"
#include "vr/util/draw_call_timer.h"

class QOpenGLExtraFunctions;

namespace vr
{
/// A multisampled framebuffer with depth that an eye is drawn into, and the step that resolves it into the runtime's
/// image. One framebuffer serves all images of the same format and size. Precondition: the context of create() is
/// current at every call.
class EyeTarget
{
public:
    static constexpr int wantedSamples = 4;

    /// Prepares a framebuffer of `samples` samples per pixel, or of as many as the driver supports.
    void create(QOpenGLExtraFunctions* gl, int samples = wantedSamples);
    void destroy();

    /// Returns the framebuffer to draw into for this image; 0 if the driver can make none. Cost: an allocation if the
    /// format or the size differs from the last call.
    unsigned int framebufferFor(const EyeImage& image);
    /// Resolves the framebuffer into `image`, and its depth if the image has a depth texture. Returns false if the
    /// driver cannot draw into the image. Precondition: `image` is the one last passed to framebufferFor().
    bool resolve(const EyeImage& image);

    /// Returns the samples per pixel of the present framebuffer; 0 or 1: it is not multisampled.
    int samples() const { return m_samples; }
    double drawCallMs() const { return m_clock.milliseconds(); } ///< CPU time of resolving since create(), milliseconds

private:
    bool allocate(const EyeImage& image, int samples);

    QOpenGLExtraFunctions* m_gl = nullptr;
    DrawCallTimer m_clock;
    int m_wanted = 0, m_samples = 0;
    EyeImage m_made; ///< format and size of the present buffers
    bool m_isComplete = false;
    unsigned int m_drawn = 0, m_color = 0, m_depth = 0;
    unsigned int m_resolved = 0;
};
} // namespace vr
