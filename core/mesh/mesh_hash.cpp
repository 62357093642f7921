#include "core/mesh/mesh_hash.h"

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <unordered_set>

namespace core
{
namespace
{
/// Finaliser of splitmix64 (Steele, Lea and Flood 2014).
std::uint64_t mix(std::uint64_t x)
{
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t mix(std::uint64_t state, const HashCorner& corner)
{
    state = mix(state + 0x9e3779b97f4a7c15u + ((std::uint64_t(corner.bits[0]) << 32) | corner.bits[1]));
    return mix(state + 0x9e3779b97f4a7c15u + ((std::uint64_t(corner.bits[2]) << 32) | corner.color));
}

HashCorner currentCorner(const Mesh& mesh, Slot v)
{
    return hashCorner(mesh.point(v), mesh.color(v));
}

std::uint64_t currentHash(const Mesh& mesh, Slot f)
{
    const Triangle& t = mesh.corners(f);
    return faceHash(currentCorner(mesh, t[0]), currentCorner(mesh, t[1]), currentCorner(mesh, t[2]));
}
} // namespace

HashCorner hashCorner(const Vec3f& point, Rgb color)
{
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x == 0 ? 0.0f : x); };
    const std::uint32_t packed = (std::uint32_t(color.r) << 16) | (std::uint32_t(color.g) << 8) | color.b;
    return {{bits(point.x()), bits(point.y()), bits(point.z())}, packed};
}

std::uint64_t faceHash(HashCorner a, HashCorner b, HashCorner c)
{
    while (b < a || c < a) {
        const HashCorner first = a;
        a = b;
        b = c;
        c = first;
    }
    return mix(mix(mix(0, a), b), c);
}

std::uint64_t hashChange(const Mesh& mesh, const MeshDelta& before)
{
    std::unordered_map<Slot, const VertexImage*> oldVertices;
    oldVertices.reserve(before.vertices.size());
    for (const VertexImage& image : before.vertices)
        oldVertices.emplace(image.slot, &image);
    const auto oldCorner = [&](Slot v) {
        const auto found = oldVertices.find(v);
        return found == oldVertices.end() ? currentCorner(mesh, v)
                                          : hashCorner(found->second->point, found->second->color);
    };
    const auto oldHash = [&](const Triangle& t) { return faceHash(oldCorner(t[0]), oldCorner(t[1]), oldCorner(t[2])); };

    std::uint64_t change = 0;
    std::unordered_set<Slot> counted;
    for (const FaceImage& image : before.faces) {
        counted.insert(image.slot);
        if (image.live())
            change -= oldHash(image.corners);
        if (image.slot < mesh.slots().faces && mesh.isFace(image.slot))
            change += currentHash(mesh, image.slot);
    }
    for (const VertexImage& image : before.vertices) {
        const Slot v = image.slot;
        if (v >= mesh.slots().vertices || !mesh.isVertex(v) || currentCorner(mesh, v) == oldCorner(v))
            continue;
        mesh.forEachOutgoing(v, [&](Slot h) {
            const Slot f = mesh.face(h);
            if (counted.insert(f).second)
                // The face kept its corners; only their points or colours changed
                change += currentHash(mesh, f) - oldHash(mesh.corners(f));
        });
    }
    return change;
}

std::uint64_t wholeHash(const Mesh& mesh)
{
    std::uint64_t sum = 0;
    for (const Slot f : mesh.faces())
        sum += currentHash(mesh, f);
    return sum;
}
} // namespace core
