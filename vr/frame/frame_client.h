#pragma once

#include "vr/frame/frame_timing.h"
#include "vr/gl/eye_image.h"
#include "vr/openxr/hand_joints.h"
#include "vr/openxr/haptic_pulse.h"
#include "vr/openxr/wand_state.h"
#include "vr/util/pose.h"

#include <cstdint>
#include <optional>
#include <vector>

class QOpenGLContext;

namespace vr
{
/// Input of a frame, known before the frame is drawn. Poses are in room space, at the time when the frame will be
/// displayed.
struct FrameInput
{
    Wands wands;
    std::optional<Pose> head;   ///< none: the runtime has not reported it in this room space yet
    std::int64_t displayNs = 0; ///< display time in nanoseconds of the runtime's clock; only differences have a meaning
    /// false: the runtime's menu or another program has the wands, and their buttons count as released.
    bool hasFocus = false;
    bool roomMoved = false; ///< room space was redefined since the last frame: grabs and strokes in progress must end
    const FrameTimings& timings;
    bool offersPassthrough = false; ///< the headset can show the real room behind the picture
    /// Joints of bare hands, indexed by Side; none: a wand, a hand that is not tracked, or a runtime that has no
    /// joints.
    std::array<std::optional<HandJoints>, sideCount> joints{};

    double seconds() const { return static_cast<double>(displayNs) * 1e-9; }
};

struct FrameOutput
{
    std::vector<HapticPulse> pulses;
    /// Recentres: moves the room's origin to the head's position and yaw. FrameInput::roomMoved reports the change.
    bool recentre = false;
    bool leave = false;
    bool passthrough = false; ///< shows the real room behind the picture in this frame, if the headset can
};

/// Decides what the user sees and does in the headset.
///
/// Thread: the headset's, with its OpenGL context current. No function may wait for another thread.
class FrameClient
{
public:
    virtual ~FrameClient() = default;

    /// Prepares drawing with this context. Returns false if that is impossible; VR then ends.
    virtual bool create(QOpenGLContext& context) = 0;
    /// Processes the input of a frame. Called once for each frame, even if the frame will not be shown.
    virtual FrameOutput frame(const FrameInput& input) = 0;
    /// Fills the image of one eye. Called for each eye of a frame that will be shown; eye 0 is the left or the only
    /// eye. `view` has no framebuffer yet. The OpenGL state on entry is arbitrary.
    virtual void draw(std::size_t eye, const EyeImage& image, const EyeView& view) = 0;
    /// Ends actions in progress: the session has stopped, and frames pause, perhaps for good. FrameInput::hasFocus may
    /// have been true up to the last frame.
    virtual void idle() = 0;
    /// Returns the total CPU time that this thread has spent in draw calls, in milliseconds; see FrameTiming.
    virtual double drawCallMs() const = 0;
    /// Releases everything. Called once for each create(), even if create() returned false.
    virtual void destroy() = 0;
};
} // namespace vr
