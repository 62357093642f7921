#pragma once

#include "core/geometry/geometry.h"

#include <vector>

namespace core
{
/// A vertex as viewers draw it: 24 bytes.
struct DrawVertex
{
    /// The curvature of a surface that is neither hollow nor a ridge.
    static constexpr std::uint8_t flat = 128;

    Vec3f position;
    std::array<std::int8_t, 4> normal; ///< unit normal x 127; the fourth is half of the mask (see Mesh::mask)
    std::array<std::uint8_t, 4> color; ///< sRGB; the fourth is the curvature: 1 a sharp valley, 255 a sharp ridge
    /// Unit direction of the sharp edge through the vertex, x 127, to either side; zero where edges meet or turn. The
    /// fourth is how sharp it is: 0 not at all, 127 by 45 degrees or more.
    std::array<std::int8_t, 4> crease{};
};
static_assert(sizeof(DrawVertex) == 24);

/// `count` slots from `first` on; their values follow those of the spans before in the patch's value array.
struct SlotSpan
{
    Slot first = 0;
    Slot count = 0;
    friend bool operator==(const SlotSpan&, const SlotSpan&) = default;
};

/// What viewers must draw anew. The draw arrays are slot-stable: vertex slot i is vertex i of the buffers, face slot f
/// is index triple f (a free face is 0,0,0). Values are absolute, so a newer patch may be merged into an older one,
/// slot by slot. Spans are ascending, disjoint and not adjacent. A patch is always the mesh of a sub-step's boundary.
struct MeshPatch
{
    std::vector<SlotSpan> vertexSpans;
    std::vector<DrawVertex> vertices;
    std::vector<SlotSpan> faceSpans;
    std::vector<Triangle> faces;
    Slot vertexSlots = 0; ///< length of the draw arrays after this patch
    Slot faceSlots = 0;
    Slot liveVertices = 0; ///< of the whole mesh, for people
    Slot liveFaces = 0;
    std::uint64_t epoch = 0;    ///< grows with each patch of a mesh
    std::int64_t sampledNs = 0; ///< steady-clock time of the input that this patch answers, 0 if none (latency)
    bool whole = false;         ///< covers every slot: an earlier patch, or another mesh, need not be known
    /// The draw arrays end sooner than they did: all that changes, where the last slots are given back.
    bool shortens = false;

    bool empty() const { return vertexSpans.empty() && faceSpans.empty() && !whole && !shortens; }

    /// Lays `newer` over this patch. Cost: the sum of both patches' values.
    void merge(MeshPatch&& newer);
};
} // namespace core
