// What may be asked of the whole mask, each a value per vertex that follows from the masks before:
//   invert, clear, sharpen    from its own
//   blur, grow, shrink        from its own and its neighbours', as one ring of edges lies around it
//   cavity, color, part       from the surface: what is hollow, of a colour, or in one piece with what is masked is
//   masked, too

#include "core/operations/mask_operations.h"

#include "core/mesh/normals.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr std::uint8_t whole = 255;
/// One ring is hardly to be seen.
constexpr int blurRings = 2;
/// The largest difference of a channel at which a colour counts wholly, and at which no longer.
constexpr int sameColor = 24, otherColor = 64;

/// By slot.
using Masks = std::vector<std::uint8_t>;

template <class Value> Masks each(const Mesh& mesh, Value value)
{
    Masks masks(mesh.slots().vertices);
    for (const Slot v : mesh.vertices())
        masks[v] = value(v);
    return masks;
}

Masks masksOf(const Mesh& mesh)
{
    return each(mesh, [&](Slot v) { return mesh.mask(v); });
}

std::uint8_t clamped(double mask)
{
    return static_cast<std::uint8_t>(std::clamp(mask, 0.0, 255.0) + 0.5);
}

/// The mean of a vertex and its neighbours' mean.
Masks blurred(const Mesh& mesh)
{
    Masks masks = masksOf(mesh);
    for (int ring = 0; ring < blurRings; ++ring) {
        masks = each(mesh, [&](Slot v) {
            unsigned sum = 0, n = 0;
            mesh.forEachOutgoing(v, [&](Slot h) { sum += masks[mesh.to(h)], ++n; });
            return clamped(0.5 * (masks[v] + double(sum) / n));
        });
    }
    return masks;
}

/// The most, or the least, of a vertex and its neighbours.
template <class Choose> Masks spread(const Mesh& mesh, Choose choose)
{
    return each(mesh, [&](Slot v) {
        std::uint8_t mask = mesh.mask(v);
        mesh.forEachOutgoing(v, [&](Slot h) { mask = choose(mask, mesh.mask(mesh.to(h))); });
        return mask;
    });
}

/// How deep a vertex lies below its neighbours' mean, in terms of the edges around it; negative above. Sums are exact,
/// so that mirror images are as hollow.
double hollowness(const Mesh& mesh, Slot v)
{
    const Vec3 p = mesh.point(v).cast<double>(), normal = vertexNormal(mesh, v);
    double edges2 = 0;
    int n = 0;
    mesh.forEachOutgoing(v, [&](Slot h) { edges2 += (mesh.point(mesh.to(h)).cast<double>() - p).squaredNorm(), ++n; });
    const double squared = normal.squaredNorm() * edges2 / n;
    return squared > 0 ? (neighbourMean(mesh, v) - p).dot(normal) / std::sqrt(squared) : 0;
}

/// Wholly where it is as hollow as the model is curved in the mean.
Masks hollows(const Mesh& mesh)
{
    std::vector<double> depth(mesh.slots().vertices);
    double squares = 0;
    for (const Slot v : mesh.vertices()) {
        depth[v] = hollowness(mesh, v);
        squares += depth[v] * depth[v];
    }
    const double mean = std::sqrt(squares / mesh.live().vertices);
    return each(mesh, [&](Slot v) {
        return std::max(mesh.mask(v), mean > 0 ? clamped(255 * depth[v] / mean) : std::uint8_t(0));
    });
}

Masks ofColor(const Mesh& mesh, Rgb color)
{
    return each(mesh, [&](Slot v) {
        const Rgb c = mesh.color(v);
        const int apart = std::max({std::abs(c.r - color.r), std::abs(c.g - color.g), std::abs(c.b - color.b)});
        return std::max(mesh.mask(v), clamped(255.0 * (otherColor - apart) / (otherColor - sameColor)));
    });
}

/// All that hangs together with a masked vertex.
Masks wholeParts(const Mesh& mesh)
{
    Masks masks = masksOf(mesh);
    std::vector<Slot> front;
    std::ranges::copy_if(mesh.vertices(), std::back_inserter(front), [&](Slot v) { return mesh.isMasked(v); });
    std::vector<bool> reached(mesh.slots().vertices);
    while (!front.empty()) {
        const Slot v = front.back();
        front.pop_back();
        if (reached[v])
            continue;
        reached[v] = true;
        masks[v] = whole;
        mesh.forEachOutgoing(v, [&](Slot h) { front.push_back(mesh.to(h)); });
    }
    return masks;
}

Masks changed(const Mesh& mesh, const MaskOperation& command)
{
    switch (command.how) {
    case MaskOperation::Kind::Invert:
        return each(mesh, [&](Slot v) { return static_cast<std::uint8_t>(whole - mesh.mask(v)); });
    case MaskOperation::Kind::Blur:
        return blurred(mesh);
    case MaskOperation::Kind::Sharpen:
        return each(mesh, [&](Slot v) { return clamped(2.0 * mesh.mask(v) - 127.5); });
    case MaskOperation::Kind::Grow:
        return spread(mesh, [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    case MaskOperation::Kind::Shrink:
        return spread(mesh, [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); });
    case MaskOperation::Kind::Cavity:
        return hollows(mesh);
    case MaskOperation::Kind::Color:
        return ofColor(mesh, command.color);
    case MaskOperation::Kind::Part:
        return wholeParts(mesh);
    case MaskOperation::Kind::Clear:
        break;
    }
    return Masks(mesh.slots().vertices);
}
} // namespace

void applyMaskOperation(Mesh& mesh, const MaskOperation& command)
{
    const Masks masks = changed(mesh, command);
    for (const Slot v : mesh.vertices()) {
        if (masks[v] != mesh.mask(v))
            mesh.setMask(v, masks[v]);
    }
}
} // namespace core
