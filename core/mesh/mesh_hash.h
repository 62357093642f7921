#pragma once

#include "core/mesh/mesh.h"

namespace core
{
/// What a face adds to the mesh hash: a fixed 64-bit mix of its corners' float bits (-0 as 0) and colours, the triple
/// turned so that its smallest corner comes first. The mesh hash is the sum over live faces, mod 2^64.
struct HashCorner
{
    std::array<std::uint32_t, 3> bits;
    std::uint32_t color;
    friend auto operator<=>(const HashCorner&, const HashCorner&) = default;
};
HashCorner hashCorner(const Vec3f& point, Rgb color);
std::uint64_t faceHash(HashCorner a, HashCorner b, HashCorner c);

/// By how much an edit changed the hash: `before` holds the images of all that it touched.
std::uint64_t hashChange(const Mesh& mesh, const MeshDelta& before);
/// From scratch. O(mesh).
std::uint64_t wholeHash(const Mesh& mesh);
} // namespace core
