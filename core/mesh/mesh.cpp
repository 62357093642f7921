#include "core/mesh/mesh.h"

#include "core/mesh/mesh_hash.h"
#include "core/mesh/unpaired_halfedges.h"

#include <algorithm>
#include <bit>

namespace core
{
namespace
{
constexpr Slot minReserve = 1u << 18;
} // namespace

// --- building

Mesh::Mesh(const TriangleMesh& mesh, Lattice lattice) : m_frame{lattice}
{
    m_kernel.request_vertex_colors();
    const Slot vertices = static_cast<Slot>(mesh.points.size());
    const Slot faces = static_cast<Slot>(mesh.triangles.size());
    const SlotCounts counts{vertices, faces / 2 * 3, faces};
    // Reserves address space for growth, which costs no memory, so that nothing is reallocated in a stroke.
    reserve({std::max(minReserve, 4 * counts.vertices), std::max(3 * minReserve, 4 * counts.edges),
             std::max(2 * minReserve, 4 * counts.faces)});
    resize(counts);
    for (Slot v = 0; v < vertices; ++v) {
        m_vertexSlots.setFree(v, false);
        m_kernel.set_point(vertexHandle(v), mesh.points[v]);
        const Rgb c = mesh.colors.empty() ? Rgb() : mesh.colors[v];
        m_kernel.set_color(vertexHandle(v), {c.r, c.g, c.b, mesh.masks.empty() ? std::uint8_t(0) : mesh.masks[v]});
    }
    std::ranges::copy(mesh.parts, m_parts.begin());

    // Half-edges are paired in the order of the faces, so that edges follow the same Morton curve as the faces.
    UnpairedHalfedges open;
    open.reserve(counts.edges / 4);
    Slot edges = 0;
    const auto claim = [&](Slot from, Slot to) {
        if (const Slot waiting = open.take(from, to); waiting != noSlot)
            return waiting;
        assert(edges < counts.edges && "closed and manifold");
        const Slot h = 2 * edges++;
        m_edgeSlots.setFree(h / 2, false);
        m_kernel.set_vertex_handle(halfedge(h), vertexHandle(to));
        m_kernel.set_vertex_handle(halfedge(h ^ 1), vertexHandle(from));
        open.add(to, from, h ^ 1);
        return h;
    };
    for (Slot f = 0; f < faces; ++f) {
        const Triangle& t = mesh.triangles[f];
        std::array<Slot, 3> h{};
        for (int i = 0; i < 3; ++i) {
            h[i] = claim(t[i], t[(i + 1) % 3]);
            m_kernel.set_face_handle(halfedge(h[i]), faceHandle(f));
            m_kernel.set_halfedge_handle(vertexHandle(t[i]), halfedge(h[i]));
        }
        for (int i = 0; i < 3; ++i)
            m_kernel.set_next_halfedge_handle(halfedge(h[i]), halfedge(h[(i + 1) % 3]));
        m_kernel.set_halfedge_handle(faceHandle(f), halfedge(h[0]));
        m_corners[f] = t;
        m_faceSlots.setFree(f, false);
    }
    assert(open.empty() && edges == counts.edges);
    m_frame.uniformDetail = detailPerMeanEdge * meanEdge();
    m_meshHash = wholeHash(*this);
}

double Mesh::meanEdge() const
{
    double sum = 0;
    for (const Slot e : edges())
        sum += (point(to(2 * e)) - point(to(2 * e + 1))).cast<double>().norm();
    return sum / live().edges;
}

void Mesh::reserve(const SlotCounts& counts)
{
    m_kernel.reserve(counts.vertices, counts.edges, counts.faces);
    m_corners.reserve(counts.faces);
    m_parts.reserve(counts.vertices);
    m_vertexSlots.reserve(counts.vertices);
    m_edgeSlots.reserve(counts.edges);
    m_faceSlots.reserve(counts.faces);
    m_vertexStamp.reserve(counts.vertices);
    m_edgeStamp.reserve(counts.edges);
    m_faceStamp.reserve(counts.faces);
}

void Mesh::resize(const SlotCounts& counts)
{
    m_kernel.resize(counts.vertices, counts.edges, counts.faces);
    m_corners.resize(counts.faces, freeCorners);
    m_parts.resize(counts.vertices);
    m_vertexSlots.resize(counts.vertices);
    m_edgeSlots.resize(counts.edges);
    m_faceSlots.resize(counts.faces);
    m_vertexStamp.resize(counts.vertices);
    m_edgeStamp.resize(counts.edges);
    m_faceStamp.resize(counts.faces);
}

// --- queries

Rgb Mesh::color(Slot v) const
{
    const OpenMesh::Vec4uc& c = m_kernel.vertex_colors()[v];
    return {c[0], c[1], c[2]};
}

Slot Mesh::findHalfedge(Slot v0, Slot v1) const
{
    Slot found = noSlot;
    forEachOutgoing(v0, [&](Slot h) {
        if (to(h) == v1)
            found = h;
    });
    return found;
}

unsigned Mesh::valence(Slot v) const
{
    unsigned n = 0;
    forEachOutgoing(v, [&](Slot) { ++n; });
    return n;
}

std::uint64_t Mesh::stateHash() const
{
    std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a over 32-bit words
    const auto add = [&](std::uint32_t word) { hash = (hash ^ word) * 0x100000001b3u; };
    for (Slot n : {m_vertexSlots.size(), m_edgeSlots.size(), m_faceSlots.size()})
        add(n);
    for (Slot v = 0; v < m_vertexSlots.size(); ++v)
        add(isVertex(v) ? outgoing(v) : noSlot), add(isVertex(v) ? mask(v) | (std::uint32_t(m_parts[v]) << 8) : 0);
    for (Slot e = 0; e < m_edgeSlots.size(); ++e) {
        for (Slot h : {2 * e, 2 * e + 1}) {
            add(isEdge(e) ? to(h) : noSlot);
            add(isEdge(e) ? next(h) : noSlot);
            add(isEdge(e) ? face(h) : noSlot);
        }
    }
    for (Slot f = 0; f < m_faceSlots.size(); ++f) {
        add(isFace(f) ? faceHalfedge(f) : noSlot);
        for (Slot corner : m_corners[f])
            add(corner);
    }
    add(static_cast<std::uint32_t>(m_frame.lattice.exponent()));
    for (const double x : {m_frame.uniformDetail, m_frame.place.x(), m_frame.place.y(), m_frame.place.z()}) {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        add(static_cast<std::uint32_t>(bits));
        add(static_cast<std::uint32_t>(bits >> 32));
    }
    return hash ^ m_meshHash;
}

// --- the write interface: each function below journals an element before it changes it

void Mesh::setPoint(Slot v, const Vec3f& p)
{
    assert(m_frame.lattice.isOnLattice(p));
    touchVertex(v);
    m_kernel.set_point(vertexHandle(v), p);
}

void Mesh::setColor(Slot v, Rgb c)
{
    touchVertex(v);
    m_kernel.set_color(vertexHandle(v), {c.r, c.g, c.b, mask(v)});
}

void Mesh::setMask(Slot v, std::uint8_t mask)
{
    touchVertex(v);
    const Rgb c = color(v);
    m_kernel.set_color(vertexHandle(v), {c.r, c.g, c.b, mask});
}

void Mesh::setPart(Slot v, PartId part)
{
    touchVertex(v);
    m_parts[v] = static_cast<PartId>(part | (m_parts[v] & hiddenBit));
}

void Mesh::setHidden(Slot v, bool isHidden)
{
    touchVertex(v);
    m_parts[v] = static_cast<PartId>(part(v) | (isHidden ? hiddenBit : 0));
}

void Mesh::setOutgoing(Slot v, Slot h)
{
    touchVertex(v);
    m_kernel.set_halfedge_handle(vertexHandle(v), halfedge(h));
}

void Mesh::setTo(Slot h, Slot v)
{
    touchEdge(h / 2);
    m_kernel.set_vertex_handle(halfedge(h), vertexHandle(v));
}

void Mesh::setFace(Slot h, Slot f)
{
    touchEdge(h / 2);
    m_kernel.set_face_handle(halfedge(h), faceHandle(f));
}

void Mesh::link(Slot f, Slot h0, Slot h1, Slot h2)
{
    touchFace(f);
    const std::array<Slot, 3> loop = {h0, h1, h2};
    for (int i = 0; i < 3; ++i) {
        setFace(loop[i], f);
        touchEdge(loop[(i + 1) % 3] / 2);
        m_kernel.set_next_halfedge_handle(halfedge(loop[i]), halfedge(loop[(i + 1) % 3]));
    }
    m_kernel.set_halfedge_handle(faceHandle(f), halfedge(h0));
    m_corners[f] = {to(h2), to(h0), to(h1)};
}

void Mesh::relabelCorner(Slot f, Slot from, Slot to)
{
    touchFace(f);
    std::ranges::replace(m_corners[f], from, to);
}

Slot Mesh::newVertex(Slot hint, const Vec3f& p, const OpenMesh::Vec4uc& colorAndMask)
{
    const Slot v = m_vertexSlots.take(hint);
    if (v == m_vertexStamp.size()) {
        m_kernel.new_vertex(Vec3f::Zero());
        m_kernel.set_color(OpenMesh::VertexHandle(static_cast<int>(v)), {0, 0, 0, 0});
        m_vertexStamp.push_back(0);
        m_parts.push_back(0);
    }
    m_vertexSlots.setFree(v, true);
    touchVertex(v); // journalled as a free slot
    m_vertexSlots.setFree(v, false);
    m_kernel.set_point(vertexHandle(v), p);
    m_kernel.set_color(vertexHandle(v), colorAndMask);
    m_parts[v] = part(hint);
    return v;
}

Slot Mesh::newEdge(Slot hint)
{
    const Slot e = m_edgeSlots.take(hint);
    if (e == m_edgeStamp.size()) {
        m_kernel.new_edge(vertexHandle(0), vertexHandle(0));
        m_edgeStamp.push_back(0);
    }
    m_edgeSlots.setFree(e, true);
    touchEdge(e);
    m_edgeSlots.setFree(e, false);
    return e;
}

Slot Mesh::newFace(Slot hint)
{
    const Slot f = m_faceSlots.take(hint);
    if (f == m_faceStamp.size()) {
        m_kernel.new_face();
        m_faceStamp.push_back(0);
        m_corners.push_back(freeCorners);
    }
    touchFace(f);
    return f;
}

void Mesh::freeVertex(Slot v)
{
    touchVertex(v);
    m_vertexSlots.setFree(v, true);
    m_removed.push_back(v);
}

void Mesh::freeEdge(Slot e)
{
    touchEdge(e);
    m_edgeSlots.setFree(e, true);
}

void Mesh::freeFace(Slot f)
{
    touchFace(f);
    m_corners[f] = freeCorners;
    m_faceSlots.setFree(f, true);
}

// --- split, collapse, flip

namespace
{
/// Returns the mean colour and mask of two vertices, weighted by how near each is to p (paper, section 3.5.3).
OpenMesh::Vec4uc colorAndMaskBetween(const Mesh& mesh, Slot v0, Slot v1, const Vec3f& p)
{
    const double to0 = (p - mesh.point(v0)).norm(), to1 = (p - mesh.point(v1)).norm();
    const double share = to0 + to1 > 0 ? to0 / (to0 + to1) : 0.5;
    const Rgb color = mixed(mesh.color(v0), mesh.color(v1), share);
    const double mask = mesh.mask(v0) + share * (mesh.mask(v1) - mesh.mask(v0));
    return {color.r, color.g, color.b, static_cast<std::uint8_t>(mask + 0.5)};
}
} // namespace

Slot Mesh::splitEdge(Slot e, const Vec3f& p)
{
    //        c                c
    //      /   \            / | \        .
    //     a --- b   ->     a- m -b       e becomes a-m
    //      \   /            \ | /
    //        d                d
    const Slot ab = 2 * e, ba = ab ^ 1;
    const Slot bc = next(ab), ca = prev(ab), ad = next(ba), db = prev(ba);
    const Slot a = to(ba), b = to(ab), c = to(bc), d = to(ad);
    const Slot f0 = face(ab), f1 = face(ba);

    const Rgb ca_ = color(a), cb_ = color(b);
    const auto mean = [](int x, int y) { return static_cast<std::uint8_t>((x + y + 1) / 2); };
    const Slot m =
        newVertex(a, p, {mean(ca_.r, cb_.r), mean(ca_.g, cb_.g), mean(ca_.b, cb_.b), mean(mask(a), mask(b))});
    const Slot mb = 2 * newEdge(e), mc = 2 * newEdge(e), md = 2 * newEdge(e);
    const Slot f2 = newFace(f0), f3 = newFace(f1);
    setTo(mb, b), setTo(mb ^ 1, m);
    setTo(mc, c), setTo(mc ^ 1, m);
    setTo(md, d), setTo(md ^ 1, m);
    setTo(ab, m);
    link(f0, ab, mc, ca);
    link(f2, mb, bc, mc ^ 1);
    link(f1, ba, ad, md ^ 1);
    link(f3, mb ^ 1, md, db);
    setOutgoing(m, mb);
    if (outgoing(b) == ba)
        setOutgoing(b, mb ^ 1);
    return m;
}

bool Mesh::isCollapseOk(Slot h) const
{
    const Slot v0 = from(h), v1 = to(h), left = to(next(h)), right = to(next(h ^ 1));
    if (left == right)
        return false;
    unsigned common = 0;
    unsigned valence0 = 0;
    forEachOutgoing(v0, [&](Slot g) {
        ++valence0;
        if (to(g) != v1 && findHalfedge(v1, to(g)) != noSlot)
            ++common;
    });
    return common == 2 && valence0 + valence(v1) > 6 && valence(left) > 3 && valence(right) > 3;
}

void Mesh::collapse(Slot h, const Vec3f& p)
{
    assert(isCollapseOk(h));
    const Slot o = h ^ 1;
    const Slot v0 = to(o), v1 = to(h);
    const Slot left1 = next(h), left0 = prev(h);   // v1 -> left, left -> v0
    const Slot right0 = next(o), right1 = prev(o); // v0 -> right, right -> v1
    const Slot left = to(left1), right = to(right0);
    // v0 -> left, right -> v0: half-edges of the faces that remain
    const Slot outerLeft = left0 ^ 1, outerRight = right0 ^ 1;
    const Slot fl = face(h), fr = face(o), leftFace = face(outerLeft), rightFace = face(outerRight);

    forEachOutgoing(v0, [&](Slot g) {
        if (face(g) != fl && face(g) != fr)
            relabelCorner(face(g), v0, v1);
        setTo(g ^ 1, v1);
    });
    link(leftFace, left1, next(outerLeft), prev(outerLeft));
    link(rightFace, right1, next(outerRight), prev(outerRight));
    setOutgoing(v1, left1);
    if (outgoing(left) == left0)
        setOutgoing(left, left1 ^ 1);
    if (outgoing(right) == outerRight)
        setOutgoing(right, right1);
    freeFace(fl);
    freeFace(fr);
    freeEdge(h / 2);
    freeEdge(left0 / 2);
    freeEdge(right0 / 2);
    const OpenMesh::Vec4uc mean = colorAndMaskBetween(*this, v0, v1, p);
    freeVertex(v0);
    setPoint(v1, p);
    m_kernel.set_color(vertexHandle(v1), mean);
}

bool Mesh::isFlipOk(Slot e) const
{
    const Slot h = 2 * e;
    const Slot c = to(next(h)), d = to(next(h ^ 1));
    return c != d && valence(to(h)) > 3 && valence(from(h)) > 3 && findHalfedge(c, d) == noSlot;
}

void Mesh::flip(Slot e)
{
    assert(isFlipOk(e));
    const Slot ab = 2 * e, ba = ab ^ 1;
    const Slot bc = next(ab), ca = prev(ab), ad = next(ba), db = prev(ba);
    const Slot a = to(ba), b = to(ab), c = to(bc), d = to(ad);
    const Slot f0 = face(ab), f1 = face(ba);
    setTo(ab, c); // ab becomes d -> c
    setTo(ba, d); // ba becomes c -> d
    link(f0, ca, ad, ab);
    link(f1, db, bc, ba);
    if (outgoing(a) == ab)
        setOutgoing(a, ad);
    if (outgoing(b) == ba)
        setOutgoing(b, bc);
}
} // namespace core
