#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/triangle_mesh.h"
#include "core/util/parallel.h"

#include <span>

namespace core
{
/// Returns the bounding box of the faces; points that no face uses are ignored.
Box boxOf(const TriangleMesh& mesh);

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, Slot face);

/// Returns the bounding boxes of `count` faces, for a BoxTree. triangleAt(i) returns the corners of face i. Points are
/// float32, lattice integers, or doubles (rounded to the nearest float32). Uses all cores.
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

/// Returns the bounding boxes of all faces.
template <typename Points> std::vector<FaceBox> faceBoxes(const Points& points, std::span<const Triangle> triangles)
{
    return faceBoxes(points, triangles.size(), [triangles](std::size_t f) -> const Triangle& { return triangles[f]; });
}
} // namespace core
