#pragma once

#include "vr/simulator/motion.h"
#include "vr/simulator/profiles.h"

#include <algorithm>
#include <map>
#include <set>

namespace simulator
{
enum class Pace {
    Real,   ///< a frame lasts as long as on a real display; a slow client makes the display time slow
    Live,   ///< a frame lasts as long as on a real display; a slow client misses frames
    Fast,   ///< xrWaitFrame does not wait
    Stepped ///< xrWaitFrame waits until the control allows a frame
};

enum class Tracking {
    Full,
    RotationOnly, ///< the rotation is known, the position is a guess
    NoPosition,   ///< only the rotation is known
    None
};

enum class Views { Stereo, Mono, MonoFirst };

struct Headset
{
    int width = 1080, height = 1200; ///< recommended size of one eye's picture, pixels
    double hertz = 90;
    std::vector<float> otherRates; ///< other refresh rates of the display, hertz

    /// Returns all refresh rates that the display can have, hertz.
    std::vector<float> rates() const
    {
        std::vector<float> all = otherRates;
        if (std::find(all.begin(), all.end(), static_cast<float>(hertz)) == all.end())
            all.push_back(static_cast<float>(hertz));
        return all;
    }
    Views views = Views::Stereo;
    double eyeDistance = 0.064;               ///< metres
    XrFovf fov{-0.94F, 0.81F, 0.96F, -0.98F}; ///< angles of the left eye, radians; those of the right eye are mirrored
    double hiddenShare = 0;                   ///< fraction of a picture's sides that the lens hides at each corner
};

struct Head
{
    Motion motion; ///< motion of the point between the eyes
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

/// A result that replaces the runtime's own answer to a call.
struct ScriptedResult
{
    XrResult result = XR_SUCCESS;
    int times = 1;
    int after = 0; ///< number of calls that the runtime answers normally before
};

/// Everything that a script controls. Poses are in the room: metres, Y up, the floor at y = 0.
struct SimulatedWorld
{
    SimulatedWorld();

    XrDuration period() const { return static_cast<XrDuration>(1e9 / headset.hertz + 0.5); }
    /// Returns the display time of the next frame if it is not late.
    XrTime next() const { return now + period(); }

    XrTime now = 1'000'000'000; ///< display time of the frame last waited for, nanoseconds
    XrDuration late = 0;        ///< delay of the next frame, nanoseconds
    Pace pace = Pace::Real;
    Headset headset;

    bool hasRuntime = true, hasHeadset = true, hasOpenGl = true;
    bool hasExtensions = true;                   ///< extensions other than OpenGL's are offered
    std::set<std::string, std::less<>> withheld; ///< extensions that are not offered
    std::set<std::uint64_t> minors{0};           ///< minor versions of OpenXR 1 that a client may ask for
    std::set<std::int64_t> failingFormats;       ///< offered formats of which no images are made
    std::vector<XrEnvironmentBlendMode> blendModes{XR_ENVIRONMENT_BLEND_MODE_OPAQUE}; ///< the preferred first
    XrVersion minOpenGl = XR_MAKE_VERSION(3, 3, 0);
    bool isWorn = true, isVisible = true, hasFocus = true, shouldRender = true;

    Head head;
    std::array<Wand, hands.size()> wands;
    vr::Pose aim;   ///< pose of a wand's aim relative to its grip
    vr::Pose pinch; ///< pose between thumb and index finger of a bare hand, relative to its grip
    std::string profile = "/interaction_profiles/htc/vive_controller";

    bool hasStage = true, hasLocalFloor = false;
    Motion stage, local; ///< origins of STAGE and LOCAL in the room
    std::optional<XrExtent2Df> bounds = XrExtent2Df{3, 2};

    std::map<std::string, ScriptedResult> scriptedResults; ///< indexed by the call's name
    std::string frozen;                                    ///< name of the call that does not return
    std::set<std::int64_t> keptFrames;                     ///< frames whose pictures are kept
    int keepEvery = 0;
    bool watchesDrawing = false; ///< destroying a swapchain whose images are still drawn on is an error of the client
};
} // namespace simulator
