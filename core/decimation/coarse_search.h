#pragma once

#include "core/sculpt/verify/verified_mesh.h"
#include "core/util/job_control.h"

#include <random>

namespace core
{
/// A random search for surfaces with fewer vertices, for meshes in which no edge can collapse any more. Moves vertices
/// and flips edges at random, as far as the surface stays sound, until an edge can collapse. The shape is kept only
/// roughly. Bjoerner and Lutz 2000 find small triangulations by such flips ("Simplicial manifolds, bistellar flips and
/// a 16-vertex triangulation of the Poincare homology 3-sphere"); unlike theirs, each step here is also checked for
/// intersections in space.
class CoarseSearch
{
public:
    /// All references must outlive this object. Precondition: a stroke of the mesh is open.
    CoarseSearch(VerifiedMesh& surface, std::size_t triangles, const JobControl& control)
        : m_surface(surface)
        , m_mesh(surface.mesh())
        , m_target(triangles)
        , m_control(control)
    {}

    /// Runs until the mesh has at most `triangles` faces. Gives up after some hundred visits per vertex in a row that
    /// remove nothing, or after a bounded amount of work, which takes 10 to 30 s. The result is the same on any
    /// machine.
    void run();

private:
    bool isDone() const { return m_mesh.live().faces <= m_target || m_control.isCancelled(); }
    bool attempt(const std::function<void()>& step);
    void visit(Slot v);
    bool remove(Slot v);
    void flipAt(Slot v);
    void move(Slot v);
    void measure();
    double limitAt(Slot v) const { return m_tolerance * m_sizes[v]; }
    double random();

    VerifiedMesh& m_surface;
    Mesh& m_mesh;
    std::size_t m_target;
    const JobControl& m_control;
    std::vector<Vec3> m_homes; ///< position of each vertex at the beginning, by vertex slot, mm
    /// longest side of the bounding box of the vertex's connected component at the beginning, by vertex slot, mm
    std::vector<double> m_sizes;
    double m_tolerance = 0; ///< largest distance of a vertex from its initial position, as a fraction of m_sizes
    std::mt19937 m_random;
    std::size_t m_removed = 0;
    std::size_t m_facesVisited = 0; ///< number of faces visited by all checks
};
} // namespace core
