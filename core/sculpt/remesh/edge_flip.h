#pragma once

#include "core/sculpt/remesh/remesh_pass.h"

namespace core
{
/// Flips the region's edges by Delaunay's criterion.
class EdgeFlip
{
public:
    explicit EdgeFlip(RemeshPass& pass) : m_pass(pass), m_mesh(pass.mesh()) {}

    void flipEdges();

private:
    bool shouldFlip(Slot e) const;
    std::vector<RemeshEdge> flip(std::vector<RemeshEdge> edges);

    RemeshPass& m_pass;
    const Mesh& m_mesh;
};
} // namespace core
