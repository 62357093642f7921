#pragma once

#include "vr/scene/mesh_buffer.h"
#include "vr/scene/mesh_program.h"
#include "vr/scene/scene_state.h"
#include "vr/util/thread_cpu_time.h"

namespace vr
{
/// Draws wands, shaded as the mesh is. The context that was current at create() must be current at every call.
class WandRenderer
{
public:
    void create(QOpenGLExtraFunctions* gl, DrawCallTimer* clock);
    void destroy();

    /// `program` is in use for that eye.
    void draw(const EyeUniforms& eye, const MeshProgram& program, const ShownWand& wand);

private:
    DrawCallTimer* m_clock = nullptr;
    std::array<MeshBuffer, wandPartCount> m_parts;
};
} // namespace vr
