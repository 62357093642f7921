#pragma once

#include "core/geometry/predicates.h"

namespace core
{
/// A triangle with ids for its corners. Triangles share corners by equal ids, never by equal positions.
template <typename Predicates> struct CornerTriangle
{
    std::array<Slot, 3> ids;
    std::array<typename Predicates::Point, 3> points;
};

/// Returns whether two triangles meet anywhere outside the vertices and edges that they share by id. Touching counts as
/// meeting; triangles with the same three ids meet. The test is exact and does not compare boxes first. Precondition:
/// neither triangle is degenerate (collinear). Instantiated for LatticePredicates (10 to 50 ns) and FloatPredicates.
template <typename Predicates>
bool trianglesIntersect(const CornerTriangle<Predicates>& s, const CornerTriangle<Predicates>& t);

extern template bool trianglesIntersect(const CornerTriangle<LatticePredicates>&,
                                        const CornerTriangle<LatticePredicates>&);
extern template bool trianglesIntersect(const CornerTriangle<FloatPredicates>&, const CornerTriangle<FloatPredicates>&);
} // namespace core
