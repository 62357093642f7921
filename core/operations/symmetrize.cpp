// Replaces one half of the model by the mirror image of the other (like Bishop's Symmetrize in Blender):
//   1. settle   move vertices that are almost on the plane onto it, so that the cut makes no slivers
//   2. part     split edges that cross the plane where they meet it
//   3. mirror   remove the faces of one half, and add the images of the other half's           surgery
//   4. check    the whole mesh exactly; if it is not sound, retry once without step 1           mesh_check

#include "core/operations/symmetrize.h"

#include "core/mesh/mesh_builder.h"
#include "core/operations/transform.h"
#include "core/sculpt/edit/mirror_map.h"

#include <algorithm>

namespace core
{
namespace
{
/// Largest distance of a vertex from the plane at which settle() moves it, as a fraction of its shortest edge.
constexpr double settledPerEdge = 0.1;
/// Progress after mirroring, 0 to 1.
constexpr double afterMirroring = 0.4;

class Symmetrizer
{
public:
    Symmetrizer(Mesh& mesh, const Symmetrize& command)
        : m_mesh(mesh)
        , m_mirror(mesh)
        , m_side(command.keep == Half::Positive ? 1.0f : -1.0f)
    {
        m_mirror.setPlane(command.plane);
    }

    bool isHalfEmpty() const;
    void settle();
    void part();
    bool mirror();

private:
    /// Returns the vertex's distance from the plane, positive on the kept side.
    float height(Slot v) const { return m_side * m_mirror.height(v); }
    bool isKept(const Triangle& t) const;
    Surgery halfAndImage() const;

    Mesh& m_mesh;
    MirrorMap m_mirror;
    float m_side;
};

bool Symmetrizer::isHalfEmpty() const
{
    return std::ranges::none_of(m_mesh.vertices(), [&](Slot v) { return height(v) > 0; });
}

void Symmetrizer::settle()
{
    for (const Slot v : m_mesh.vertices()) {
        if (!m_mirror.isOnPlane(v) && std::abs(height(v)) <= settledPerEdge * shortestEdge(m_mesh, v))
            m_mesh.setPoint(v, m_mirror.kept(m_mesh.point(v), true));
    }
}

/// Splits all edges that cross the plane. One pass suffices because no new edge crosses it.
void Symmetrizer::part()
{
    for (const Slot e : m_mesh.edges()) {
        const Slot a = m_mesh.to(2 * e), b = m_mesh.to(2 * e + 1);
        const double ha = height(a), hb = height(b);
        if (ha * hb >= 0)
            continue;
        const Vec3 p = m_mesh.point(a).cast<double>(), q = m_mesh.point(b).cast<double>();
        m_mesh.splitEdge(e, m_mirror.kept(m_mesh.lattice().snap(p + ha / (ha - hb) * (q - p)), true));
    }
}

/// Returns true for a face of the kept half. Faces within the plane belong to neither half.
bool Symmetrizer::isKept(const Triangle& t) const
{
    return height(t[0]) > 0 || height(t[1]) > 0 || height(t[2]) > 0;
}

Surgery Symmetrizer::halfAndImage() const
{
    Surgery surgery;
    std::vector<Slot> images(m_mesh.slots().vertices, noSlot);
    for (const Slot v : m_mesh.vertices()) {
        if (height(v) < 0)
            continue;
        if (m_mirror.isOnPlane(v)) {
            images[v] = v;
            continue;
        }
        images[v] = Surgery::newVertex(surgery.vertices.size());
        surgery.vertices.push_back({m_mirror.imageOf(m_mesh.point(v)), m_mesh.color(v), noSlot, m_mesh.mask(v)});
        surgery.nearby = v;
    }
    for (const Slot f : m_mesh.faces()) {
        const Triangle& t = m_mesh.corners(f);
        if (isKept(t))
            surgery.faces.push_back({images[t[0]], images[t[2]], images[t[1]]});
        else
            surgery.removed.push_back(f);
    }
    return surgery;
}

/// Replaces one half by the image of the other. Returns false if the result would not be a closed 2-manifold, for
/// example because the surface only touches the plane.
bool Symmetrizer::mirror()
{
    const Surgery surgery = halfAndImage();
    if (!isSurgeryOk(m_mesh, surgery))
        return false;
    m_mesh.replaceFaces(surgery);
    return true;
}
} // namespace

void symmetrize(Mesh& mesh, const Symmetrize& command, ModelChange& change, const JobControl& control)
{
    assert(command.plane != Symmetry::None);
    if (Symmetrizer(mesh, command).isHalfEmpty()) {
        change.refusal = ModelRefusal::EmptyHalf;
        return;
    }
    const Mesh::Mark mark = mesh.mark();
    for (const bool settled : {true, false}) {
        Symmetrizer symmetrizer(mesh, command);
        if (settled)
            symmetrizer.settle();
        symmetrizer.part();
        const bool closed = symmetrizer.mirror();
        control.reportProgress(afterMirroring);
        const MeshReport report = closed && !control.isCancelled()
                                      ? checkMesh(extractMesh(mesh), control.part(afterMirroring, 1))
                                      : MeshReport();
        if (report.printReady())
            return;
        change.faces = report.intersections.count + report.degenerateFaces.count;
        mesh.rollback(mark);
        if (control.isCancelled())
            return;
    }
    change.refusal = ModelRefusal::HalvesMeet;
}
} // namespace core
