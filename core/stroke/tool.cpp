#include "core/stroke/tool.h"

#include "core/stroke/stroke.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace core
{
namespace
{
constexpr std::array<std::string_view, 16> toolTable{"pull",   "push",   "inflate", "clay",   "layer", "flatten",
                                                     "scrape", "smooth", "pinch",   "crease", "grab",  "snake",
                                                     "twist",  "stamp",  "paint",   "mask"};
constexpr std::array<std::string_view, 2> brushTable{"sphere", "ray"};
constexpr std::array<std::string_view, 2> topologyTable{"adaptive", "uniform"};
constexpr std::array<std::string_view, 3> placementTable{"point", "nearest", "ray"};
constexpr std::array<std::string_view, 4> symmetryTable{"none", "x", "y", "z"};
constexpr std::array<std::string_view, 6> outcomeTable{"committed", "careful", "ended_early",
                                                       "empty",     "added",   "refused"};

constexpr double detailPerRadiusSquared = 0.05; ///< paper, section 3.2.2
constexpr double minimumPerDetail = 0.5;        ///< square root of the paper's 0.25

template <class Value, std::size_t N>
std::optional<Value> named(std::string_view name, const std::array<std::string_view, N>& table)
{
    const auto found = std::find(table.begin(), table.end(), name);
    if (found == table.end())
        return std::nullopt;
    return static_cast<Value>(found - table.begin());
}

double power(double x, int n)
{
    double result = 1;
    for (int i = 0; i < n; ++i)
        result *= x;
    return result;
}
} // namespace

std::span<const std::string_view> toolNames()
{
    return toolTable;
}

std::string_view name(Tool tool)
{
    return toolTable[static_cast<std::size_t>(tool)];
}

std::optional<Tool> toolNamed(std::string_view name)
{
    return named<Tool>(name, toolTable);
}

std::string_view name(BrushShape brush)
{
    return brushTable[static_cast<std::size_t>(brush)];
}

std::optional<BrushShape> brushNamed(std::string_view name)
{
    return named<BrushShape>(name, brushTable);
}

std::string_view name(Topology topology)
{
    return topologyTable[static_cast<std::size_t>(topology)];
}

std::optional<Topology> topologyNamed(std::string_view name)
{
    return named<Topology>(name, topologyTable);
}

std::string_view name(Placement placement)
{
    return placementTable[static_cast<std::size_t>(placement)];
}

std::optional<Placement> placementNamed(std::string_view name)
{
    return named<Placement>(name, placementTable);
}

std::string_view name(Symmetry symmetry)
{
    return symmetryTable[static_cast<std::size_t>(symmetry)];
}

std::optional<Symmetry> symmetryNamed(std::string_view name)
{
    return named<Symmetry>(name, symmetryTable);
}

std::string_view name(DabOutcome outcome)
{
    return outcomeTable[static_cast<std::size_t>(outcome)];
}

namespace
{
int severity(DabOutcome outcome)
{
    switch (outcome) {
    case DabOutcome::Empty:
        return 0;
    case DabOutcome::Committed:
        return 1;
    case DabOutcome::Added:
        return 2;
    case DabOutcome::Fallback:
        return 3;
    case DabOutcome::EndedEarly:
        return 4;
    case DabOutcome::Refused:
        return 5;
    }
    return 0;
}
} // namespace

DabReport& DabReport::operator+=(const DabReport& second)
{
    selectMs += second.selectMs;
    optimiseMs += second.optimiseMs;
    deformMs += second.deformMs;
    fuseMs += second.fuseMs;
    touchedVertices += second.touchedVertices;
    touchedFaces += second.touchedFaces;
    substeps += second.substeps;
    if (second.reached * asked < reached * second.asked || asked == 0) { // reached / asked is less
        asked = second.asked;
        reached = second.reached;
        contact = second.contact;
    }
    wall = wall || second.wall;
    capped = capped || second.capped;
    asymmetric = asymmetric || second.asymmetric;
    if (severity(second.outcome) > severity(outcome)) {
        outcome = second.outcome;
        refusal = second.refusal;
    }
    return *this;
}

Shortfall shortfallOf(const DabReport& dab)
{
    switch (dab.refusal) {
    case Refusal::None:
        break;
    case Refusal::Inside:
        return Shortfall::Inside;
    case Refusal::TooClose:
        return Shortfall::TooClose;
    case Refusal::Wall:
        return Shortfall::NoRoom;
    case Refusal::Unfit:
        return Shortfall::Unfit;
    }
    if (dab.capped)
        return Shortfall::Capped;
    if (dab.wall)
        return Shortfall::Wall;
    if (dab.contact && (dab.outcome == DabOutcome::EndedEarly || !dab.isWhole()))
        return Shortfall::Contact;
    return dab.outcome == DabOutcome::EndedEarly ? Shortfall::Blocked : Shortfall::None;
}

double falloff(double x, int n)
{
    assert(isFalloff(n));
    if (n == 0)
        return 1;
    x = std::clamp(x, 0.0, 1.0);
    const double lower = power(x, n - 1);
    return std::clamp((n - 1) * lower * x - n * lower + 1, 0.0, 1.0);
}

EdgeBounds edgeBounds(double radius, double detail)
{
    return edgeBounds(std::sqrt(detailPerRadiusSquared) * radius * detail);
}

EdgeBounds edgeBounds(double detailLength)
{
    return {detailLength, minimumPerDetail * detailLength};
}

double radiusFor(double detailLength, double detail)
{
    return detailLength / edgeBounds(1, detail).detail;
}
} // namespace core
