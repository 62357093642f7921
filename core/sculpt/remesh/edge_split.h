#pragma once

#include "core/sculpt/remesh/remesh_pass.h"

#include <optional>

namespace core
{
/// Splits edges longer than d_detail in their middle (paper, section 3.2.1).
class EdgeSplit
{
public:
    explicit EdgeSplit(RemeshPass& pass) : m_pass(pass), m_mesh(pass.mesh()) {}

    /// Splits the longest edge of each face that meets the ball, until no such face has an edge longer than d_detail.
    /// `candidates`: must include all faces that meet the ball.
    void refine(std::span<const Slot> candidates, const Sphere& ball);
    /// Splits the edges that cross the mirror's plane. Adds the new faces to `faces`, and new vertices in the ball to
    /// the region.
    void splitFacesAcross(std::vector<Slot>& faces, const Sphere& ball);
    /// Splits the region's edges that are longer than d_detail, the longest first. Returns the region's edges that are
    /// to be collapsed (RemeshPass::isTooShort()), old and new ones.
    std::vector<RemeshEdge> splitLongEdges();

private:
    bool mayBeTooLong(Slot f) const;
    std::optional<RemeshEdge> tooLongIn(Slot f, const Sphere& ball) const;
    std::vector<RemeshEdge> tooLongIn(std::span<const Slot> faces, const Sphere& ball) const;
    void select(Slot m, const Sphere& ball);
    double imageDistance(Slot m, const Sphere& ball);
    Slot split(const RemeshEdge& e);

    RemeshPass& m_pass;
    const Mesh& m_mesh;
};
} // namespace core
