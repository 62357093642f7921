#pragma once

#include "vr/scene/mesh_buffer.h"
#include "vr/scene/mesh_program.h"
#include "vr/scene/scene_state.h"
#include "vr/util/thread_cpu_time.h"

namespace vr
{
/// Draws wands, shaded as clay is. The context that was current at create() must be current at every call.
class WandPainter
{
public:
    void create(QOpenGLExtraFunctions* gl, DrawClock* clock);
    void destroy();

    /// `program` is in use for that eye.
    void draw(const EyeFrame& eye, const ClayProgram& program, const ShownWand& wand);

private:
    DrawClock* m_clock = nullptr;
    std::array<MeshBuffer, wandPartCount> m_parts;
};
} // namespace vr
