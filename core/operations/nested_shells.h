#pragma once

#include "core/geometry/quadric.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/util/job_control.h"

#include <queue>

namespace core
{
/// Reduces shells that lie inside of each other with little room between, where no edge of one can collapse without
/// meeting the next: from the smallest to the largest, each by its share; then it shrinks about its middle, so that
/// its flat faces leave room for those of the shell around it.
class NestedShells
{
public:
    /// The mesh's stroke is open. Lasting references.
    NestedShells(VerifiedMesh& surface, std::size_t triangles, const JobControl& control)
        : m_surface(surface)
        , m_mesh(surface.mesh())
        , m_target(triangles)
        , m_control(control)
    {}

    /// Does nothing to a mesh of one shell. Cost: a few verified steps for each vertex that goes.
    void run();

private:
    struct Shell
    {
        std::vector<Slot> vertices;
        Box box;
        std::size_t faces() const { return 2 * vertices.size(); } ///< about, of few handles
    };
    /// A vertex that may go to a neighbour.
    struct Candidate
    {
        double error;
        Slot from, to;
        std::uint32_t stamp;                         ///< of both, summed
        bool operator<(const Candidate& other) const // the queue's first is its greatest
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
    std::vector<std::uint32_t> m_stamps; ///< by vertex: its changes so far
    std::priority_queue<Candidate> m_queue;
};
} // namespace core
