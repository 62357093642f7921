#pragma once

#include "box_tree.h"
#include "parallel.h"
#include "triangle_mesh.h"

#include <span>

namespace core
{
/// Of its faces: points that no face uses do not count.
Box boxOf(const TriangleMesh& mesh);

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, Slot face);

/// The box of each face, for a BoxTree. Points of float32, of lattice integers, or of doubles (to the nearest float32). All cores.
template <typename Points> std::vector<FaceBox> faceBoxes(const Points& points, std::span<const Triangle> triangles)
{
    constexpr std::size_t facesPerChunk = 1 << 14;
    std::vector<FaceBox> boxes(triangles.size());
    forEachChunk(triangles.size(), facesPerChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            for (const Slot corner : triangles[f])
                boxes[f].extend(points[corner].array().template cast<float>());
    });
    return boxes;
}
} // namespace core
