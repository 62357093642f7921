#pragma once

#include "core/mesh/mesh_frame.h"
#include "core/stroke/stroke.h"

#include <cstdint>
#include <optional>
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

/// What a file keeps of a document beside its surface.
struct DocumentMetadata
{
    std::vector<Rgb> palette;       ///< colours at hand, at most 64; none: empty
    std::optional<MeshFrame> frame; ///< that the surface had
    std::optional<SavedView> view;
    std::optional<StrokeSettings> brush; ///< that was in the hand, with its symmetry
    std::optional<WorkDone> work;        ///< none: nobody counted

    /// Returns the frame's place (MeshFrame::place); zero without a frame.
    Vec3 place() const { return frame ? frame->place : Vec3::Zero(); }
};
} // namespace core
