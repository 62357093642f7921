#pragma once

#include "core/io/mesh/format.h"

#include "core/geometry/triangle_mesh.h"
#include "core/util/large_buffer.h"

#include <functional>

namespace core::io
{
/// Which of many points are one (-0 = 0).
struct WeldedPoints
{
    LargeBuffer<Slot> numbers; ///< of each point: which of the distinct ones it is, in order of appearance
    std::vector<Slot> firsts;  ///< of each distinct one: the first point that is it
};

/// Puts the points [begin, begin + into.size()) there; called once for each part, on all cores, in any order.
using PointLoader = std::function<void(std::size_t begin, std::span<Vec3f> into)>;

/// On all cores; 25 bytes a point. Throws ReadingCancelled.
WeldedPoints weldPoints(std::size_t count, const PointLoader& load, const std::stop_token& stop);

/// Makes vertices of equal bits one, where there are any; the first one's colour stays. Vertices keep their order.
void weld(TriangleMesh& mesh, const std::stop_token& stop);
} // namespace core::io
