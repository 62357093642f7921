#include "core/mesh/mesh_patch.h"

#include <algorithm>

namespace core
{
namespace
{
/// A span of one of the two merged patches, with its values.
template <class Value> struct Piece
{
    Slot first, end;
    const Value* values;
};

template <class Value>
std::vector<Piece<Value>> pieces(const std::vector<SlotSpan>& spans, const std::vector<Value>& values, Slot length)
{
    std::vector<Piece<Value>> result;
    result.reserve(spans.size());
    const Value* at = values.data();
    for (const SlotSpan& span : spans) {
        const Slot end = std::min(span.first + span.count, length);
        if (span.first < end)
            result.push_back({span.first, end, at});
        at += span.count;
    }
    return result;
}

template <class Value> class Overlay
{
public:
    void append(Slot first, Slot end, const Value* from)
    {
        if (m_spans.empty() || m_spans.back().first + m_spans.back().count != first)
            m_spans.push_back({first, 0});
        m_spans.back().count += end - first;
        m_values.insert(m_values.end(), from, from + (end - first));
    }
    void moveTo(std::vector<SlotSpan>& spans, std::vector<Value>& values)
    {
        spans = std::move(m_spans);
        values = std::move(m_values);
    }

private:
    std::vector<SlotSpan> m_spans;
    std::vector<Value> m_values;
};

/// Replaces older values by newer ones; drops slots from `length` on.
template <class Value>
void mergeValues(std::vector<SlotSpan>& spans, std::vector<Value>& values, const std::vector<SlotSpan>& newSpans,
                 const std::vector<Value>& newValues, Slot length)
{
    const std::vector<Piece<Value>> older = pieces(spans, values, length), newer = pieces(newSpans, newValues, length);
    Overlay<Value> result;
    Slot done = 0; // all slots below it are in the result or unchanged
    auto old = older.begin();
    const auto appendOldUpTo = [&](Slot end) {
        for (; old != older.end() && old->first < end; ++old) {
            const Slot from = std::max(done, old->first), to = std::min(end, old->end);
            if (from < to)
                result.append(from, to, old->values + (from - old->first));
            if (old->end > end)
                break; // the rest of the older span is appended after the newer piece
        }
    };
    for (const Piece<Value>& piece : newer) {
        appendOldUpTo(piece.first);
        result.append(piece.first, piece.end, piece.values);
        done = piece.end;
        while (old != older.end() && old->end <= done)
            ++old;
    }
    appendOldUpTo(length);
    result.moveTo(spans, values);
}
} // namespace

void MeshPatch::merge(MeshPatch&& newer)
{
    if (newer.whole) {
        *this = std::move(newer);
        return;
    }
    mergeValues(vertexSpans, vertices, newer.vertexSpans, newer.vertices, newer.vertexSlots);
    mergeValues(faceSpans, faces, newer.faceSpans, newer.faces, newer.faceSlots);
    vertexSlots = newer.vertexSlots;
    faceSlots = newer.faceSlots;
    liveVertices = newer.liveVertices;
    liveFaces = newer.liveFaces;
    shortens = shortens || newer.shortens;
    epoch = newer.epoch;
    sampledNs = sampledNs != 0 ? sampledNs : newer.sampledNs; // keep the oldest input that is not yet displayed
}
} // namespace core
