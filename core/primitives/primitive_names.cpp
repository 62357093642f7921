// The words of primitives, and the measures that each kind has.
#include "core/primitives/primitives.h"

#include <algorithm>

namespace core
{
namespace
{
using PrimitiveKind = Primitive::Kind;
using Measure = Primitive::Measure;

constexpr std::string_view kindNames[] = {"box", "ball", "cylinder", "cone", "capsule", "torus", "lathe", "tube"};
static_assert(std::size(kindNames) == Primitive::kinds);
constexpr std::string_view measureNames[] = {"width", "height", "depth", "radius", "top_radius", "tube_radius"};
static_assert(std::size(measureNames) == Primitive::measures);

constexpr Measure boxMeasures[] = {Measure::Width, Measure::Height, Measure::Depth};
constexpr Measure ballMeasures[] = {Measure::Radius};
constexpr Measure cylinderMeasures[] = {Measure::Radius, Measure::Height};
constexpr Measure coneMeasures[] = {Measure::Radius, Measure::TopRadius, Measure::Height};
constexpr Measure torusMeasures[] = {Measure::Radius, Measure::TubeRadius};
} // namespace

std::string_view name(Primitive::Kind kind)
{
    return kindNames[static_cast<std::size_t>(kind)];
}

std::optional<Primitive::Kind> primitiveNamed(std::string_view name)
{
    const auto found = std::ranges::find(kindNames, name);
    return found == std::end(kindNames) ? std::nullopt
                                        : std::optional(static_cast<PrimitiveKind>(found - std::begin(kindNames)));
}

std::string_view name(Primitive::Measure measure)
{
    return measureNames[static_cast<std::size_t>(measure)];
}

std::span<const Primitive::Measure> measuresOf(Primitive::Kind kind)
{
    switch (kind) {
    case PrimitiveKind::Cuboid:
        return boxMeasures;
    case PrimitiveKind::Ball:
        return ballMeasures;
    case PrimitiveKind::Cylinder:
    case PrimitiveKind::Capsule:
        return cylinderMeasures;
    case PrimitiveKind::Cone:
        return coneMeasures;
    case PrimitiveKind::Torus:
        return torusMeasures;
    case PrimitiveKind::Lathe:
    case PrimitiveKind::Tube:
        break;
    }
    return {};
}

bool hasAxis(Primitive::Kind kind)
{
    return kind != PrimitiveKind::Tube;
}
} // namespace core
