#pragma once

#include "core/geometry/quadric.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/util/job_control.h"

#include <queue>

namespace core
{
/// Reduces components that are nested so closely that no edge can collapse without meeting the next component. Works
/// from the smallest to the largest, each down to its share of the target. Then shrinks the component about its middle,
/// so that its flat faces leave room for those of the component around it.
class NestedShells
{
public:
    /// All references must outlive this object. Precondition: a stroke of the mesh is open.
    NestedShells(VerifiedMesh& surface, std::size_t triangles, const JobControl& control)
        : m_surface(surface)
        , m_mesh(surface.mesh())
        , m_target(triangles)
        , m_control(control)
    {}

    /// Has no effect on a mesh with one component. Cost: a few verified steps per removed vertex.
    void run();

private:
    struct Shell
    {
        std::vector<Slot> vertices;
        Box box;
        std::size_t faces() const { return 2 * vertices.size(); } ///< approximate, for few handles
    };
    /// A collapse of vertex `from` into its neighbour `to`.
    struct Candidate
    {
        double error;
        Slot from, to;
        std::uint32_t stamp; ///< sum of the two vertices' stamps
        // inverted, so that the priority queue's top has the smallest error
        bool operator<(const Candidate& other) const
        {
            return std::tie(other.error, other.from, other.to) < std::tie(error, from, to);
        }
    };

    std::vector<Shell> shells() const;
    void reduce(Shell& shell, std::size_t faces);
    void shrink(const Shell& shell);
    void gatherQuadrics();
    void push(Slot from, Slot to);
    void push(Slot v);

    VerifiedMesh& m_surface;
    Mesh& m_mesh;
    std::size_t m_target;
    const JobControl& m_control;
    std::vector<Quadric<3>> m_quadrics;
    std::vector<std::uint32_t> m_stamps; ///< number of changes so far, by vertex
    std::priority_queue<Candidate> m_queue;
};
} // namespace core
