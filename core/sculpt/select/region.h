#pragma once

#include "core/mesh/face_octree.h"
#include "core/stroke/stroke.h"
#include "core/stroke/tool.h"
#include "core/util/slot_bits.h"
#include "core/util/sparse_index.h"

#include <span>

namespace core
{
/// The vertices that a dab moves, and the displacement planned for each. All steps of a dab share one region. Remeshing
/// updates it: a vertex that splits an edge between two selected vertices is added, with the mean of their plans.
class Region
{
public:
    void clear();
    bool empty() const { return m_live == 0; }
    /// Returns the number of vertices in the region. Removed vertices do not count.
    Slot size() const { return m_live; }
    bool contains(Slot v) const { return m_present.contains(v); }

    /// Adds a vertex, or overwrites its values. `distance`: from the brush's centre, as the brush measures it, mm (r_i
    /// in the paper). `plan`: a copy, because the plan of another vertex of this region may move in memory. `carried`:
    /// see carried().
    void add(Slot v, double distance, Vec3 plan = Vec3::Zero(), double carried = 0);
    /// Adds a vertex in the middle of a and b, with the means of their values. Precondition: the region contains a and
    /// b.
    void addBetween(Slot v, Slot a, Slot b);
    void remove(Slot v);

    /// Returns every slot that was ever added, in the order of addition. position() is a slot's index in this list; it
    /// never changes.
    const std::vector<Slot>& slots() const { return m_index.slots(); }
    Slot position(Slot v) const { return m_index.position(v); }

    double distance(Slot v) const { return m_distance[m_index.position(v)]; }
    const Vec3& plan(Slot v) const { return m_plan[m_index.position(v)]; }
    void setPlan(Slot v, const Vec3& plan) { m_plan[m_index.position(v)] = plan; }

    /// A value per vertex whose meaning depends on the tool. Stamp: nonzero on its outline. Drag tools on both sides of
    /// a mirror: the distance of the vertex's image from the brush, or from the place of grabbing, mm.
    double carried(Slot v) const { return m_carried[m_index.position(v)]; }
    void setCarried(Slot v, double carried) { m_carried[m_index.position(v)] = carried; }

    /// Returns the vertices around the operations of the last remeshing.
    SlotSet& remeshed() { return m_remeshed; }
    /// Returns a set of slots that any function may use as scratch memory.
    SlotSet& scratch() { return m_scratch; }

    /// A copy of the region's state, restored after a sub-step that failed. Cost: O(region).
    struct Saved
    {
        std::vector<Slot> slots;
        std::vector<double> distance;
        std::vector<Vec3> plan;
        std::vector<double> carried;
        std::vector<Slot> gone;
    };
    Saved save() const;
    void restore(const Saved& saved);

    template <class Visit> void forEach(Visit visit) const
    {
        for (std::size_t i = 0; i < m_index.slots().size(); ++i) { // the list may grow during the loop
            if (const Slot v = m_index.slots()[i]; contains(v))
                visit(v);
        }
    }

private:
    SparseIndex m_index;
    SlotSet m_remeshed, m_scratch;
    std::vector<double> m_distance;
    std::vector<Vec3> m_plan;
    std::vector<double> m_carried;
    SlotBits m_present;
    Slot m_live = 0;
};

/// Returns the live vertices of the list and their neighbours, as far as the region contains them.
std::vector<Slot> withNeighbours(Region& region, const Mesh& mesh, std::span<const Slot> vertices);
/// Returns the corners of all faces; a vertex is repeated for each of its faces.
std::vector<Slot> cornersOf(const Mesh& mesh, std::span<const Slot> faces);

/// Selects the vertices within the ball, by Euclidean distance: the spherical brush (paper, section 3.1.2). Adds them
/// in ascending order. `candidates` receives the candidate triangles of section 3.1.1, those whose boxes meet the
/// ball's box, in unspecified order.
void selectSphere(Region& region, std::vector<Slot>& candidates, const Mesh& mesh, const FaceOctree& octree,
                  const Sphere& ball);

/// Selects the vertices whose geodesic distance from a surface point is at most the ball's radius: the ray brush
/// (paper, section 3.1.3). Runs Dijkstra's algorithm over the edges inside the ball, from the three corners of the face
/// that contains the point. Path lengths along edges overestimate geodesics, on even meshes by up to 15 %. Adds the
/// vertices in ascending order. `candidates`: on entry, contains that face; on exit, the faces reached. `max`: if more
/// vertices are reached, none is selected.
void selectGeodesic(Region& region, std::vector<Slot>& candidates, const Mesh& mesh, const Sphere& ball,
                    Slot max = noSlot);
} // namespace core
