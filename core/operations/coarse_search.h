#pragma once

#include "core/sculpt/verify/verified_mesh.h"
#include "core/util/job_control.h"

#include <random>

namespace core
{
/// A random search for surfaces with fewer vertices, for meshes of which no edge can collapse any more: vertices
/// wander and edges flip, as far as the surface stays sound, until one collapses again. The form is kept only roughly.
/// Bjoerner and Lutz 2000 find small triangulations by such flips ("Simplicial manifolds, bistellar flips and a
/// 16-vertex triangulation of the Poincare homology 3-sphere"); here each step is checked in space, too.
class CoarseSearch
{
public:
    /// The mesh's stroke is open. Lasting references.
    CoarseSearch(VerifiedMesh& surface, std::size_t triangles, const JobControl& control)
        : m_surface(surface)
        , m_mesh(surface.mesh())
        , m_target(triangles)
        , m_control(control)
    {}

    /// Ends at `triangles`, or when so many steps have found nothing (a few hundred for each vertex), or after a
    /// bounded number of steps, which take 10 to 30 s. The outcome is the same on any machine.
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
    std::vector<Vec3> m_homes;   ///< by vertex: its place at the beginning
    std::vector<double> m_sizes; ///< by vertex: longest side of its shell, at the beginning
    double m_tolerance = 0;      ///< of the distance from a vertex's home, in sizes of its shell
    std::mt19937 m_random;
    std::size_t m_removed = 0;
    std::size_t m_facesVisited = 0; ///< by all checks
};
} // namespace core
