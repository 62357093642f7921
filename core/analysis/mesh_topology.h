#pragma once

#include "core/geometry/geometry.h"

#include <cstdint>
#include <span>
#include <vector>

namespace core
{
/// The number of defects of one kind, and the first faces that have it, ascending, at most maxFirst.
struct Finding
{
    static constexpr std::size_t maxFirst = 1000;

    std::uint64_t count = 0;
    std::vector<Slot> firstFaces;
};

/// Connectivity of a mesh without half-edges: its edges, and its defects by kind.
struct MeshTopology
{
    std::size_t vertices = 0; ///< vertices that a face uses
    std::uint64_t edges = 0;
    Finding openEdges;           ///< edges of one face
    Finding nonManifoldEdges;    ///< edges of more than two faces
    Finding nonManifoldVertices; ///< vertices whose faces form more than one umbrella
    Finding misorientedEdges;    ///< edges whose two faces run along them in the same direction
};

/// Computes the topology on all cores; the result does not depend on their number.
MeshTopology topologyOf(std::size_t vertices, std::span<const Triangle> triangles);
} // namespace core
