#pragma once

#include "clay_buffer.h"
#include "clay_program.h"
#include "scene_state.h"
#include "thread_clock.h"

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
    std::array<ClayBuffer, wandPartCount> m_parts;
};
} // namespace vr
