#pragma once

#include "core/geometry/geometry.h"

#include <cstdint>
#include <span>
#include <vector>

namespace core
{
/// How often something was found, and the first faces where, ascending, at most maxFirst.
struct Finding
{
    static constexpr std::size_t maxFirst = 1000;

    std::uint64_t count = 0;
    std::vector<Slot> firstFaces;
};

/// How the faces of a loose mesh hang together.
struct MeshTopology
{
    std::size_t vertices = 0; ///< that a face uses
    std::uint64_t edges = 0;
    Finding openEdges;           ///< of one face
    Finding nonManifoldEdges;    ///< of more than two
    Finding nonManifoldVertices; ///< whose faces are not all joined by edges there
    Finding misorientedEdges;    ///< of two faces that run it in the same direction
};

/// All cores; the result does not depend on their number.
MeshTopology topologyOf(std::size_t vertices, std::span<const Triangle> triangles);
} // namespace core
