#pragma once

#include "vr/gl/eye_image.h"
#include "vr/gl/gl_program.h"
#include "vr/util/thread_cpu_time.h"

namespace vr
{
/// Covers what of a picture its lens hides, before anything else is drawn: nothing is shaded there. The context that
/// was current at create() must be current at every call.
class HiddenRenderer
{
public:
    bool create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// Draws with depth test and depth writing on.
    void draw(const HiddenArea& area, const Eigen::Matrix4f& projection);

private:
    struct HiddenProgram : Program
    {
        Uniform projection{this, "projection"};
    };

    QOpenGLExtraFunctions* m_gl = nullptr;
    DrawCallTimer* m_clock = nullptr;
    unsigned int m_vertices = 0, m_points = 0;
    HiddenProgram m_program;
};
} // namespace vr
