#pragma once

#include "vr/scene/mesh_buffer.h"
#include "vr/scene/eye_uniforms.h"
#include "vr/gl/gl_program.h"
#include "vr/scene/translucent_shapes.h"
#include "vr/util/thread_cpu_time.h"

#include <span>

namespace vr
{
/// Draws what is seen through, after all that is not. The context that was current at create() must be current at every call.
class GlassPainter
{
public:
    /// False if a shader does not compile.
    bool create(QOpenGLExtraFunctions* gl, DrawClock* clock);
    void destroy();

    /// Panels hide what is drawn later behind them; else depth is left alone.
    enum class Hides { No, Yes };
    /// The farthest first. Blends over what is there.
    void draw(const EyeFrame& eye, std::span<const Glass> sorted, Hides hides);

private:
    struct ShellProgram : Program
    {
        Uniform view{this, "view"}, projection{this, "projection"};
        Uniform center{this, "center"}, radius{this, "radius"}, color{this, "color"}, strength{this, "strength"};
    };
    struct LineProgram : Program
    {
        Uniform view{this, "view"}, projection{this, "projection"}, pixel{this, "pixel"};
        Uniform from{this, "from"}, to{this, "to"}, halfWidth{this, "halfWidth"}, color{this, "color"}, alphas{this, "alphas"};
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
    struct PaneProgram : RectangleProgram
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
    void draw(const Pane& pane);
    void draw(const Picture& picture);
    void drawShell();
    void drawStrip();
    void setEye(const EyeFrame& eye);

    QOpenGLExtraFunctions* m_gl = nullptr;
    DrawClock* m_clock = nullptr;
    unsigned int m_noVertices = 0;
    MeshBuffer m_ball; ///< the unit sphere
    ShellProgram m_shell;
    LineProgram m_line;
    RingProgram m_ring;
    PaneProgram m_pane;
    PictureProgram m_picture;
};
} // namespace vr
