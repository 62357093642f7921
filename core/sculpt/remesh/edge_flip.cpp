#include "core/sculpt/remesh/edge_flip.h"

#include <algorithm>

namespace core
{
namespace
{
/// An edge may be flipped only if the angle between its two faces has at least this cosine: angles up to about 25
/// degrees, or 6 where detail is to be kept. A flip is meant to change the triangulation and not the shape.
constexpr double flatCosine = 0.9, flatDetailCosine = 0.995;
constexpr int flipPasses = 4;
} // namespace

/// Returns whether the edge violates Delaunay's criterion, cot(alpha) + cot(beta) < 0, and may be flipped: its faces
/// are nearly coplanar before and after.
bool EdgeFlip::shouldFlip(Slot e) const
{
    const Slot h = 2 * e;
    const auto point = [&mesh = m_mesh](Slot v) -> Vec3 { return mesh.point(v).cast<double>(); };
    const Slot va = m_mesh.from(h), vb = m_mesh.to(h);
    const Slot vc = m_mesh.to(m_mesh.next(h)), vd = m_mesh.to(m_mesh.next(h ^ 1));
    const Vec3 a = point(va), b = point(vb), c = point(vc), d = point(vd);
    const double dot0 = (a - c).dot(b - c), dot1 = (a - d).dot(b - d);
    if (dot0 >= 0 && dot1 >= 0)
        return false; // neither angle is obtuse
    const Vec3 n0 = (b - a).cross(c - a), n1 = (d - a).cross(b - a);
    const double area0 = n0.norm(), area1 = n1.norm();
    if (area0 == 0 || area1 == 0)
        return false;
    const double cotangents = dot0 / area0 + dot1 / area1;
    const double flat = m_pass.isDetail(va) && m_pass.isDetail(vb) ? flatDetailCosine : flatCosine;
    if (cotangents > -1e-3 || !m_mesh.mayGo(e) || n0.dot(n1) < flat * area0 * area1)
        return false;
    const Vec3 m0 = (a - c).cross(d - c), m1 = (d - c).cross(b - c); // the new faces c,a,d and c,d,b
    const double min = flat * area0, length2 = (c - d).squaredNorm();
    return m0.dot(n0) > min * m0.norm() && m1.dot(n0) > min * m1.norm() && !m_pass.isTooShort(vc, vd, length2) &&
           !m_pass.isTooLong(length2) && m_mesh.isFlipOk(e);
}

void EdgeFlip::flipEdges()
{
    std::vector<RemeshEdge> edges = m_pass.edges([&](double, Slot e) { return shouldFlip(e); });
    for (int pass = 0; pass < flipPasses && !edges.empty(); ++pass)
        edges = flip(std::move(edges));
}

/// Flips the edges that still should be flipped. Returns the edges to be flipped next. Only edges around a flip can
/// have become candidates.
std::vector<RemeshEdge> EdgeFlip::flip(std::vector<RemeshEdge> edges)
{
    std::ranges::sort(
        edges, [](const RemeshEdge& a, const RemeshEdge& b) { return std::tie(a.v0, a.v1) < std::tie(b.v0, b.v1); });
    SlotSet& around = m_pass.region().scratch();
    around.clear();
    for (const RemeshEdge& e : edges) {
        if (!shouldFlip(e.edge) || !m_pass.mayGoOn() || !m_pass.edit().flip(e.edge))
            continue;
        ++m_pass.counts.flips;
        for (Slot h : {2 * e.edge, 2 * e.edge + 1}) {
            for (Slot v : {m_mesh.to(h), m_mesh.to(m_mesh.next(h))}) {
                m_pass.changed().add(v);
                around.add(v);
            }
        }
    }
    std::vector<RemeshEdge> next;
    for (Slot v : around.slots()) {
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            for (Slot e : {h / 2, m_mesh.next(h) / 2}) { // the edges of all faces around v
                if (m_pass.region().contains(m_mesh.to(2 * e)) && m_pass.region().contains(m_mesh.to(2 * e + 1)) &&
                    shouldFlip(e))
                    next.push_back(m_pass.edgeAt(e));
            }
        });
    }
    std::ranges::sort(next, {}, &RemeshEdge::edge);
    next.erase(std::ranges::unique(next, {}, &RemeshEdge::edge).begin(), next.end());
    return next;
}
} // namespace core
