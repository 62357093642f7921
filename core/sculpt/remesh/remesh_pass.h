#pragma once

#include "core/sculpt/remesh/remesh.h"
#include "core/util/parallel.h"

namespace core
{
/// An edge, with its length and ends at the time when it was found.
struct RemeshEdge
{
    double length2;
    Slot v0, v1; ///< slots of the ends, v0 < v1
    Slot edge;
};
/// Compares two edges by length, then by their ends. The order is total, so results depend only on the mesh.
bool isShorter(const RemeshEdge& a, const RemeshEdge& b);
bool isLonger(const RemeshEdge& a, const RemeshEdge& b);

/// Limits on how an operation may change a face. A face that violated a limit before may stay as bad as it was.
struct FaceLimits
{
    double angleSine;       ///< sine of the smallest angle allowed
    double shortest2;       ///< squared length of the shortest edge allowed, mm2
    double keptSliver2 = 1; ///< a smallest angle below `angleSine` must keep this share of its squared sine
    double grown2 = 1;      ///< an edge longer than d_detail may grow to this multiple of its squared length
};

/// The state shared by the steps of one remeshing: region, edge bounds, rest lengths, remaining operations and counts.
class RemeshPass
{
public:
    /// `rest`: null, or the rest lengths of a stroke that keeps detail.
    RemeshPass(MeshEditor& edit, Region& region, const EdgeBounds& bounds, RestLengths* rest = nullptr);

    MeshEditor& edit() { return m_edit; }
    const MeshEditor& edit() const { return m_edit; }
    const Mesh& mesh() const { return m_mesh; }
    Region& region() { return m_region; }
    const Region& region() const { return m_region; }

    bool isTooLong(double length2) const { return length2 > m_detail2; }
    /// Returns whether an edge between a and b with this squared length (mm2) is to be collapsed.
    bool isTooShort(Slot a, Slot b, double length2) const
    {
        return length2 < m_minimum2 && (!m_rest || length2 < squeezed2(a, b));
    }
    bool isTooShort(Slot e, double l2) const { return isTooShort(m_mesh.to(2 * e), m_mesh.to(2 * e + 1), l2); }
    double detail2() const { return m_detail2; }   ///< d_detail squared, in mm2
    double minimum2() const { return m_minimum2; } ///< d squared, in mm2

    /// Returns whether the surface at v was finer than the brush before the stroke, in a stroke that keeps detail.
    bool isDetail(Slot v) const { return m_rest && m_rest->of(v) * m_rest->of(v) < m_detail2; }
    /// Records a vertex created by a split: it has no rest length.
    void noteNew(Slot v)
    {
        if (m_rest)
            m_rest->noteNew(v);
    }

    Vec3 point(Slot v) const { return m_mesh.point(v).cast<double>(); }
    double length2(Slot e) const { return (point(m_mesh.to(2 * e)) - point(m_mesh.to(2 * e + 1))).squaredNorm(); }
    RemeshEdge edgeAt(Slot e) const;
    /// Returns the edges with both ends in the region for which isWanted(squared length, edge slot) is true. `isWanted`
    /// is called on several threads at once.
    template <class Test> std::vector<RemeshEdge> edges(Test isWanted) const;
    /// Appends the region's edges that are to be collapsed and have an end in `around`.
    void addShortEdges(const SlotSet& around, std::vector<RemeshEdge>& edges) const;
    /// Returns whether the faces around v stay sound if v moves to `target`. Faces with the corner `ignored` are not
    /// checked.
    bool staysSound(Slot v, Slot ignored, const Vec3& target, const FaceLimits& limits) const;

    /// Counts one operation. Returns false, and sets counts.capped, if the limit is reached.
    bool mayGoOn();
    /// Returns the vertices around the operations so far.
    SlotSet& changed() { return m_changed; }

    RemeshCounts counts;

private:
    /// vertices per parallel chunk; a dab of the usual size runs on one core
    static constexpr std::size_t verticesPerChunk = 512;

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
