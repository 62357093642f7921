#pragma once

#include "vr/frame/frame_timing.h"
#include "vr/gl/eye_image.h"
#include "vr/openxr/haptic_pulse.h"
#include "vr/openxr/wand_state.h"
#include "vr/util/pose.h"

#include <cstdint>
#include <optional>
#include <vector>

class QOpenGLContext;

namespace vr
{
/// What is known of a frame before it is drawn. Room space; all of the same time, at which the frame will be seen.
struct FrameInput
{
    Wands wands;
    std::optional<Pose> head;   ///< none as long as the runtime has not known it
    std::int64_t displayNs = 0; ///< the runtime's clock: for differences
    bool hasFocus = false;      ///< else people are in the runtime's menu or elsewhere, and wands are at rest
    bool roomMoved = false; ///< room space is another than in the frame before: what was held there, or drawn, is over
    const FrameTimings& timings;

    double seconds() const { return static_cast<double>(displayNs) * 1e-9; }
};

struct FrameOutput
{
    std::vector<HapticPulse> pulses;
    /// The room is put where the head is, by its position and yaw; FrameInput::roomMoved then tells.
    bool recentre = false;
    bool leave = false;
};

/// What people see and do in the headset. All is called on the headset's thread, with its OpenGL context current, and
/// nothing of it may wait for another thread.
class FrameClient
{
public:
    virtual ~FrameClient() = default;

    /// False: it cannot draw here, and VR ends.
    virtual bool create(QOpenGLContext& context) = 0;
    /// Once each frame, seen or not.
    virtual FrameOutput frame(const FrameInput& input) = 0;
    /// Of a frame that will be seen, for each eye in turn; eye 0 is the left, or the only one. The image is to be
    /// filled; the view has no framebuffer yet. OpenGL's state is anybody's.
    virtual void draw(std::size_t eye, const EyeImage& image, const EyeView& view) = 0;
    /// The session does not run: no frames come for a while, perhaps none at all. Ends what is in progress. The last
    /// frame need not have shown why.
    virtual void idle() = 0;
    /// CPU time of this thread within calls that draw, ever, in milliseconds: see FrameTiming.
    virtual double drawCallMs() const = 0;
    /// Once for each create(), whatever it said.
    virtual void destroy() = 0;
};
} // namespace vr
