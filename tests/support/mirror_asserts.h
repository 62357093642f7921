#pragma once

#include "core/mesh/mesh.h"
#include "core/stroke/tool.h"

#include <string>

namespace mirror_asserts
{
/// Returns the first defect of the mirror symmetry, which must hold bit for bit: a vertex without an image, an image of
/// another colour, a face without an image. Empty if there is none.
/// Does not use the engine's own mirror code. Cost: O(n log n).
std::string asymmetry(const core::Mesh& mesh, core::Symmetry plane);
/// Variant of asymmetry() for rotations about the y axis: a half turn (2 parts) or a quarter turn (4 parts).
std::string turnedAsymmetry(const core::Mesh& mesh, int parts);
} // namespace mirror_asserts

#define VERIFY_SYMMETRIC(mesh, plane)                                                                                  \
    do {                                                                                                               \
        const std::string asymmetry = mirror_asserts::asymmetry(mesh, plane);                                          \
        QVERIFY2(asymmetry.empty(), asymmetry.c_str());                                                                \
    } while (false)
