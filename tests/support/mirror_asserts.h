#pragma once

#include "core/mesh/mesh.h"
#include "core/stroke/tool.h"

#include <string>

namespace mirror_asserts
{
/// What keeps the mesh from being its own mirror image, bit for bit: a vertex without an image, one whose image has
/// another colour, a face without an image. Empty if nothing does. O(n log n), and without a word of the engine's own
/// mirror.
std::string asymmetry(const core::Mesh& mesh, core::Symmetry plane);
/// The same for a half turn about y (2 parts), or a quarter turn (4).
std::string turnedAsymmetry(const core::Mesh& mesh, int parts);
} // namespace mirror_asserts

#define VERIFY_SYMMETRIC(mesh, plane)                                                                                  \
    do {                                                                                                               \
        const std::string asymmetry = mirror_asserts::asymmetry(mesh, plane);                                          \
        QVERIFY2(asymmetry.empty(), asymmetry.c_str());                                                                \
    } while (false)
