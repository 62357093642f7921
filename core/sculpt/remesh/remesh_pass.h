#pragma once

#include "core/sculpt/remesh/remesh.h"
#include "core/util/parallel.h"

namespace core
{
/// An edge as it was when it was found.
struct RemeshEdge
{
    double length2;
    Slot v0, v1; ///< v0 < v1
    Slot edge;
};
/// Total orders: results depend only on the mesh.
bool isShorter(const RemeshEdge& a, const RemeshEdge& b);
bool isLonger(const RemeshEdge& a, const RemeshEdge& b);

/// Limits on what a step may do to a face, unless it was worse before.
struct FaceLimits
{
    double angleSine;
    double shortest2;
    double keptSliver2 = 1; ///< share of a smaller angle's squared sine that must be left
    double grown2 = 1;      ///< share of its squared length that an edge longer than d_detail may reach
};

/// The state that the steps of one remeshing share: the region, its bounds and rest lengths, the operations that are
/// left, and what was done.
class RemeshPass
{
public:
    /// `rest`: null, or of a stroke that keeps detail.
    RemeshPass(MeshEditor& edit, Region& region, const EdgeBounds& bounds, RestLengths* rest = nullptr);

    MeshEditor& edit() { return m_edit; }
    const MeshEditor& edit() const { return m_edit; }
    const Mesh& mesh() const { return m_mesh; }
    Region& region() { return m_region; }
    const Region& region() const { return m_region; }

    bool isTooLong(double length2) const { return length2 > m_detail2; }
    /// Whether an edge between a and b of that squared length is to collapse.
    bool isTooShort(Slot a, Slot b, double length2) const
    {
        return length2 < m_minimum2 && (!m_rest || length2 < squeezed2(a, b));
    }
    bool isTooShort(Slot e, double l2) const { return isTooShort(m_mesh.to(2 * e), m_mesh.to(2 * e + 1), l2); }
    double detail2() const { return m_detail2; }   ///< d_detail squared, in mm2
    double minimum2() const { return m_minimum2; } ///< d squared, in mm2

    /// Whether the surface at v was finer than the brush before the stroke, and is to keep its detail.
    bool isDetail(Slot v) const { return m_rest && m_rest->of(v) * m_rest->of(v) < m_detail2; }
    /// Notes a vertex that a split has made.
    void noteNew(Slot v)
    {
        if (m_rest)
            m_rest->noteNew(v);
    }

    Vec3 point(Slot v) const { return m_mesh.point(v).cast<double>(); }
    double length2(Slot e) const { return (point(m_mesh.to(2 * e)) - point(m_mesh.to(2 * e + 1))).squaredNorm(); }
    RemeshEdge edgeAt(Slot e) const;
    /// Returns the edges with both ends in the region that are wanted by their squared length and slot. `isWanted` runs
    /// on all cores.
    template <class Test> std::vector<RemeshEdge> edges(Test isWanted) const;
    /// Appends the edges of the region that are too short and have an end among the vertices.
    void addShortEdges(const SlotSet& around, std::vector<RemeshEdge>& edges) const;
    /// Whether the faces around v, except those with `ignored`, stay sound when v moves to the target.
    bool staysSound(Slot v, Slot ignored, const Vec3& target, const FaceLimits& limits) const;

    /// Counts an operation that is to come. False if there were too many.
    bool mayGoOn();
    /// Vertices around the operations so far.
    SlotSet& changed() { return m_changed; }

    RemeshCounts counts;

private:
    static constexpr std::size_t verticesPerChunk = 512; ///< a dab of the usual size does not wake the other cores

    double squeezed2(Slot a, Slot b) const;

    MeshEditor& m_edit;
    const Mesh& m_mesh;
    Region& m_region;
    RestLengths* m_rest;
    double m_detail2, m_minimum2;
    std::uint64_t m_opsLeft;
    SlotSet& m_changed;
};

template <class Test> std::vector<RemeshEdge> RemeshPass::edges(Test isWanted) const
{
    const std::vector<Slot>& slots = m_region.slots();
    const auto collect = [&](std::size_t begin, std::size_t end, std::vector<RemeshEdge>& edges) {
        for (std::size_t i = begin; i < end; ++i) {
            const Slot v = slots[i];
            if (!m_region.contains(v))
                continue;
            const Vec3 p = point(v);
            m_mesh.forEachOutgoing(v, [&](Slot h) {
                const Slot other = m_mesh.to(h);
                if (other < v || !m_region.contains(other))
                    return;
                const double l2 = (point(other) - p).squaredNorm();
                if (isWanted(l2, h / 2))
                    edges.push_back({l2, v, other, h / 2});
            });
        }
    };
    return joinChunks<std::vector<RemeshEdge>>(slots.size(), verticesPerChunk, collect);
}
} // namespace core
