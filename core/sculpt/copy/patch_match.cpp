#include "core/sculpt/copy/patch_match.h"

#include "core/geometry/lattice_box.h"

#include <algorithm>

namespace core
{
Slot vertexAt(const VerifiedMesh& surface, const Vec3f& p)
{
    const Mesh& mesh = surface.mesh();
    const LatticePoint at = mesh.lattice().toLattice(p);
    Slot found = noSlot;
    surface.octree().query({at, at}, [&](Slot f) {
        for (Slot corner : mesh.corners(f)) {
            if (mesh.point(corner) == p)
                found = corner;
        }
    });
    return found;
}

namespace
{
bool isImage(const Mesh& mesh, const ChangedPatch& patch, const Turn& turn, Slot image, Slot v)
{
    const ChangedPatch::VertexState state = patch.before(mesh, v);
    return mesh.point(image) == turn * state.point && mesh.color(image) == state.color &&
           mesh.mask(image) == state.mask;
}
} // namespace

bool PatchMatch::find(const VerifiedMesh& surface, const ChangedPatch& patch, const Turn& turn)
{
    const Search search = {surface.mesh(), patch, turn};
    m_images.assign(patch.vertices().size(), noSlot);
    m_seen.assign(patch.faces().size(), 0);
    m_matched.clear();
    for (std::size_t first = 0; first < patch.faces().size(); ++first) {
        if (m_seen[first])
            continue;
        for (Slot v : patch.faces()[first]) {
            if (!matchVertex(surface, search, v))
                return false;
        }
        if (!matchFrom(search, first))
            return false;
    }
    return isAllMatched(surface, search);
}

/// Matches a vertex of a component's first face, by its place.
bool PatchMatch::matchVertex(const VerifiedMesh& surface, const Search& search, Slot v)
{
    Slot& found = image(search, v);
    if (found == noSlot)
        found = vertexAt(surface, search.turn * search.patch.before(search.mesh, v).point);
    return found != noSlot && isImage(search.mesh, search.patch, search.turn, found, v);
}

/// Matches from a face to its neighbours.
bool PatchMatch::matchFrom(const Search& search, std::size_t face)
{
    const Mesh& mesh = search.mesh;
    std::vector<std::size_t> front = {face};
    while (!front.empty()) {
        const Triangle t = search.patch.faces()[front.back()];
        const bool isSeen = m_seen[front.back()];
        m_seen[front.back()] = 1;
        front.pop_back();
        if (isSeen)
            continue;
        const Slot h = mesh.findHalfedge(image(search, t[0]), image(search, t[1]));
        if (h == noSlot || mesh.to(mesh.next(h)) != image(search, t[2]) || !matchAcross(search, t, front))
            return false;
        m_matched.add(mesh.face(h));
    }
    return true;
}

/// Matches the corners beyond the face's sides, and appends those faces to the front.
bool PatchMatch::matchAcross(const Search& search, const Triangle& corners, std::vector<std::size_t>& front)
{
    const Mesh& mesh = search.mesh;
    const std::vector<Triangle>& faces = search.patch.faces();
    for (std::size_t k = 0; k < 3; ++k) {
        const Slot a = corners[(k + 1) % 3], b = corners[k];
        const std::size_t face = search.patch.faceAt(a, b);
        if (face == faces.size() || m_seen[face])
            continue;
        const Triangle& t = faces[face];
        const Slot beyond = t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
        if (image(search, beyond) == noSlot) {
            const Slot h = mesh.findHalfedge(image(search, a), image(search, b));
            if (h == noSlot || !isImage(mesh, search.patch, search.turn, mesh.to(mesh.next(h)), beyond))
                return false;
            image(search, beyond) = mesh.to(mesh.next(h));
        }
        front.push_back(face);
    }
    return true;
}

/// Whether each face in the turned balls is the image of a face of the patch.
bool PatchMatch::isAllMatched(const VerifiedMesh& surface, const Search& search) const
{
    return std::ranges::all_of(search.patch.balls(), [&](const Sphere& ball) {
        const LatticeBox box = latticeBox(search.mesh.lattice(), {search.turn * ball.center, ball.radius});
        return std::ranges::all_of(facesIn(search.mesh, surface.octree(), box),
                                   [&](Slot f) { return m_matched.contains(f); });
    });
}
} // namespace core
