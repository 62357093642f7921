#pragma once

#include "vr/simulator/calls.h"
#include "vr/simulator/swapchain.h"

namespace simulator
{
/// What a frame shows.
struct Layers
{
    struct Shown
    {
        /// left, right or mono of the first projection layer, and left_depth ... where depth comes with it; quad0,
        /// quad1 ...
        std::string name;
        TexturePart part;
        bool isQuad = false;
        bool isOpaque = true;
    };

    std::vector<Shown> shown;
    nlohmann::json description = nlohmann::json::array();
};

/// Fails as the specification says.
Layers checkedLayers(Call& call, const Session& session, const XrFrameEndInfo& info);

/// If the script wants this frame's: <folder>/session0_frame0012_left.png and so on.
void keepPictures(Runtime& runtime, const Session& session, const Frame& frame, const Layers& layers);
/// If somebody watches: what the left eye sees, or the only one, without the quads.
void showPicture(Runtime& runtime, const Session& session, const Layers& layers);
} // namespace simulator
