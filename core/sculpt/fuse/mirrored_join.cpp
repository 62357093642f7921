#include "core/sculpt/fuse/mirrored_join.h"

#include "core/sculpt/fuse/ring_strip.h"

#include <algorithm>

namespace core
{
namespace
{
/// Returns the part of a vertex's ring on the mirror's positive side, counter-clockwise, from plane to plane. Appends
/// the faces there to `faces`.
Ring halfRing(const Mesh& mesh, const MirrorMap& mirror, Slot v, std::vector<Slot>& faces)
{
    Slot first = noSlot;
    mesh.forEachOutgoing(v, [&](Slot h) {
        if (mirror.isOnPlane(mesh.to(h)) && mirror.isInHalf(mesh.to(mesh.rotate(h))) &&
            !mirror.isOnPlane(mesh.to(mesh.rotate(h))))
            first = h;
    });
    Ring ring;
    if (first == noSlot)
        return ring;
    ring.push_back(mesh.to(first));
    Slot h = first;
    do {
        faces.push_back(mesh.face(h));
        h = mesh.rotate(h);
        ring.push_back(mesh.to(h));
    } while (h != first && !mirror.isOnPlane(mesh.to(h)));
    return ring;
}

/// Adds a new vertex at the projection of v onto the plane. Returns it.
Slot projected(const Mesh& mesh, const MirrorMap& mirror, Slot v, Surgery& surgery)
{
    surgery.vertices.push_back({mirror.kept(mesh.point(v), true), mesh.color(v), v, mesh.mask(v)});
    return Surgery::newVertex(surgery.vertices.size() - 1);
}

/// Connects a ring that has no vertex on the plane to its projection onto the plane.
void stripToPlane(const Mesh& mesh, const MirrorMap& mirror, Ring ring, Surgery& surgery)
{
    Ring onPlane;
    for (Slot r : ring)
        onPlane.push_back(projected(mesh, mirror, r, surgery));
    ring.push_back(ring.front());
    onPlane.push_back(onPlane.front());
    RingStrip(ring, onPlane, surgery.faces).open();
}

/// Connects an arc that starts and ends on the plane to its projection. The vertices next to the arc's ends are not
/// projected, because their projections might coincide with the ends.
void stripArcToPlane(const Mesh& mesh, const MirrorMap& mirror, const Ring& arc, Surgery& surgery)
{
    if (arc.size() == 2)
        return; // a single edge on the plane, where the removed stars leave no gap
    Ring onPlane = {arc.front()};
    for (std::size_t i = 2; i + 2 < arc.size(); ++i)
        onPlane.push_back(projected(mesh, mirror, arc[i], surgery));
    onPlane.push_back(arc.back());
    RingStrip(arc, onPlane, surgery.faces).betweenCommonEnds();
}
} // namespace

std::optional<Surgery> joinAcross(const Mesh& mesh, const MirrorMap& mirror, Slot v)
{
    Surgery surgery;
    surgery.nearby = v;
    Ring ring;
    std::vector<std::size_t> onPlane;
    mesh.forEachOutgoing(v, [&](Slot h) {
        if (mirror.isOnPlane(mesh.to(h)))
            onPlane.push_back(ring.size());
        ring.push_back(mesh.to(h));
        surgery.removed.push_back(mesh.face(h));
    });
    if (onPlane.empty())
        stripToPlane(mesh, mirror, ring, surgery);
    for (std::size_t i = 0; i < onPlane.size(); ++i)
        stripArcToPlane(mesh, mirror, arc(ring, onPlane[i], onPlane[(i + 1) % onPlane.size()]), surgery);
    if (surgery.faces.empty())
        return std::nullopt;
    return surgery;
}

std::optional<Surgery> joinOnPlane(const Mesh& mesh, const MirrorMap& mirror, Slot p, Slot q)
{
    Surgery surgery;
    surgery.nearby = p;
    const Ring a = halfRing(mesh, mirror, p, surgery.removed);
    Ring b = halfRing(mesh, mirror, q, surgery.removed);
    std::ranges::reverse(b); // the two half rings then run in the same direction
    const auto common = [&](Slot v) { return v == p || v == q || std::ranges::find(b, v) != b.end(); };
    if (a.size() < 2 || b.size() < 2 || std::ranges::any_of(a, common))
        return std::nullopt;
    RingStrip(a, b, surgery.faces).open();
    return surgery;
}

std::optional<Surgery> withImage(const Mesh& mesh, MirrorMap& mirror, const Surgery& half)
{
    Surgery both = half;
    for (Slot f : half.removed) {
        if (!half.faces.empty() && !mirror.isInHalf(mesh.corners(f)))
            return std::nullopt; // a face that crosses the plane would be replaced twice
        both.removed.push_back(mirror.imageOfFace(f));
        if (both.removed.back() == noSlot)
            return std::nullopt;
    }
    std::ranges::sort(both.removed);
    both.removed.erase(std::ranges::unique(both.removed).begin(), both.removed.end());
    std::vector<Slot> images;
    for (std::size_t i = 0; i < half.vertices.size(); ++i) {
        const Surgery::Vertex& v = half.vertices[i];
        const float height = mirror.height(v.point);
        if (height < 0 || (height > 0 && v.original != noSlot && mirror.isOnPlane(v.original)))
            return std::nullopt;
        images.push_back(Surgery::newVertex(height == 0 ? i : both.vertices.size()));
        if (height > 0)
            both.vertices.push_back(
                {mirror.imageOf(v.point), v.color, v.original == noSlot ? noSlot : mirror.imageOf(v.original), v.mask});
    }
    const auto imageOf = [&](Slot v) { return Surgery::isNew(v) ? images[Surgery::newIndex(v)] : mirror.imageOf(v); };
    for (const Triangle& t : half.faces) {
        const Triangle image = {imageOf(t[0]), imageOf(t[2]), imageOf(t[1])};
        if (std::ranges::find(image, noSlot) != image.end())
            return std::nullopt;
        both.faces.push_back(image);
    }
    return isSurgeryOk(mesh, both) ? std::optional(std::move(both)) : std::nullopt;
}
} // namespace core
