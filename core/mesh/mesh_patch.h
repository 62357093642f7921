#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace core
{
/// A vertex as viewers draw it: 24 bytes.
struct DrawVertex
{
    /// Curvature byte of a surface that is neither concave nor convex.
    static constexpr std::uint8_t flat = 128;

    Vec3f position;
    std::array<std::int8_t, 4> normal; ///< unit normal x 127; [3]: half of the mask (see Mesh::mask)
    std::array<std::uint8_t, 4> color; ///< sRGB; [3]: curvature, from 1 (sharp valley) to 255 (sharp ridge)
    /// Direction x 127 of the sharp edge through the vertex, in either sense. Of unit length, less if a third sharp
    /// edge meets the vertex; zero where the edge turns. [3]: sharpness, from 0 (smooth) to 127 (45 degrees or more).
    std::array<std::int8_t, 4> crease{};
};
static_assert(sizeof(DrawVertex) == 24);

/// A range of `count` slots from `first` on. The values of all spans are concatenated in the patch's value array.
struct SlotSpan
{
    Slot first = 0;
    Slot count = 0;
    friend bool operator==(const SlotSpan&, const SlotSpan&) = default;
};

/// The changes that a viewer needs to draw. The draw arrays are slot-stable: vertex slot i is vertex i of the buffers,
/// and face slot f is index triple f (0,0,0 for a free face). Values are absolute, so a newer patch can be merged into
/// an older one, slot by slot. Spans are ascending, disjoint and not adjacent. A patch always shows the mesh between
/// two sub-steps.
struct MeshPatch
{
    std::vector<SlotSpan> vertexSpans;
    std::vector<DrawVertex> vertices;
    std::vector<SlotSpan> faceSpans;
    std::vector<Triangle> faces;
    Slot vertexSlots = 0; ///< length of the draw arrays after this patch
    Slot faceSlots = 0;
    Slot liveVertices = 0; ///< number in the whole mesh, for display to users
    Slot liveFaces = 0;
    std::uint64_t epoch = 0; ///< grows with each patch of a mesh
    /// Steady-clock time in nanoseconds of the input that caused this patch, 0 if none; used to measure latency.
    std::int64_t sampledNs = 0;
    bool whole = false; ///< covers every slot: can be applied whatever the viewer has now
    /// The draw arrays become shorter. Can be the only change, if just the last slots were removed.
    bool shortens = false;

    bool empty() const { return vertexSpans.empty() && faceSpans.empty() && !whole && !shortens; }

    /// Replaces values of this patch by those of `newer`. Cost: O(values in both patches).
    void merge(MeshPatch&& newer);
};
} // namespace core
