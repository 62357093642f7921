#pragma once

#include "core/sculpt/remesh/remesh_pass.h"

#include <optional>

namespace core
{
/// Splits edges that are too long, in their middle (paper, section 3.2.1).
class EdgeSplit
{
public:
    explicit EdgeSplit(RemeshPass& pass) : m_pass(pass), m_mesh(pass.mesh()) {}

    /// Splits the longest edge of each face that meets the ball, until none there is too long. `candidates`: at least
    /// the faces that meet it.
    void refine(std::span<const Slot> candidates, const Sphere& ball);
    /// Splits the long edges of the region, the longest first. Returns the short ones: no split touches one, and among
    /// the new edges there are more.
    std::vector<RemeshEdge> splitLongEdges();

private:
    bool mayBeTooLong(Slot f) const;
    std::optional<RemeshEdge> tooLongIn(Slot f, const Sphere& ball) const;
    std::vector<RemeshEdge> tooLongIn(std::span<const Slot> faces, const Sphere& ball) const;
    void splitFacesAcross(std::vector<Slot>& faces, const Sphere& ball);
    void select(Slot m, const Sphere& ball);
    Slot split(const RemeshEdge& e);

    RemeshPass& m_pass;
    const Mesh& m_mesh;
};
} // namespace core
