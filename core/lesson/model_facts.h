#pragma once

#include "core/analysis/mesh_check.h"

namespace core
{
// Facts for checkpoints that checkMesh() does not compute. Y is up. They do not change if the model is moved, mirrored,
// or rotated about Y. Cost: O(faces); widestOf() also sorts the points.

/// Returns the largest horizontal distance between two of the model's points, in mm.
double widestOf(const TriangleMesh& mesh);
/// Returns the number of feet: the largest number of pieces below a horizontal cut, over several cuts in the lowest
/// tenth of the height. Several cuts are needed because legs may differ in length and may merge further up.
std::size_t feetOf(const TriangleMesh& mesh);
/// Returns the area of the flat surface on the print bed in mm^2, as the print check computes it.
double baseAreaOf(const TriangleMesh& mesh, const MeshReport& report);
/// Returns the number of grooves all around the model: how often its outline narrows and widens again from bottom to
/// top.
std::size_t groovesOf(const TriangleMesh& mesh);
} // namespace core
