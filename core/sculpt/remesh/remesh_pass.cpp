#include "core/sculpt/remesh/remesh_pass.h"

#include <algorithm>
#include <tuple>

namespace core
{
namespace
{
/// One remeshing may do minOps operations, plus opsPerVertex for each vertex of the region, but at most maxOps. A guard
/// against endless work, not a tuning knob.
constexpr std::uint64_t opsPerVertex = 64, minOps = 4096, maxOps = 1 << 19;
/// Cosine of the largest angle, about 78 degrees, by which an operation may turn a face (after the legality tests of El
/// Topo: Brochu and Bridson 2009).
constexpr double minTurnCosine = 0.2;
/// An edge finer than the brush is collapsed when it is shorter than this share of its length before the stroke.
constexpr double squeezedShare = 0.25;

/// A triangle's area and smallest angle.
struct Shape
{
    Vec3 normal;
    double area2; ///< squared length of `normal`
    double smallestSine2;
};

Shape shapeOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a);
    const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
    const double shortest = std::min({ab, bc, ca});
    const double longest = shortest == ab ? bc * ca : shortest == bc ? ca * ab : ab * bc;
    const double area2 = normal.squaredNorm();
    return {normal, area2, longest > 0 ? area2 / longest : 0};
}
} // namespace

bool isShorter(const RemeshEdge& a, const RemeshEdge& b)
{
    return std::tie(a.length2, a.v0, a.v1) < std::tie(b.length2, b.v0, b.v1);
}

bool isLonger(const RemeshEdge& a, const RemeshEdge& b)
{
    return std::tie(b.length2, a.v0, a.v1) < std::tie(a.length2, b.v0, b.v1);
}

RemeshPass::RemeshPass(MeshEditor& edit, Region& region, const EdgeBounds& bounds, RestLengths* rest)
    : m_edit(edit)
    , m_mesh(edit.mesh())
    , m_region(region)
    , m_rest(rest)
    , m_detail2(bounds.detail * bounds.detail)
    , m_minimum2(bounds.minimum * bounds.minimum)
    , m_opsLeft(std::min(maxOps, minOps + opsPerVertex * region.size()))
    , m_changed(region.remeshed())
{
    m_changed.clear();
}

/// Returns the squared length, mm2, below which an edge finer than the brush is collapsed.
double RemeshPass::squeezed2(Slot a, Slot b) const
{
    const double squeezed = squeezedShare * std::min(m_rest->of(a), m_rest->of(b));
    return squeezed * squeezed;
}

bool RemeshPass::mayGoOn()
{
    if (m_opsLeft == 0) {
        counts.capped = true;
        return false;
    }
    --m_opsLeft;
    return true;
}

RemeshEdge RemeshPass::edgeAt(Slot e) const
{
    const Slot a = m_mesh.to(2 * e), b = m_mesh.to(2 * e + 1);
    return {length2(e), std::min(a, b), std::max(a, b), e};
}

void RemeshPass::addShortEdges(const SlotSet& around, std::vector<RemeshEdge>& edges) const
{
    for (Slot v : around.slots()) {
        if (!m_region.contains(v))
            continue;
        m_mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot other = m_mesh.to(h);
            const bool isSeen = other < v && around.contains(other);
            if (!isSeen && m_region.contains(other) && isTooShort(v, other, length2(h / 2)))
                edges.push_back(edgeAt(h / 2));
        });
    }
}

bool RemeshPass::staysSound(Slot v, Slot ignored, const Vec3& target, const FaceLimits& limits) const
{
    bool sound = true;
    const Vec3 p = point(v);
    m_mesh.forEachOutgoing(v, [&](Slot h) {
        const Slot b = m_mesh.to(h), c = m_mesh.to(m_mesh.next(h));
        if (!sound || b == ignored || c == ignored)
            return;
        const Vec3 pb = point(b), pc = point(c);
        const Shape before = shapeOf(p, pb, pc), after = shapeOf(target, pb, pc);
        const double turn = before.normal.dot(after.normal);
        const double before2 = (p - pb).squaredNorm(), after2 = (target - pb).squaredNorm();
        if (turn <= 0 || turn * turn <= minTurnCosine * minTurnCosine * before.area2 * after.area2 ||
            after.smallestSine2 <
                std::min(limits.angleSine * limits.angleSine, limits.keptSliver2 * before.smallestSine2) ||
            after2 > std::max(m_detail2, limits.grown2 * before2) || after2 < std::min(limits.shortest2, before2))
            sound = false;
    });
    return sound;
}
} // namespace core
