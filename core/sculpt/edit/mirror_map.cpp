#include "core/sculpt/edit/mirror_map.h"

#include "core/mesh/surface_query.h"

#include <algorithm>

namespace core
{
Dab MirrorMap::imageOf(Dab dab) const
{
    dab.position = imageOf(dab.position);
    dab.direction = imageOf(dab.direction);
    dab.motion = imageOf(dab.motion);
    dab.heading = imageOf(dab.heading);
    dab.turn = -dab.turn;
    dab.up = imageOf(dab.up);
    dab.ahead = imageOf(dab.ahead);
    dab.isMirrored = !dab.isMirrored;
    return dab;
}

void MirrorMap::setPlane(Symmetry plane)
{
    m_axis = static_cast<int>(plane) - static_cast<int>(Symmetry::X);
    m_vertices.clear();
    m_images.clear();
    m_faces.clear();
}

bool MirrorMap::isAcross(Slot e) const
{
    const Vec3f& p = m_mesh.point(m_mesh.to(2 * e));
    return p[m_axis] != 0 && imageOf(p) == m_mesh.point(m_mesh.to(2 * e + 1));
}

bool MirrorMap::isInHalf(const Triangle& corners) const
{
    return isInHalf(corners[0]) && isInHalf(corners[1]) && isInHalf(corners[2]);
}

void MirrorMap::pair(Slot v, Slot image)
{
    const Slot i = m_vertices.add(v);
    m_images.resize(m_vertices.size());
    m_images[i] = image;
    const Slot j = m_vertices.add(image);
    m_images.resize(m_vertices.size());
    m_images[j] = v;
}

/// Returns the cached image of v, without searching; noSlot if there is none or it is out of date.
Slot MirrorMap::known(Slot v) const
{
    if (isOnPlane(v))
        return v;
    if (!m_vertices.contains(v))
        return noSlot;
    const Slot image = m_images[m_vertices.position(v)];
    const bool valid =
        image < m_mesh.slots().vertices && m_mesh.isVertex(image) && m_mesh.point(image) == imageOf(m_mesh.point(v));
    return valid ? image : noSlot;
}

Slot MirrorMap::imageOf(Slot v)
{
    Slot image = known(v);
    if (image == noSlot) {
        image = nextToNeighbour(v);
        if (image != noSlot)
            pair(v, image);
    }
    return image;
}

/// Searches for the image of v among the neighbours of its neighbours' cached images.
Slot MirrorMap::nextToNeighbour(Slot v) const
{
    const Vec3f p = imageOf(m_mesh.point(v));
    Slot found = noSlot;
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        const Slot neighbour = found == noSlot ? known(m_mesh.to(h)) : noSlot;
        if (neighbour == noSlot)
            return;
        m_mesh.forEachOutgoing(neighbour, [&](Slot g) {
            if (m_mesh.point(m_mesh.to(g)) == p)
                found = m_mesh.to(g);
        });
    });
    return found;
}

bool MirrorMap::lookUp(Slot v, const FaceOctree& octree)
{
    const Slot found = vertexAt(m_mesh, octree, imageOf(m_mesh.point(v)));
    if (found != noSlot)
        pair(v, found);
    return found != noSlot;
}

Slot MirrorMap::imageOfHalfedge(Slot h)
{
    const Slot from = imageOf(m_mesh.from(h)), to = imageOf(m_mesh.to(h));
    return from == noSlot || to == noSlot ? noSlot : m_mesh.findHalfedge(from, to);
}

/// The image lists its corners in the opposite order, because mirroring reverses orientation.
Slot MirrorMap::imageOfFace(Slot f)
{
    const Triangle& t = m_mesh.corners(f);
    const Slot h = m_mesh.findHalfedge(imageOf(t[1]), imageOf(t[0]));
    return h != noSlot && m_mesh.to(m_mesh.next(h)) == imageOf(t[2]) ? m_mesh.face(h) : noSlot;
}

/// Traverses the faces from neighbour to neighbour. Then only the first face of a connected part needs the octree; all
/// other images are found next to a neighbour's image.
bool MirrorMap::learn(std::span<const Slot> faces, const FaceOctree& octree)
{
    m_wanted.clear();
    m_faces.clear();
    for (Slot f : faces)
        m_wanted.add(f);
    std::vector<Slot> front;
    for (Slot first : faces) {
        front.push_back(first);
        while (!front.empty()) {
            const Slot f = front.back();
            front.pop_back();
            if (m_faces.contains(f))
                continue;
            if (!learnFace(f, octree))
                return false;
            Slot h = m_mesh.faceHalfedge(f);
            for (int i = 0; i < 3; ++i, h = m_mesh.next(h)) {
                if (m_wanted.contains(m_mesh.face(h ^ 1)))
                    front.push_back(m_mesh.face(h ^ 1));
            }
        }
    }
    return true;
}

bool MirrorMap::learnFace(Slot f, const FaceOctree& octree)
{
    for (Slot v : m_mesh.corners(f)) {
        if (imageOf(v) == noSlot && !lookUp(v, octree))
            return false;
        if (m_mesh.mask(v) != m_mesh.mask(imageOf(v)) || m_mesh.isHidden(v) != m_mesh.isHidden(imageOf(v)))
            return false;
    }
    const Slot image = imageOfFace(f);
    if (image == noSlot)
        return false;
    m_faces.add(f);
    m_faces.add(image);
    return true;
}

Vec3f MirrorMap::kept(Vec3f p, bool onPlane) const
{
    const float min = onPlane ? 0 : static_cast<float>(m_mesh.lattice().unit());
    p[m_axis] = onPlane ? 0 : std::max(p[m_axis], min);
    return p;
}
} // namespace core
