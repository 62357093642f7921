#pragma once

#include "vr/gl/gl_program.h"
#include "vr/scene/eye_uniforms.h"
#include "vr/util/draw_call_timer.h"

namespace vr
{
/// A soft shadow of the model on the floor. Units: metres in room space.
struct FloorShade
{
    Eigen::Vector3f under = Eigen::Vector3f::Zero(); ///< point of the floor below the model's middle, y = 0
    /// Half extents of the shadow; they grow with the model's height above the floor.
    Eigen::Vector2f halfSize{1, 1};
    float strength = 0;
};

/// Draws the room around the model. Precondition: the context of create() is current at every call.
class RoomRenderer
{
public:
    bool create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// Draws the background behind everything that was drawn before.
    void drawDome(const EyeUniforms& eye);
    /// Draws a grid at y = 0 around the middle of the room. Precondition: blending is enabled.
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
