#include "draw_arrays.h"

#include <algorithm>

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
} // namespace core
