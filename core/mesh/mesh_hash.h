#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// A corner of a face as it is hashed: the float bits of its coordinates (-0 as 0) and its colour. The hash of a face
/// is a fixed 64-bit mix of its corners, rotated so that the smallest corner is first. The mesh hash is the sum of the
/// hashes of the live faces, mod 2^64.
struct HashCorner
{
    std::array<std::uint32_t, 3> bits;
    std::uint32_t color;
    friend auto operator<=>(const HashCorner&, const HashCorner&) = default;
};
HashCorner hashCorner(const Vec3f& point, Rgb color);
std::uint64_t faceHash(HashCorner a, HashCorner b, HashCorner c);

/// Returns the change of the mesh hash by an edit. Precondition: `before` contains the images of all touched elements.
std::uint64_t hashChange(const Mesh& mesh, const MeshDelta& before);
/// Computes the mesh hash from scratch. Cost: O(mesh).
std::uint64_t wholeHash(const Mesh& mesh);
} // namespace core
