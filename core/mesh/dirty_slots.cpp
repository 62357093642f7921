#include "core/mesh/dirty_slots.h"

#include "core/mesh/draw_vertex.h"
#include "core/util/parallel.h"

#include <algorithm>

namespace core
{
namespace
{
/// Largest gap, in slots, between two dirty slots of one span. The unchanged values in the gap are sent too: for
/// viewers fewer, longer spans save more than the extra bytes cost.
constexpr Slot vertexGap = 4, faceGap = 8;
constexpr std::size_t slotsPerChunk = 256;

std::vector<SlotSpan> spansOf(SlotSet& dirty, Slot length, Slot gap)
{
    dirty.sort();
    std::vector<SlotSpan> spans;
    for (Slot slot : dirty.slots()) {
        if (slot >= length)
            break;
        if (!spans.empty() && slot <= spans.back().first + spans.back().count + gap)
            spans.back().count = std::max(spans.back().count, slot + 1 - spans.back().first);
        else
            spans.push_back({slot, 1});
    }
    return spans;
}

/// Returns which parts are drawn, by id. Faces of other parts are drawn as free ones.
std::vector<bool> drawnParts(const Mesh& mesh)
{
    std::vector<bool> drawn;
    for (const Part& part : mesh.frame().parts.all()) {
        drawn.resize(std::max(drawn.size(), part.id + std::size_t(1)));
        drawn[part.id] = part.isVisible;
    }
    return drawn;
}

void fillValues(MeshPatch& patch, const Mesh& mesh)
{
    const std::vector<bool> drawn = drawnParts(mesh);
    const auto isDrawn = [&](Slot f) {
        const PartId part = mesh.partOfFace(f);
        return mesh.isFace(f) && part < drawn.size() && drawn[part] && !mesh.isFaceHidden(f);
    };
    std::vector<Slot> slots;
    for (const SlotSpan& span : patch.vertexSpans) {
        for (Slot v = span.first; v < span.first + span.count; ++v)
            slots.push_back(v);
    }
    patch.vertices.resize(slots.size());
    forEachChunk(slots.size(), slotsPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            patch.vertices[i] = drawVertex(mesh, slots[i]);
    });
    for (const SlotSpan& span : patch.faceSpans) {
        for (Slot f = span.first; f < span.first + span.count; ++f)
            patch.faces.push_back(isDrawn(f) ? mesh.corners(f) : Triangle{0, 0, 0});
    }
    patch.vertexSlots = mesh.slots().vertices;
    patch.faceSlots = mesh.slots().faces;
    patch.liveVertices = mesh.live().vertices;
    patch.liveFaces = mesh.live().faces;
}
} // namespace

void DirtySlots::add(const Mesh& mesh, const TouchedSlots& touched, std::span<const Slot> dirtyFaces)
{
    for (Slot f : touched.faces)
        m_faces.add(f);
    for (Slot v : touched.vertices)
        m_vertices.add(v);
    for (Slot f : dirtyFaces) {
        for (Slot v : mesh.corners(f))
            m_vertices.add(v);
    }
}

MeshPatch DirtySlots::take(const Mesh& mesh)
{
    MeshPatch patch;
    patch.vertexSpans = spansOf(m_vertices, mesh.slots().vertices, vertexGap);
    patch.faceSpans = spansOf(m_faces, mesh.slots().faces, faceGap);
    m_vertices.clear();
    m_faces.clear();
    fillValues(patch, mesh);
    patch.shortens = patch.vertexSlots < m_vertexSlots || patch.faceSlots < m_faceSlots;
    m_vertexSlots = patch.vertexSlots;
    m_faceSlots = patch.faceSlots;
    patch.epoch = ++m_epoch;
    return patch;
}

MeshPatch wholePatchOf(const Mesh& mesh)
{
    MeshPatch patch;
    patch.whole = true;
    patch.vertexSpans = {{0, mesh.slots().vertices}};
    patch.faceSpans = {{0, mesh.slots().faces}};
    patch.vertices.reserve(mesh.slots().vertices);
    patch.faces.reserve(mesh.slots().faces);
    fillValues(patch, mesh);
    return patch;
}
} // namespace core
