#include "core/journal/delta_images.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace core
{
namespace
{
/// Returns an OpenMesh item made of these links, in the order of its members.
template <class Item, class... Links> Item itemOf(Links... links)
{
    const std::array<Slot, sizeof...(links)> values{links...};
    static_assert(sizeof(Item) == sizeof values);
    Item item;
    std::memcpy(static_cast<void*>(&item), values.data(), sizeof item);
    return item;
}

template <std::size_t count, class Item> std::array<Slot, count> linksOf(const Item& item)
{
    static_assert(sizeof(Item) == count * sizeof(Slot));
    std::array<Slot, count> links;
    std::memcpy(links.data(), &item, sizeof item);
    return links;
}

// Images of slots past the ends of the mesh's arrays are those of free slots.

VertexImage vertexImage(const Mesh& mesh, Slot v)
{
    if (v >= mesh.slots().vertices)
        return {v, 0, Vec3f::Zero(), {}, 0, false, 0, {}};
    return {v,
            0,
            mesh.point(v),
            mesh.color(v),
            mesh.mask(v),
            mesh.isVertex(v),
            static_cast<PartId>(mesh.part(v) | (mesh.isHidden(v) ? hiddenBit : 0)),
            itemOf<OpenMesh::ArrayItems::Vertex>(mesh.outgoing(v))};
}

EdgeImage edgeImage(const Mesh& mesh, Slot e)
{
    if (e >= mesh.slots().edges)
        return {e, 0, false, {}};
    const Slot a = 2 * e, b = a + 1;
    const auto item = itemOf<OpenMesh::ArrayItems::Edge>(mesh.face(a), mesh.to(a), mesh.next(a), mesh.prev(a), //
                                                         mesh.face(b), mesh.to(b), mesh.next(b), mesh.prev(b));
    return {e, 0, mesh.isEdge(e), item};
}

FaceImage faceImage(const Mesh& mesh, Slot f)
{
    if (f >= mesh.slots().faces)
        return {f, 0, {0, 0, 0}, {}};
    return {f, 0, mesh.corners(f), itemOf<OpenMesh::ArrayItems::Face>(mesh.faceHalfedge(f))};
}

bool isInside(const VertexImage& image, const SlotCounts& counts)
{
    return image.slot < counts.vertices && linksOf<1>(image.item)[0] < 2 * counts.edges;
}

bool isInside(const EdgeImage& image, const SlotCounts& counts)
{
    const auto links = linksOf<8>(image.item); // same order as in edgeImage()
    for (std::size_t i = 0; i < links.size(); i += 4)
        if (links[i] >= counts.faces || links[i + 1] >= counts.vertices || links[i + 2] >= 2 * counts.edges ||
            links[i + 3] >= 2 * counts.edges)
            return false;
    return image.slot < counts.edges;
}

bool isInside(const FaceImage& image, const SlotCounts& counts)
{
    const bool hasCorners = std::ranges::all_of(image.corners, [&](Slot v) { return v < counts.vertices; });
    return image.slot < counts.faces && hasCorners && linksOf<1>(image.item)[0] < 2 * counts.edges;
}

bool isLive(const FaceImage& image)
{
    return image.live();
}

template <class Image> bool isLive(const Image& image)
{
    return image.live;
}

MeshDelta emptyImage(const Mesh& mesh)
{
    return {{}, {}, {}, mesh.slots(), mesh.meshHash(), mesh.frame()};
}
} // namespace

MeshDelta imageOf(const Mesh& mesh, const MeshDelta& delta)
{
    MeshDelta image = emptyImage(mesh);
    image.vertices.reserve(delta.vertices.size());
    image.edges.reserve(delta.edges.size());
    image.faces.reserve(delta.faces.size());
    for (const VertexImage& vertex : delta.vertices)
        image.vertices.push_back(vertexImage(mesh, vertex.slot));
    for (const EdgeImage& edge : delta.edges)
        image.edges.push_back(edgeImage(mesh, edge.slot));
    for (const FaceImage& face : delta.faces)
        image.faces.push_back(faceImage(mesh, face.slot));
    return image;
}

MeshDelta imageOf(const Mesh& mesh, Slot first, Slot end)
{
    MeshDelta image = emptyImage(mesh);
    for (Slot v = first; v < std::min(end, image.counts.vertices); ++v)
        image.vertices.push_back(vertexImage(mesh, v));
    for (Slot e = first; e < std::min(end, image.counts.edges); ++e)
        image.edges.push_back(edgeImage(mesh, e));
    for (Slot f = first; f < std::min(end, image.counts.faces); ++f)
        image.faces.push_back(faceImage(mesh, f));
    return image;
}

bool canSwap(const Mesh& mesh, const MeshDelta& delta)
{
    const SlotCounts here = mesh.slots(), &there = delta.counts;
    const auto fits = [&](const auto& images, Slot end) {
        return std::ranges::all_of(
            images, [&](const auto& image) { return isLive(image) ? isInside(image, there) : image.slot < end; });
    };
    return fits(delta.vertices, std::max(here.vertices, there.vertices)) &&
           fits(delta.edges, std::max(here.edges, there.edges)) && fits(delta.faces, std::max(here.faces, there.faces));
}
} // namespace core
