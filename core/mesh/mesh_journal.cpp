// The mesh's journal: records before-images of elements at their first touch, and restores them for rollback, undo and
// redo.

#include "core/mesh/mesh.h"

#include "core/mesh/mesh_hash.h"

#include <algorithm>

namespace core
{
void Mesh::touchVertex(Slot v)
{
    assert(m_strokeOpen);
    if (m_vertexStamp[v] >= m_epoch)
        return;
    m_journal.vertices.push_back(
        {v, m_vertexStamp[v], point(v), color(v), mask(v), isVertex(v), m_parts[v], m_kernel.vertex(vertexHandle(v))});
    m_vertexStamp[v] = m_epoch;
}

void Mesh::touchEdge(Slot e)
{
    assert(m_strokeOpen);
    if (m_edgeStamp[e] >= m_epoch)
        return;
    m_journal.edges.push_back({e, m_edgeStamp[e], isEdge(e), m_kernel.edge(edgeHandle(e))});
    m_edgeStamp[e] = m_epoch;
}

void Mesh::touchFace(Slot f)
{
    assert(m_strokeOpen);
    if (m_faceStamp[f] >= m_epoch)
        return;
    m_journal.faces.push_back({f, m_faceStamp[f], m_corners[f], m_kernel.face(faceHandle(f))});
    m_faceStamp[f] = m_epoch;
}

void Mesh::beginStroke()
{
    assert(!m_strokeOpen);
    m_strokeOpen = true;
    m_strokeEpoch = m_baseEpoch = ++m_epoch;
    m_journal = {};
    m_removed.clear();
    m_journal.counts = slots();
    m_journal.meshHash = m_meshHash;
    m_journal.frame = m_frame;
}

MeshDelta Mesh::endStroke()
{
    assert(m_strokeOpen);
    m_strokeOpen = false;
    commit({0, 0, 0, {}, 0}); // edits after a mark store an element again: keeps only its first image
    m_meshHash += hashChange(*this, m_journal);
    return std::move(m_journal);
}

Mesh::Mark Mesh::mark()
{
    assert(m_strokeOpen);
    ++m_epoch;
    return {m_journal.vertices.size(), m_journal.edges.size(), m_journal.faces.size(), slots(), m_epoch, m_frame,
            m_removed.size()};
}

void Mesh::rollback(const Mark& mark)
{
    const auto undo = [&](auto& images, std::size_t keep, auto& stamps) {
        while (images.size() > keep) {
            auto& image = images.back();
            stamps[image.slot] = image.stamp;
            swapImage(image);
            images.pop_back();
        }
    };
    undo(m_journal.vertices, mark.vertices, m_vertexStamp);
    undo(m_journal.edges, mark.edges, m_edgeStamp);
    undo(m_journal.faces, mark.faces, m_faceStamp);
    resize(mark.counts);
    m_frame = mark.frame;
    m_removed.resize(mark.removed);
    ++m_epoch;
}

void Mesh::commit(const Mark& mark)
{
    const auto forget = [&](auto& images, std::size_t from) {
        const auto known = [&](const auto& image) { return image.stamp >= m_baseEpoch; };
        images.erase(std::remove_if(images.begin() + static_cast<std::ptrdiff_t>(from), images.end(), known),
                     images.end());
    };
    forget(m_journal.vertices, mark.vertices);
    forget(m_journal.edges, mark.edges);
    forget(m_journal.faces, mark.faces);
}

Mesh::Mark Mesh::remember()
{
    const Mark mark = this->mark();
    m_baseEpoch = mark.epoch;
    return mark;
}

void Mesh::forget(const Mark& mark)
{
    m_baseEpoch = m_strokeEpoch;
    commit(mark);
}

TouchedSlots Mesh::touchedSince(const Mark& mark) const
{
    TouchedSlots touched;
    for (std::size_t i = mark.vertices; i < m_journal.vertices.size(); ++i) {
        const VertexImage& image = m_journal.vertices[i];
        if (image.stamp >= mark.epoch)
            continue;
        touched.vertices.push_back(image.slot);
        if (image.live)
            touched.before.push_back({image.slot, image.point});
    }
    for (std::size_t i = mark.faces; i < m_journal.faces.size(); ++i) {
        const FaceImage& image = m_journal.faces[i];
        if (image.stamp >= mark.epoch)
            continue;
        touched.faces.push_back(image.slot);
        if (image.live())
            touched.facesBefore.push_back(image.corners);
    }
    return touched;
}

std::span<const VertexImage> Mesh::vertexImagesSince(const Mark& mark) const
{
    return std::span(m_journal.vertices).subspan(mark.vertices);
}

std::span<const FaceImage> Mesh::faceImagesSince(const Mark& mark) const
{
    return std::span(m_journal.faces).subspan(mark.faces);
}

void Mesh::swap(MeshDelta& delta)
{
    assert(!m_strokeOpen);
    const SlotCounts here = slots();
    resize({std::max(here.vertices, delta.counts.vertices), std::max(here.edges, delta.counts.edges),
            std::max(here.faces, delta.counts.faces)});
    for (VertexImage& image : delta.vertices)
        swapImage(image);
    for (EdgeImage& image : delta.edges)
        swapImage(image);
    for (FaceImage& image : delta.faces)
        swapImage(image);
    resize(delta.counts);
    delta.counts = here;
    std::swap(m_meshHash, delta.meshHash);
    std::swap(m_frame, delta.frame);
}

void Mesh::swapImage(VertexImage& image)
{
    const Slot v = image.slot;
    const VertexImage now = {v,       image.stamp, point(v),   color(v),
                             mask(v), isVertex(v), m_parts[v], m_kernel.vertex(vertexHandle(v))};
    m_kernel.set_point(vertexHandle(v), image.point);
    m_kernel.set_color(vertexHandle(v), {image.color.r, image.color.g, image.color.b, image.mask});
    m_kernel.vertex(vertexHandle(v)) = image.item;
    m_parts[v] = image.part;
    m_vertexSlots.setFree(v, !image.live);
    image = now;
}

void Mesh::swapImage(EdgeImage& image)
{
    const bool live = isEdge(image.slot);
    std::swap(m_kernel.edge(edgeHandle(image.slot)), image.item);
    m_edgeSlots.setFree(image.slot, !image.live);
    image.live = live;
}

void Mesh::swapImage(FaceImage& image)
{
    std::swap(m_kernel.face(faceHandle(image.slot)), image.item);
    std::swap(m_corners[image.slot], image.corners);
    m_faceSlots.setFree(image.slot, m_corners[image.slot] == freeCorners);
}
} // namespace core
