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
/// The camera with which the model was last viewed. World space, mm.
struct SavedView
{
    Vec3 target = Vec3::Zero();
    double distance = 1;       ///< distance from the eye to the target, mm, above 0
    double yaw = 0, pitch = 0; ///< radians; yaw 0 and pitch 0 look along -Z, pitch above 0 looks down
    bool orthographic = false;
};

/// The work done on a model on the desktop and in VR (app/document/work_timer.h says how it is measured).
struct WorkDone
{
    std::uint64_t strokes = 0; ///< finished strokes that changed the model, including any undone later
    double seconds = 0;        ///< working time in seconds, without long pauses

    friend bool operator==(const WorkDone&, const WorkDone&) = default;
};

/// A reference image beside the model, and its placement as seen from one side of the view.
struct SavedReference
{
    std::string side;           ///< "front", "back", "right", "left", "top" or "bottom"
    std::filesystem::path path; ///< path of the image file; absolute
    double width = 100;         ///< width of the image, mm, above 0
    double x = 0, y = 0;        ///< centre of the image relative to the origin, mm, to the right and up
    double opacity = 1;         ///< opacity of the image, above 0, at most 1
    bool inFront = false;       ///< drawn over the model instead of behind it

    friend bool operator==(const SavedReference&, const SavedReference&) = default;
};

/// The data of a document that its file stores in addition to the surface.
struct DocumentMetadata
{
    std::vector<Rgb> palette;       ///< the document's colour swatches, at most 64; may be empty
    std::optional<MeshFrame> frame; ///< the frame of the document's mesh
    std::optional<SavedView> view;
    std::optional<StrokeSettings> brush; ///< the current brush with its symmetry
    std::optional<WorkDone> work;        ///< empty: work was not measured
    /// Reference images, at most one for each side. A file stores a relative path for an image in its own folder or
    /// below, so that the folder can be moved.
    std::vector<SavedReference> references;

    /// Returns MeshFrame::place of the frame; zero without a frame.
    Vec3 place() const { return frame ? frame->place : Vec3::Zero(); }
};
} // namespace core
