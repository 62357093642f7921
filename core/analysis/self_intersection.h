#pragma once

#include "core/geometry/predicates.h"

#include <compare>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace core
{
struct FacePair
{
    Slot first, second; ///< first < second
    friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

struct IntersectionReport
{
    /// Number of unordered pairs of faces that meet outside their shared vertices and edges.
    std::uint64_t count = 0;
    std::vector<FacePair> pairs; ///< the first pairs, ascending, at most as many as requested
};

/// Finds all pairs of faces that meet, exactly; touching counts as meeting. Degenerate faces are ignored. `keep`: the
/// largest number of pairs in the report. Uses all cores and bounded memory; the result does not depend on the number
/// of cores. The result of a cancelled search must not be used. Instantiated for LatticePredicates and FloatPredicates.
template <typename Predicates>
IntersectionReport selfIntersections(std::span<const typename Predicates::Point> points,
                                     std::span<const Triangle> triangles, std::size_t keep = 1000,
                                     const std::stop_token& stop = {});

struct SurfaceAndImage
{
    IntersectionReport surface;
    bool imageMeets = false; ///< the image has a self-intersection
};

/// Tests a surface and its image on a lattice together, in little more than the time for one. Precondition: neither has
/// a degenerate face, and snapping preserved the order of coordinates: x1 <= x2 implies that their images are ordered
/// alike.
SurfaceAndImage selfIntersections(std::span<const Vec3f> points, std::span<const LatticePoint> image,
                                  std::span<const Triangle> triangles, std::size_t keep, const std::stop_token& stop);

/// Returns the faces whose corners are collinear or not distinct, ascending.
template <typename Predicates>
std::vector<Slot> degenerateFaces(std::span<const typename Predicates::Point> points,
                                  std::span<const Triangle> triangles);

extern template IntersectionReport selfIntersections<LatticePredicates>(std::span<const LatticePoint>,
                                                                        std::span<const Triangle>, std::size_t,
                                                                        const std::stop_token&);
extern template IntersectionReport selfIntersections<FloatPredicates>(std::span<const Vec3f>, std::span<const Triangle>,
                                                                      std::size_t, const std::stop_token&);
extern template std::vector<Slot> degenerateFaces<LatticePredicates>(std::span<const LatticePoint>,
                                                                     std::span<const Triangle>);
extern template std::vector<Slot> degenerateFaces<FloatPredicates>(std::span<const Vec3f>, std::span<const Triangle>);
} // namespace core
