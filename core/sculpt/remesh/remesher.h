#pragma once

#include "core/sculpt/remesh/remesh.h"
#include "core/util/parallel.h"

#include <functional>
#include <optional>

namespace core
{
/// An edge as it was when it was found.
struct RemeshEdge
{
    double length2;
    Slot v0, v1; ///< v0 < v1
    Slot edge;
};

/// What the steps of remesh.h's functions share: steps 0 and 1 stand in split.cpp, 2 in collapse.cpp, 3 in
/// flip.cpp. For these only.
class Remesher
{
public:
    /// `keepsShape`: see optimiseKeepingShape().
    Remesher(MeshEditor& edit, Region& region, const EdgeBounds& bounds, bool keepsShape = false);

    void refine(std::span<const Slot> candidates, const Sphere& ball);
    std::vector<RemeshEdge> splitLongEdges();
    void collapseShortEdges(std::vector<RemeshEdge> edges);
    void flipEdges();
    void relax(const std::function<Vec3(Slot)>& place);
    void moveTo(const std::function<Vec3(Slot)>& place);

    RemeshCounts counts;

private:
    /// What a core takes at a time: a dab of the usual size does not wake the others.
    static constexpr std::size_t verticesPerChunk = 512, facesPerChunk = 1024;
    struct Merged
    {
        Vec3f point;
        Vec3 plan;
        double error = 0; ///< planeError(), in squares of the shortest edge; of keepShape() only
    };
    /// What a step may do to a face, unless it was worse before.
    struct Limits
    {
        double angleSine;
        double shortest2;
        double keptSliver2 = 1; ///< of a smaller angle's squared sine, what must be left
    };
    using Choices = std::array<Merged, 3>;
    Limits collapseLimits() const;

    Vec3 point(Slot v) const { return m_mesh.point(v).cast<double>(); }
    double length2(Slot e) const { return (point(m_mesh.to(2 * e)) - point(m_mesh.to(2 * e + 1))).squaredNorm(); }
    bool mayGoOn();
    template <class Wanted> std::vector<RemeshEdge> regionEdges(Wanted wanted) const;
    RemeshEdge edgeAt(Slot e) const;
    void addShortEdges(const SlotSet& around, std::vector<RemeshEdge>& edges) const;
    bool mayBeTooLong(Slot f) const;
    std::optional<RemeshEdge> tooLongIn(Slot f, const Sphere& ball) const;
    std::vector<RemeshEdge> tooLongIn(std::span<const Slot> faces, const Sphere& ball) const;
    void joinRefined(Slot m, const Sphere& ball);
    void partFacesAcross(std::vector<Slot>& faces, const Sphere& ball);
    Slot split(const RemeshEdge& e);
    std::vector<RemeshEdge> collapse(std::vector<RemeshEdge> edges);
    std::vector<RemeshEdge> flip(std::vector<RemeshEdge> edges);
    std::optional<Merged> mergedEnds(Slot h) const;
    std::size_t keepShape(Slot h, Choices& choices) const;
    bool staysSound(Slot v, Slot ignored, const Vec3& target, const Limits& limits) const;
    bool shouldFlip(Slot e) const;
    void moveVertex(Slot v, const Vec3& place);

    MeshEditor& m_edit;
    const Mesh& m_mesh;
    Region& m_region;
    double m_detail2, m_minimum2;
    std::uint64_t m_opsLeft;
    SlotSet& m_changed; ///< vertices around operations
    bool m_keepsShape;
};

/// Edges with both ends in the region that are wanted by their squared length and slot. `wanted` runs on all cores.
template <class Wanted> std::vector<RemeshEdge> Remesher::regionEdges(Wanted wanted) const
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
                if (wanted(l2, h / 2))
                    edges.push_back({l2, v, other, h / 2});
            });
        }
    };
    return joinChunks<std::vector<RemeshEdge>>(slots.size(), verticesPerChunk, collect);
}
} // namespace core
