#include "vr/scene/patch_slices.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vr
{
std::size_t bytesOf(const core::MeshPatch& patch)
{
    return patch.vertices.size() * sizeof(core::DrawVertex) + patch.faces.size() * sizeof(core::Triangle);
}

PatchSlices::PatchSlices(core::MeshPatch whole) : m_patch(std::move(whole))
{
    assert(m_patch.whole);
    m_vertices.left = m_patch.vertices.size();
    m_faces.left = m_patch.faces.size();
    m_slice.vertexSlots = m_patch.vertexSlots;
    m_slice.faceSlots = m_patch.faceSlots;
}

const core::MeshPatch& PatchSlices::next(std::size_t bytes)
{
    assert(!atEnd());
    m_slice.whole = !std::exchange(m_isBegun, true);
    if (m_slice.whole)
        return m_slice;
    const std::size_t vertices = std::min(m_vertices.left, std::max<std::size_t>(1, bytes / sizeof(core::DrawVertex)));
    const std::size_t faces = vertices > 0 ? 0 : std::max<std::size_t>(1, bytes / sizeof(core::Triangle));
    cut<core::DrawVertex>(m_vertices, vertices, {m_patch.vertexSpans, m_patch.vertices},
                          {m_slice.vertexSpans, m_slice.vertices});
    cut<core::Triangle>(m_faces, faces, {m_patch.faceSpans, m_patch.faces}, {m_slice.faceSpans, m_slice.faces});
    return m_slice;
}

template <class Value> void PatchSlices::cut(Cut& at, std::size_t max, Values<Value> from, Values<Value> to)
{
    to.spans.clear();
    to.values.clear();
    const std::size_t count = std::min(at.left, max);
    if (count == 0)
        return;
    const auto first = from.values.begin() + static_cast<std::ptrdiff_t>(at.value);
    to.values.assign(first, first + static_cast<std::ptrdiff_t>(count));
    for (std::size_t wanted = count; wanted > 0;) {
        const core::SlotSpan& span = from.spans[at.span];
        const core::Slot taken = static_cast<core::Slot>(std::min<std::size_t>(wanted, span.count - at.inSpan));
        if (taken > 0)
            to.spans.push_back({span.first + at.inSpan, taken});
        wanted -= taken;
        at.inSpan += taken;
        if (at.inSpan == span.count) {
            ++at.span;
            at.inSpan = 0;
        }
    }
    at.value += count;
    at.left -= count;
    if (at.left == 0)
        std::vector<Value>().swap(from.values);
}
} // namespace vr
