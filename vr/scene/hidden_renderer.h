#pragma once

#include "vr/gl/eye_image.h"
#include "vr/gl/gl_program.h"
#include "vr/util/draw_call_timer.h"

namespace vr
{
/// Covers the part of a picture that the lens hides. It is drawn before anything else, so that nothing is shaded there
/// later. Precondition: the context of create() is current at every call.
class HiddenRenderer
{
public:
    bool create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// Covers the area. Precondition: depth test and depth writing are enabled.
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
