// Operations on the mask of the whole model. Each computes the new mask of a vertex from the old masks:
//   invert, clear, sharpen    from the vertex's own mask
//   blur, grow, shrink        from the masks of the vertex and its one-ring
//   cavity, color, part       from the surface: masks what is hollow, has a colour, or is connected to a masked vertex

#include "core/operations/mask_operations.h"

#include "core/area/seen_vertices.h"
#include "core/mesh/normals.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr std::uint8_t fullMask = 255;
/// Number of times that a blur averages over the one-ring. Once is hardly visible.
constexpr int blurRings = 2;
/// Limits for masking by colour, on the largest difference in any channel (0 to 255): up to sameColor a vertex is
/// masked fully, from otherColor on not at all.
constexpr int sameColor = 24, otherColor = 64;

/// Masks by vertex slot.
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

/// Returns the masks blurred: `blurRings` times, each becomes the mean of itself and its neighbours' mean.
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

/// Returns the masks with each replaced by the maximum, or minimum, over the vertex and its neighbours. `choose`:
/// returns the larger, or smaller, of two masks.
template <class Choose> Masks spread(const Mesh& mesh, Choose choose)
{
    return each(mesh, [&](Slot v) {
        std::uint8_t mask = mesh.mask(v);
        mesh.forEachOutgoing(v, [&](Slot h) { mask = choose(mask, mesh.mask(mesh.to(h))); });
        return mask;
    });
}

/// Returns the depth of a vertex below the mean of its neighbours, relative to the lengths of its edges; negative
/// above. Sums are exact, so mirror images get equal results.
double hollowness(const Mesh& mesh, Slot v)
{
    const Vec3 p = mesh.point(v).cast<double>(), normal = vertexNormal(mesh, v);
    double edges2 = 0;
    int n = 0;
    mesh.forEachOutgoing(v, [&](Slot h) { edges2 += (mesh.point(mesh.to(h)).cast<double>() - p).squaredNorm(), ++n; });
    const double squared = normal.squaredNorm() * edges2 / n;
    return squared > 0 ? (neighbourMean(mesh, v) - p).dot(normal) / std::sqrt(squared) : 0;
}

/// Returns the masks with cavities added. A vertex is masked fully if its hollowness() reaches the model's root mean
/// square.
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

/// Returns the masks with every component that contains a masked vertex masked fully.
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
        masks[v] = fullMask;
        mesh.forEachOutgoing(v, [&](Slot h) { front.push_back(mesh.to(h)); });
    }
    return masks;
}

Masks changed(const Mesh& mesh, const MaskOperation& command)
{
    switch (command.how) {
    case MaskOperation::Kind::Invert:
        return each(mesh, [&](Slot v) { return static_cast<std::uint8_t>(fullMask - mesh.mask(v)); });
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

void showEveryPart(Mesh& mesh)
{
    MeshFrame frame = mesh.frame();
    std::vector<Part> parts = frame.parts.all();
    for (Part& part : parts)
        part.isVisible = true;
    frame.parts = PartList(std::move(parts));
    mesh.setFrame(frame);
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

void applyHide(Mesh& mesh, const Hide& command, std::optional<PartId> part)
{
    constexpr int half = 128;
    const bool showsAll = command.showsAll();
    const auto isMeant = [&](Slot v) { return showsAll || !part || mesh.part(v) == *part; };
    const auto isHalfMasked = [&](Slot v) { return mesh.mask(v) >= half; };
    if (!showsAll && std::ranges::none_of(mesh.vertices(), [&](Slot v) { return isMeant(v) && isHalfMasked(v); }))
        return;
    for (const Slot v : mesh.vertices()) {
        const bool hides = !showsAll && isHalfMasked(v) == (command.what == Hide::What::Masked);
        if (isMeant(v) && mesh.isHidden(v) != hides && (hides || showsAll))
            mesh.setHidden(v, hides);
    }
    if (command.what == Hide::What::NoPart)
        showEveryPart(mesh);
}

void applyMaskArea(Mesh& mesh, const MaskArea& command, std::optional<PartId> part, ModelChange& change)
{
    const auto isIn = verticesIn(command.area, mesh, part);
    if (!isIn)
        change.refusal = ModelRefusal::NoOutline;
    const std::uint8_t mask = command.isErasing ? 0 : fullMask;
    for (const Slot v : mesh.vertices()) {
        if (isIn && (*isIn)[v] && mesh.mask(v) != mask)
            mesh.setMask(v, mask);
    }
}

void applyHideArea(Mesh& mesh, const HideArea& command, std::optional<PartId> part, ModelChange& change)
{
    const auto isIn = verticesIn(command.area, mesh, part);
    if (!isIn)
        change.refusal = ModelRefusal::NoOutline;
    for (const Slot v : mesh.vertices()) {
        if (isIn && (*isIn)[v])
            mesh.setHidden(v, true);
    }
}
} // namespace core
