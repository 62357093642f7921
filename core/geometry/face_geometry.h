#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/parallel.h"

#include <span>

namespace core
{
/// Of its faces: points that no face uses do not count.
Box boxOf(const TriangleMesh& mesh);

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, Slot face);

/// The boxes of `count` faces, whose corners triangleAt(i) names, for a BoxTree. Points of float32, of lattice
/// integers, or of doubles (to the nearest float32). All cores.
template <typename Points, typename TriangleAt>
std::vector<FaceBox> faceBoxes(const Points& points, std::size_t count, TriangleAt triangleAt)
{
    constexpr std::size_t facesPerChunk = 1 << 14;
    std::vector<FaceBox> boxes(count);
    forEachChunk(count, facesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (const Slot corner : triangleAt(i))
                boxes[i].extend(points[corner].array().template cast<float>());
    });
    return boxes;
}

/// Of all faces.
template <typename Points> std::vector<FaceBox> faceBoxes(const Points& points, std::span<const Triangle> triangles)
{
    return faceBoxes(points, triangles.size(), [triangles](std::size_t f) -> const Triangle& { return triangles[f]; });
}
} // namespace core
