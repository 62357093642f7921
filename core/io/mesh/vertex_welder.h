#pragma once

#include "core/io/mesh/format.h"

#include "core/geometry/triangle_mesh.h"
#include "core/io/large_buffer.h"

#include <functional>

namespace core::io
{
/// The result of merging equal points (-0 = 0).
struct WeldedPoints
{
    /// Index of each point's distinct point; distinct points are in order of first appearance.
    LargeBuffer<Slot> numbers;
    std::vector<Slot> firsts; ///< index of the first point that equals each distinct point
};

/// Writes the points [begin, begin + into.size()) to `into`. It is called once for each range, on all cores, in any
/// order.
using PointLoader = std::function<void(std::size_t begin, std::span<Vec3f> into)>;

/// Merges equal points, on all cores. Memory: 22 bytes a point, and four a distinct point. Throws ReadingCancelled.
WeldedPoints weldPoints(std::size_t count, const PointLoader& load, const std::stop_token& stop);

/// Merges vertices with equal bits, unless they belong to different parts; the first one's colour and mask are kept.
/// Vertices keep their order.
void weld(TriangleMesh& mesh, const std::stop_token& stop);
} // namespace core::io
