#pragma once

#include "vr/simulator/calls.h"
#include "vr/simulator/swapchain.h"

namespace simulator
{
/// The pictures that a frame shows.
struct Layers
{
    struct Shown
    {
        /// Name of the picture: left, right or mono for a view of the first projection layer; left_depth, right_depth
        /// or mono_depth for its depth; quad0, quad1 and so on.
        std::string name;
        TexturePart part;
        bool isQuad = false;
        bool isOpaque = true;
    };

    XrEnvironmentBlendMode blendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    std::vector<Shown> shown;
    nlohmann::json description = nlohmann::json::array();
};

/// Returns the layers of a frame. Fails where the specification demands it.
Layers checkedLayers(Call& call, const Session& session, const XrFrameEndInfo& info);

/// Writes the pictures of a frame that the script wants, as <folder>/session0_frame0012_left.png and so on.
void keepPictures(Runtime& runtime, const Session& session, const Frame& frame, const Layers& layers);
/// Stores what the left or only eye sees, without the quads, if a picture was requested by fettle_xr_picture().
void showPicture(Runtime& runtime, const Session& session, const Layers& layers);
} // namespace simulator
