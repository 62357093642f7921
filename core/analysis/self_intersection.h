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
    std::uint64_t count = 0;     ///< of unordered pairs of faces that meet outside their shared vertices and edges
    std::vector<FacePair> pairs; ///< the first ones, ascending, as many as were asked for
};

/// Exact; touching is meeting. Faces that are degenerate take no part. All cores, memory bounded whatever the count;
/// the result does not depend on the number of cores. If it is cancelled, the result is not usable. Instantiated for
/// both sets of predicates.
template <typename Predicates>
IntersectionReport selfIntersections(std::span<const typename Predicates::Point> points,
                                     std::span<const Triangle> triangles, std::size_t keep = 1000,
                                     const std::stop_token& stop = {});

struct SurfaceAndImage
{
    IntersectionReport surface;
    bool imageMeets = false; ///< itself, somewhere
};

/// A surface and its image on a lattice at once, in little more than the time of one. Neither has a degenerate face,
/// and the order of coordinates is kept: of two points, none comes before the other in the image that came after it.
SurfaceAndImage selfIntersections(std::span<const Vec3f> points, std::span<const LatticePoint> image,
                                  std::span<const Triangle> triangles, std::size_t keep, const std::stop_token& stop);

/// Faces whose corners are collinear, or not three, ascending.
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
