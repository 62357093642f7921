#include "draw_arrays.h"

#include <algorithm>
#include <utility>

namespace core
{
namespace
{
template <class Value> void put(const std::vector<SlotSpan>& spans, const std::vector<Value>& values, std::vector<Value>& array)
{
    auto from = values.begin();
    for (const SlotSpan& span : spans) {
        const auto to = array.begin() + static_cast<std::ptrdiff_t>(span.first);
        std::copy_n(from, span.count, to);
        from += static_cast<std::ptrdiff_t>(span.count);
    }
}
} // namespace

void DrawArrays::apply(const MeshPatch& patch)
{
    vertices.resize(patch.vertexSlots, DrawVertex{Vec3f::Zero(), {}, {}});
    faces.resize(patch.faceSlots, Triangle{0, 0, 0});
    put(patch.vertexSpans, patch.vertices, vertices);
    put(patch.faceSpans, patch.faces, faces);
}

MeshPatch wholePatchOf(DrawArrays arrays)
{
    MeshPatch patch;
    patch.whole = true;
    patch.vertexSlots = patch.liveVertices = static_cast<Slot>(arrays.vertices.size());
    patch.faceSlots = patch.liveFaces = static_cast<Slot>(arrays.faces.size());
    patch.vertexSpans = {{0, patch.vertexSlots}};
    patch.faceSpans = {{0, patch.faceSlots}};
    patch.vertices = std::move(arrays.vertices);
    patch.faces = std::move(arrays.faces);
    return patch;
}
} // namespace core
