#pragma once

#include "core/mesh/mesh_frame.h"
#include "core/stroke/stroke.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace core
{
/// From where a model was looked at last. World space, mm.
struct SavedView
{
    Vec3 target = Vec3::Zero();
    double distance = 1;       ///< from the eye, above 0
    double yaw = 0, pitch = 0; ///< radians; 0, 0 looks along -Z, pitch above 0 looks down
    bool orthographic = false;
};

/// What hands did to a model at the desk and in the headset, as far as it was counted (app/document/work_timer.h says
/// how).
struct WorkDone
{
    std::uint64_t strokes = 0; ///< finished ones that changed something, also those that were undone later
    double seconds = 0;        ///< between them, long pauses left out

    friend bool operator==(const WorkDone&, const WorkDone&) = default;
};

/// An image that a model is sculpted after, and how it stands as seen from a side of the view.
struct SavedReference
{
    std::string side;           ///< "front", "back", "right", "left", "top" or "bottom"
    std::filesystem::path path; ///< of the image; absolute
    double width = 100;         ///< mm, above 0
    double x = 0, y = 0;        ///< mm: the image's middle from the origin, to the right and up
    double opacity = 1;         ///< above 0, at most 1
    bool inFront = false;       ///< over the model instead of behind it

    friend bool operator==(const SavedReference&, const SavedReference&) = default;
};

/// What a file keeps of a document beside its surface.
struct DocumentMetadata
{
    std::vector<Rgb> palette;       ///< colours at hand, at most 64; none: empty
    std::optional<MeshFrame> frame; ///< that the surface had
    std::optional<SavedView> view;
    std::optional<StrokeSettings> brush; ///< that was in the hand, with its symmetry
    std::optional<WorkDone> work;        ///< none: nobody counted
    /// Images, one for each side at most. A file names an image in its own folder or below from there, so that both can
    /// move.
    std::vector<SavedReference> references;

    /// Returns the frame's place (MeshFrame::place); zero without a frame.
    Vec3 place() const { return frame ? frame->place : Vec3::Zero(); }
};
} // namespace core
