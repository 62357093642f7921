#pragma once

#include "core/mesh/face_octree.h"
#include "core/stroke/stroke.h"
#include "core/stroke/tool.h"
#include "core/util/slot_bits.h"
#include "core/util/sparse_index.h"

#include <span>

namespace core
{
/// The vertices that a dab moves, and how far it means to move each: the argument that is passed down the pipeline.
/// Remeshing changes it in place: a vertex put into an edge of two selected ends joins with the mean of their plans.
class Region
{
public:
    void clear();
    bool empty() const { return m_live == 0; }
    /// Returns the number of vertices that are still there.
    Slot size() const { return m_live; }
    bool contains(Slot v) const { return m_present.contains(v); }

    /// `distance`: from the brush's centre, as the brush measures it (r_i in the paper). `carried`: see below.
    void add(Slot v, double distance, const Vec3& plan = Vec3::Zero(), double carried = 0);
    /// Adds a vertex in the middle of a and b, which belong to the region.
    void addBetween(Slot v, Slot a, Slot b);
    void remove(Slot v);

    /// Returns every slot that was ever added, in that order; position() is a slot's place in it, and never changes.
    const std::vector<Slot>& slots() const { return m_index.slots(); }
    Slot position(Slot v) const { return m_index.position(v); }

    double distance(Slot v) const { return m_distance[m_index.position(v)]; }
    const Vec3& plan(Slot v) const { return m_plan[m_index.position(v)]; }
    void setPlan(Slot v, const Vec3& plan) { m_plan[m_index.position(v)] = plan; }

    /// A tool's own value for a vertex. Stamp: not 0 on its outline. A drag tool on both sides of a mirror: the
    /// distance of its image from the brush, or from where that was grabbed, in mm.
    double carried(Slot v) const { return m_carried[m_index.position(v)]; }
    void setCarried(Slot v, double carried) { m_carried[m_index.position(v)] = carried; }

    /// Vertices around the operations of the last remeshing.
    SlotSet& remeshed() { return m_remeshed; }
    /// A set of slots for any function's own use.
    SlotSet& scratch() { return m_scratch; }

    /// A copy of the region's state, to return to after a sub-step that failed. Cost: the region.
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
        for (std::size_t i = 0; i < m_index.slots().size(); ++i) { // may grow meanwhile
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

/// Returns those of the vertices that still exist, and their neighbours, as far as the region contains them.
std::vector<Slot> withNeighbours(Region& region, const Mesh& mesh, std::span<const Slot> vertices);
/// Returns the corners of the faces, a vertex as often as it is one.
std::vector<Slot> cornersOf(const Mesh& mesh, std::span<const Slot> faces);

/// Selects the vertices within the ball, by Euclidean distance: the spherical brush (paper, section 3.1.2). Ascending
/// by slot. `candidates` becomes the candidate triangles of section 3.1.1, those whose boxes meet the ball's, in no
/// useful order.
void selectSphere(Region& region, std::vector<Slot>& candidates, const Mesh& mesh, const FaceOctree& octree,
                  const Sphere& ball);

/// Selects the vertices whose geodesic distance from a point of the surface is at most the ball's radius: the ray brush
/// (paper, section 3.1.3). Runs Dijkstra's algorithm over the edges inside the ball, from the three corners of the face
/// that holds the point. That face is one of `candidates`, which then become the faces reached. Ascending by slot. A
/// path along edges is never shorter than the true geodesic, and on even meshes up to 15 % longer. `max`: if there are
/// more vertices, none is selected.
void selectGeodesic(Region& region, std::vector<Slot>& candidates, const Mesh& mesh, const Sphere& ball,
                    Slot max = noSlot);
} // namespace core
