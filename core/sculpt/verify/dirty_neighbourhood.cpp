#include "core/sculpt/verify/dirty_neighbourhood.h"

#include "core/geometry/box_clusters.h"
#include "core/geometry/predicates.h"
#include "core/util/parallel.h"

namespace core
{
namespace
{
/// Faces in a parallel chunk: about ten microseconds of work, so that small dabs run on one core.
constexpr std::size_t facesPerRead = 512;
} // namespace

void DirtyNeighbourhood::collectDirty(const Mesh& mesh, const TouchedSlots& touched)
{
    m_faces.clear();
    for (Slot f : touched.faces) {
        if (mesh.isFace(f))
            m_faces.add(f);
    }
    m_relinkedCount = static_cast<Slot>(m_faces.size());
    for (Slot v : touched.vertices) {
        if (mesh.isVertex(v))
            mesh.forEachOutgoing(v, [&](Slot h) { m_faces.add(mesh.face(h)); });
    }
    m_dirtyCount = static_cast<Slot>(m_faces.size());
    read(mesh, m_faces.slots(), 0);
}

/// Gathers faces by boxes that contain the changed faces both where they are and where they were, because the surface
/// has swept over the space between. A shell that has been enclosed or released was passed by a connected part of the
/// changed surface, so it is in the box of that part.
void DirtyNeighbourhood::gather(const Mesh& mesh, const FaceOctree& octree, const TouchedSlots& touched)
{
    LatticeBox all;
    for (const LatticeBox& box : dirtyBoxes())
        all.extend(box);
    for (const TouchedSlots::Place& place : touched.before)
        all.extend(mesh.lattice().toLattice(place.point));
    std::vector<LatticeBox> clusters;
    if (separatingAxis(dirtyBoxes(), all) == 3) { // the usual case
        clusters.push_back(all);
    } else {
        std::vector<LatticeBox> boxes = boxesOfChange(mesh, touched);
        addClusters(boxes, clusters);
    }
    for (const LatticeBox& cluster : clusters) {
        for (Slot f : facesIn(mesh, octree, cluster))
            m_faces.add(f); // a dirty face is in the set already
    }
    read(mesh, std::span(m_faces.slots()).subspan(m_dirtyCount), m_dirtyCount);
}

/// Returns one box for each face that only moved, covering its old and new place, and two boxes for each relinked face.
/// Faces created and removed within the change have none.
std::vector<LatticeBox> DirtyNeighbourhood::boxesOfChange(const Mesh& mesh, const TouchedSlots& touched)
{
    m_moved.clear();
    for (const TouchedSlots::Place& place : touched.before)
        m_moved.add(place.vertex);
    const auto extend = [&](LatticeBox& box, const Triangle& corners) {
        for (Slot v : corners) {
            const Slot moved = m_moved.find(v);
            box.extend(moved == noSlot ? mesh.latticePoint(v) : mesh.lattice().toLattice(touched.before[moved].point));
        }
    };
    std::vector<LatticeBox> boxes(dirtyBoxes().begin(), dirtyBoxes().end());
    for (Slot i = m_relinkedCount; i < m_dirtyCount; ++i)
        extend(boxes[i], m_shapes[i].corners);
    for (const Triangle& corners : touched.facesBefore)
        extend(boxes.emplace_back(), corners);
    return boxes;
}

void DirtyNeighbourhood::buildIndex()
{
    m_index.clear();
    for (Slot f : m_faces.slots())
        m_index.add(f);
}

/// Reads shapes and boxes of faces. `first`: the index in faces() of the first one.
void DirtyNeighbourhood::read(const Mesh& mesh, std::span<const Slot> faces, std::size_t first)
{
    if (first + faces.size() > m_shapes.size()) {
        m_shapes.resize(first + faces.size());
        m_boxes.resize(first + faces.size());
    }
    forEachChunk(faces.size(), facesPerRead, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Triangle& t = mesh.corners(faces[i]);
            const LatticePoint a = mesh.latticePoint(t[0]), b = mesh.latticePoint(t[1]), c = mesh.latticePoint(t[2]);
            m_shapes[first + i] = {t, {a, b, c}};
            m_boxes[first + i] = {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
        }
    });
}

bool DirtyNeighbourhood::isDegenerate(Slot index) const
{
    const auto& p = m_shapes[index].points;
    return LatticePredicates::collinear(p[0], p[1], p[2]);
}

Vec3 DirtyNeighbourhood::normal(Slot index) const
{
    const auto& p = m_shapes[index].points;
    const Vec3 ab = (p[1] - p[0]).cast<double>(), ac = (p[2] - p[0]).cast<double>();
    return ab.cross(ac);
}
} // namespace core
