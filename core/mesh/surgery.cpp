// Exchanges faces (see surgery.h):
//   1. the half-edges of removed faces become open
//   2. each side of an added face takes an open half-edge, the opposite of a side added before it, or a new edge
//   3. edges and vertices that are no longer used are removed

#include "core/mesh/surgery.h"

#include "core/mesh/mesh.h"
#include "core/mesh/unpaired_halfedges.h"

#include <algorithm>
#include <iterator>

namespace core
{
namespace
{
using Side = std::pair<Slot, Slot>; ///< a half-edge, by the vertices from and to

template <class Visit> void forEachSide(const Triangle& t, Visit visit)
{
    for (std::size_t i = 0; i < 3; ++i)
        visit(t[i], t[(i + 1) % 3]);
}

std::vector<Slot> sorted(std::vector<Slot> slots)
{
    std::ranges::sort(slots);
    return slots;
}

bool has(const std::vector<Slot>& sortedSlots, Slot slot)
{
    return std::ranges::binary_search(sortedSlots, slot);
}

/// Returns the vertices of all removed and added faces, ascending; new vertices are last.
std::vector<Slot> involved(const Mesh& mesh, const Surgery& surgery)
{
    std::vector<Slot> vertices;
    for (Slot f : surgery.removed)
        vertices.insert(vertices.end(), mesh.corners(f).begin(), mesh.corners(f).end());
    for (const Triangle& t : surgery.faces)
        vertices.insert(vertices.end(), t.begin(), t.end());
    std::ranges::sort(vertices);
    vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
    return vertices;
}

/// The sides of added faces, each by the corner opposite it.
class AddedSides
{
public:
    explicit AddedSides(const Surgery& surgery)
    {
        for (const Triangle& t : surgery.faces) {
            for (std::size_t i = 0; i < 3; ++i)
                m_sides.push_back({t[i], {t[(i + 1) % 3], t[(i + 2) % 3]}});
        }
        std::ranges::sort(m_sides);
    }
    auto opposite(Slot corner) const
    {
        return std::ranges::equal_range(m_sides, corner, {}, &std::pair<Slot, Side>::first);
    }

private:
    std::vector<std::pair<Slot, Side>> m_sides;
};

/// Returns the sides opposite v of the faces around v after the surgery; together they form the ring of v.
std::vector<Side> ringSides(const Mesh& mesh, const AddedSides& added, const std::vector<Slot>& gone, Slot v)
{
    std::vector<Side> sides;
    if (!Surgery::isNew(v)) {
        mesh.forEachOutgoing(v, [&](Slot h) {
            if (!has(gone, mesh.face(h)))
                sides.emplace_back(mesh.to(h), mesh.to(mesh.next(h)));
        });
    }
    for (const auto& [corner, side] : added.opposite(v))
        sides.push_back(side);
    std::ranges::sort(sides);
    return sides;
}

/// Returns the cycles of a ring, each starting with its lowest slot; empty if the sides do not form cycles.
std::vector<std::vector<Slot>> cycles(const std::vector<Side>& sides)
{
    std::vector<std::vector<Slot>> found;
    std::vector<char> used(sides.size());
    for (std::size_t first = 0; first < sides.size(); ++first) {
        if (used[first])
            continue;
        std::vector<Slot> cycle;
        std::size_t at = first;
        do {
            used[at] = 1;
            cycle.push_back(sides[at].first);
            const auto next = std::ranges::lower_bound(sides, sides[at].second, {}, &Side::first);
            if (next == sides.end() || next->first != sides[at].second)
                return {};
            at = static_cast<std::size_t>(next - sides.begin());
            if (at != first && used[at])
                return {};
        } while (at != first);
        found.push_back(std::move(cycle));
    }
    return found;
}

/// Returns whether, after the surgery, each half-edge occurs once and has its opposite.
bool sidesPair(const Mesh& mesh, const Surgery& surgery, const std::vector<Slot>& gone)
{
    std::vector<Side> sides;
    for (const Triangle& t : surgery.faces) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            return false;
        forEachSide(t, [&](Slot a, Slot b) { sides.emplace_back(a, b); });
    }
    std::ranges::sort(sides);
    if (std::ranges::adjacent_find(sides) != sides.end())
        return false;
    const auto comes = [&](Slot a, Slot b) { return std::ranges::binary_search(sides, Side(a, b)); };
    const auto stays = [&](Slot a, Slot b) {
        if (Surgery::isNew(a) || Surgery::isNew(b))
            return false;
        const Slot h = mesh.findHalfedge(a, b);
        return h != noSlot && !has(gone, mesh.face(h));
    };
    for (const auto& [a, b] : sides) {
        if (stays(a, b) || !(comes(b, a) || stays(b, a)))
            return false;
    }
    bool closed = true;
    for (Slot f : surgery.removed) {
        forEachSide(mesh.corners(f), [&](Slot a, Slot b) { closed = closed && (!stays(b, a) || comes(a, b)); });
    }
    return closed;
}
} // namespace

Surgery partOf(const Surgery& surgery, const Mesh& mesh, const std::function<bool(const Triangle&)>& isTaken)
{
    Surgery part;
    part.nearby = surgery.nearby;
    std::ranges::copy_if(surgery.removed, std::back_inserter(part.removed),
                         [&](Slot f) { return isTaken(mesh.corners(f)); });
    std::vector<Slot> renamed(surgery.vertices.size(), noSlot);
    for (Triangle face : surgery.faces) {
        if (!isTaken(face))
            continue;
        for (Slot& corner : face) {
            if (!Surgery::isNew(corner))
                continue;
            Slot& name = renamed[Surgery::newIndex(corner)];
            if (name == noSlot) {
                name = Surgery::newVertex(part.vertices.size());
                part.vertices.push_back(surgery.vertices[Surgery::newIndex(corner)]);
            }
            corner = name;
        }
        part.faces.push_back(face);
    }
    return part;
}

Surgery additionOf(const TriangleMesh& shell, Slot nearby)
{
    Surgery surgery;
    surgery.nearby = nearby;
    for (std::size_t i = 0; i < shell.points.size(); ++i)
        surgery.vertices.push_back({shell.points[i], shell.colors.empty() ? Rgb() : shell.colors[i], noSlot,
                                    shell.masks.empty() ? std::uint8_t(0) : shell.masks[i]});
    for (const Triangle& t : shell.triangles)
        surgery.faces.push_back({Surgery::newVertex(t[0]), Surgery::newVertex(t[1]), Surgery::newVertex(t[2])});
    return surgery;
}

bool isSurgeryOk(const Mesh& mesh, const Surgery& surgery)
{
    const std::vector<Slot> gone = sorted(surgery.removed);
    if (!sidesPair(mesh, surgery, gone))
        return false;
    const AddedSides added(surgery);
    return std::ranges::all_of(involved(mesh, surgery), [&](Slot v) {
        const std::vector<Side> sides = ringSides(mesh, added, gone, v);
        return sides.empty() || cycles(sides).size() == 1;
    });
}

void splitUmbrellas(const Mesh& mesh, Surgery& surgery, double apart)
{
    for (Slot v : involved(mesh, surgery)) {
        if (Surgery::isNew(v))
            continue;
        const std::vector<Slot> gone = sorted(surgery.removed);
        std::vector<std::vector<Slot>> rings = cycles(ringSides(mesh, AddedSides(surgery), gone, v));
        std::ranges::stable_sort(rings, [](const auto& a, const auto& b) { return a.size() > b.size(); });
        for (std::size_t i = 1; i < rings.size(); ++i) {
            const auto pointOf = [&](Slot w) -> Vec3 {
                const Vec3f p = Surgery::isNew(w) ? surgery.vertices[Surgery::newIndex(w)].point : mesh.point(w);
                return p.cast<double>();
            };
            Vec3 mean = Vec3::Zero();
            for (Slot w : rings[i])
                mean += pointOf(w);
            mean /= static_cast<double>(rings[i].size());
            const Slot copy = Surgery::newVertex(surgery.vertices.size());
            surgery.vertices.push_back(
                {mesh.lattice().snap(pointOf(v) + apart * (mean - pointOf(v))), mesh.color(v), v, mesh.mask(v)});

            // New faces of this cycle get the copy as corner. Faces of the mesh are removed and added again with the
            // copy.
            const std::vector<Slot> ring = sorted(rings[i]);
            for (Triangle& t : surgery.faces) {
                const auto corner = std::ranges::find(t, v);
                if (corner != t.end() && has(ring, t[static_cast<std::size_t>(corner - t.begin() + 1) % 3]))
                    *corner = copy;
            }
            mesh.forEachOutgoing(v, [&](Slot h) {
                if (has(gone, mesh.face(h)) || !has(ring, mesh.to(h)))
                    return;
                surgery.removed.push_back(mesh.face(h));
                surgery.faces.push_back({copy, mesh.to(h), mesh.to(mesh.next(h))});
            });
        }
    }
}

std::vector<Slot> Mesh::replaceFaces(const Surgery& surgery)
{
    struct Open
    {
        Side side;
        Slot halfedge;
        bool taken;
    };
    const Slot hintEdge = outgoing(surgery.nearby) / 2, hintFace = face(outgoing(surgery.nearby));
    std::vector<Open> open;
    std::vector<Slot> corners;
    for (Slot f : surgery.removed) {
        Slot h = faceHalfedge(f);
        for (int i = 0; i < 3; ++i, h = next(h)) {
            open.push_back({{from(h), to(h)}, h, false});
            corners.push_back(to(h));
        }
        freeFace(f);
    }
    std::ranges::sort(open, {}, &Open::side);
    std::vector<Slot> created;
    for (const Surgery::Vertex& v : surgery.vertices)
        created.push_back(newVertex(surgery.nearby, v.point, {v.color.r, v.color.g, v.color.b, v.mask}));

    UnpairedHalfedges waiting;
    const auto claim = [&](Slot from, Slot to) {
        const auto known = std::ranges::lower_bound(open, Side(from, to), {}, &Open::side);
        if (known != open.end() && known->side == Side(from, to)) {
            assert(!known->taken);
            known->taken = true;
            return known->halfedge;
        }
        if (const Slot h = waiting.take(from, to); h != noSlot)
            return h;
        const Slot h = 2 * newEdge(hintEdge);
        setTo(h, to);
        setTo(h ^ 1, from);
        waiting.add(to, from, h ^ 1);
        return h;
    };
    std::vector<Slot> kept;
    for (Triangle t : surgery.faces) {
        for (Slot& corner : t)
            corner = Surgery::isNew(corner) ? created[Surgery::newIndex(corner)] : corner;
        const Slot ab = claim(t[0], t[1]), bc = claim(t[1], t[2]), ca = claim(t[2], t[0]);
        link(newFace(hintFace), ab, bc, ca);
        setOutgoing(t[0], ab);
        setOutgoing(t[1], bc);
        setOutgoing(t[2], ca);
        kept.insert(kept.end(), t.begin(), t.end());
    }
    assert(waiting.empty() && "closed");

    for (const Open& o : open) {
        if (!o.taken && isEdge(o.halfedge / 2))
            freeEdge(o.halfedge / 2);
    }
    std::ranges::sort(kept);
    std::ranges::sort(corners);
    corners.erase(std::ranges::unique(corners).begin(), corners.end());
    for (Slot v : corners) {
        if (!has(kept, v))
            freeVertex(v);
    }
    return created;
}
} // namespace core
