#pragma once

#include "vr/gl/gl_program.h"
#include "vr/scene/eye_uniforms.h"
#include "vr/util/thread_cpu_time.h"

namespace vr
{
/// Under what the model hangs: its shade on the floor. Room space.
struct FloorShade
{
    Eigen::Vector3f under = Eigen::Vector3f::Zero(); ///< y = 0
    Eigen::Vector2f halfSize{1, 1};                  ///< metres; the softer the higher
    float strength = 0;
};

/// The room around the model. The context that was current at create() must be current at every call.
class RoomRenderer
{
public:
    bool create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// Behind all that was drawn.
    void drawDome(const EyeUniforms& eye);
    /// A grid at y = 0 about the middle of the room. Blends.
    void drawFloor(const EyeUniforms& eye, const FloorShade& shade);

private:
    struct DomeProgram : Program
    {
        Uniform view{this, "view"}, projection{this, "projection"};
        Uniform top{this, "topColor"}, horizon{this, "horizonColor"}, bottom{this, "bottomColor"};
    };
    struct FloorProgram : Program
    {
        Uniform clip{this, "clip"}, center{this, "center"}, halfX{this, "halfX"}, halfY{this, "halfY"};
        Uniform eyePosition{this, "eyePosition"}, viewMatrix{this, "viewMatrix"},
            projectionMatrix{this, "projectionMatrix"};
        Uniform cell{this, "cell"}, reach{this, "reach"}, under{this, "under"}, footprint{this, "footprint"};
        Uniform lineColor{this, "lineColor"}, lineAlpha{this, "lineAlpha"}, shade{this, "shade"};
    };

    QOpenGLExtraFunctions* m_gl = nullptr;
    DrawCallTimer* m_clock = nullptr;
    unsigned int m_noVertices = 0;
    DomeProgram m_dome;
    FloorProgram m_floor;
};
} // namespace vr
