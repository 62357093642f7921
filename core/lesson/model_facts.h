#pragma once

#include "core/analysis/mesh_check.h"

namespace core
{
// Facts that lessons ask for besides what checkMesh() says. Y is up; a model that is turned about it, mirrored or moved
// has the same. Cost: O(faces), and a sort of the points for the widest.

/// Returns the longest distance between two of its points, seen from above, in mm.
double widestOf(const TriangleMesh& mesh);
/// Returns into how many pieces a level cut within the lowest tenth of its height parts what is below, at the best
/// height: legs may be of unequal length, and grow together further up.
std::size_t feetOf(const TriangleMesh& mesh);
/// Returns how much flat surface lies on the bed, in mm^2, as the print check has it.
double baseAreaOf(const TriangleMesh& mesh, const MeshReport& report);
/// Counts how often its outline becomes narrower and wider again on the way up: grooves all around it.
std::size_t groovesOf(const TriangleMesh& mesh);
} // namespace core
