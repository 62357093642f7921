#pragma once

#include "core/geometry/predicates.h"

namespace core
{
/// A triangle with its corners' identities: corners are shared by id, never by position.
template <typename Predicates> struct CornerTriangle
{
    std::array<Slot, 3> ids;
    std::array<typename Predicates::Point, 3> points;
};

/// Do the two triangles meet anywhere outside the vertices and edges that they share by id? Touching is meeting, and so
/// are two triangles of the same three ids. Exact. Neither triangle may be degenerate (collinear). Boxes are not
/// compared. Instantiated for LatticePredicates (10 to 50 ns) and FloatPredicates.
template <typename Predicates>
bool trianglesIntersect(const CornerTriangle<Predicates>& s, const CornerTriangle<Predicates>& t);

extern template bool trianglesIntersect(const CornerTriangle<LatticePredicates>&,
                                        const CornerTriangle<LatticePredicates>&);
extern template bool trianglesIntersect(const CornerTriangle<FloatPredicates>&, const CornerTriangle<FloatPredicates>&);
} // namespace core
