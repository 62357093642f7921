#pragma once

#include "vr/simulator/motion.h"
#include "vr/simulator/profiles.h"

#include <algorithm>
#include <map>
#include <set>

namespace simulator
{
enum class Pace {
    Real,   ///< a frame lasts as long as the display's
    Live,   ///< the same, and a client that is slower misses frames: time is the clock's
    Fast,   ///< xrWaitFrame does not wait
    Stepped ///< xrWaitFrame waits until the control lets a frame go
};

enum class Tracking {
    Full,
    RotationOnly, ///< the position is a guess
    NoPosition,   ///< not even that
    None
};

enum class Views { Stereo, Mono, MonoFirst };

struct Headset
{
    int width = 1080, height = 1200; ///< pixels of one eye, recommended
    double hertz = 90;
    std::vector<float> otherRates; ///< that the display can have, in hertz

    /// Everything that it can have.
    std::vector<float> rates() const
    {
        std::vector<float> all = otherRates;
        if (std::find(all.begin(), all.end(), static_cast<float>(hertz)) == all.end())
            all.push_back(static_cast<float>(hertz));
        return all;
    }
    Views views = Views::Stereo;
    double eyeDistance = 0.064;               ///< metres
    XrFovf fov{-0.94F, 0.81F, 0.96F, -0.98F}; ///< of the left eye; the right one's is its mirror image
    double hiddenShare = 0;                   ///< of a picture's sides, at each corner, which a lens hides
};

struct Head
{
    Motion motion; ///< between the eyes
    Tracking tracking = Tracking::Full;
};

struct Wand
{
    bool isOn = true;
    Tracking tracking = Tracking::Full;
    Motion grip;
    std::vector<Track<double>> inputs{inputCount, Track<double>(0)};

    double value(Input input, XrTime time) const { return inputs[static_cast<std::size_t>(input)].at(time); }
};

/// Answers a call in the runtime's stead, that many times.
struct ScriptedResult
{
    XrResult result = XR_SUCCESS;
    int times = 1;
    int after = 0; ///< calls that are answered as ever before it
};

/// All that a script steers. Poses are in the room: metres, Y up, the floor at y = 0.
struct SimulatedWorld
{
    SimulatedWorld();

    XrDuration period() const { return static_cast<XrDuration>(1e9 / headset.hertz + 0.5); }
    /// The display time of the next frame, if it is not late.
    XrTime next() const { return now + period(); }

    XrTime now = 1'000'000'000; ///< the display time of the frame that was last waited for
    XrDuration late = 0;        ///< of the next frame
    Pace pace = Pace::Real;
    Headset headset;

    bool hasRuntime = true, hasHeadset = true, hasOpenGl = true;
    bool hasExtensions = true; ///< besides OpenGL's
    XrVersion leastOpenGl = XR_MAKE_VERSION(3, 3, 0);
    bool isWorn = true, isVisible = true, hasFocus = true, shouldRender = true;

    Head head;
    std::array<Wand, hands.size()> wands;
    vr::Pose aim; ///< where a wand points, as seen from its grip
    std::string profile = "/interaction_profiles/htc/vive_controller";

    bool hasStage = true, hasLocalFloor = false;
    Motion stage, local; ///< origins
    std::optional<XrExtent2Df> bounds = XrExtent2Df{3, 2};

    std::map<std::string, ScriptedResult> scriptedResults; ///< by call
    std::string frozen;                                    ///< the call that does not return
    std::set<std::int64_t> keptFrames;                     ///< whose pictures are kept
    int keepEvery = 0;
    bool watchesDrawing = false; ///< a swapchain that goes while its images are drawn on is an error
};
} // namespace simulator
