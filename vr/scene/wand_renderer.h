#pragma once

#include "vr/scene/mesh_buffer.h"
#include "vr/scene/mesh_program.h"
#include "vr/scene/scene_state.h"
#include "vr/util/draw_call_timer.h"

namespace vr
{
/// Draws wands with the shader of the mesh. Precondition: the context of create() is current at every call.
class WandRenderer
{
public:
    void create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// Draws a wand. Precondition: `program` is in use for this eye.
    void draw(const EyeUniforms& eye, const MeshProgram& program, const ShownWand& wand);

private:
    void drawBall(const EyeUniforms& eye, const MeshProgram& program, const Eigen::Affine3d& place);
    void drawHand(const EyeUniforms& eye, const MeshProgram& program, const HandJoints& joints);

    DrawCallTimer* m_clock = nullptr;
    std::array<MeshBuffer, wandPartCount> m_parts;
};
} // namespace vr
