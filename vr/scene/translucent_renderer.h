#pragma once

#include "vr/gl/gl_program.h"
#include "vr/scene/eye_uniforms.h"
#include "vr/scene/mesh_buffer.h"
#include "vr/scene/translucent_shapes.h"
#include "vr/util/draw_call_timer.h"

#include <span>

namespace vr
{
/// Draws translucent shapes, after all opaque ones. Precondition: the context of create() is current at every call.
class TranslucentRenderer
{
public:
    /// Returns false if a shader does not compile.
    bool create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// Writing of depth: on for panels, so that they hide what is drawn later behind them.
    enum class DepthWrite { Off, On };
    /// Draws shapes, which are sorted from far to near, and blends them over the picture.
    void draw(const EyeUniforms& eye, std::span<const TranslucentShape> sorted, DepthWrite depthWrite);

private:
    struct ShellProgram : Program
    {
        Uniform view{this, "view"}, projection{this, "projection"};
        Uniform center{this, "center"}, radius{this, "radius"}, color{this, "color"}, strength{this, "strength"};
    };
    struct LineProgram : Program
    {
        Uniform view{this, "view"}, projection{this, "projection"}, pixel{this, "pixel"};
        Uniform from{this, "from"}, to{this, "to"}, halfWidth{this, "halfWidth"}, color{this, "color"},
            alphas{this, "alphas"};
    };
    struct RectangleProgram : Program
    {
        Uniform clip{this, "clip"}, center{this, "center"}, halfX{this, "halfX"}, halfY{this, "halfY"};
        void place(const Rectangle& at) const;
    };
    struct RingProgram : RectangleProgram
    {
        Uniform inner{this, "inner"}, sweep{this, "sweep"}, color{this, "color"}, alpha{this, "alpha"};
    };
    struct PlaneProgram : RectangleProgram
    {
        Uniform color{this, "color"}, border{this, "border"};
    };
    struct PictureProgram : RectangleProgram
    {
        Uniform picture{this, "picture"}, opacity{this, "opacity"};
    };

    void draw(const Shell& shell);
    void draw(const Line& line);
    void draw(const Ring& ring);
    void draw(const Plane& plane);
    void draw(const Picture& picture);
    void drawShell();
    void drawStrip();
    void setEye(const EyeUniforms& eye);

    QOpenGLExtraFunctions* m_gl = nullptr;
    DrawCallTimer* m_clock = nullptr;
    unsigned int m_noVertices = 0;
    MeshBuffer m_ball; ///< the unit sphere
    ShellProgram m_shell;
    LineProgram m_line;
    RingProgram m_ring;
    PlaneProgram m_plane;
    PictureProgram m_picture;
};
} // namespace vr
