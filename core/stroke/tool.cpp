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
constexpr double detailPerRadiusSquared = 0.05; ///< d_detail^2 / r^2 (paper, section 3.2.2)

double power(double x, int n)
{
    double result = 1;
    for (int i = 0; i < n; ++i)
        result *= x;
    return result;
}

/// Returns the outcome's rank from harmless (0) to bad.
auto severity(DabOutcome outcome)
{
    constexpr std::array order{DabOutcome::Empty,    DabOutcome::Committed,  DabOutcome::Added,
                               DabOutcome::Fallback, DabOutcome::EndedEarly, DabOutcome::Refused};
    return std::ranges::find(order, outcome) - order.begin();
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
    // keeps the smaller share reached / asked, here the second dab's
    if (second.reached * asked < reached * second.asked || asked == 0) {
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
    constexpr std::array ofRefusal{Shortfall::None,   Shortfall::Inside, Shortfall::TooClose,
                                   Shortfall::NoRoom, Shortfall::Unfit,  Shortfall::Masked};
    static_assert(ofRefusal.size() == static_cast<std::size_t>(Refusal::Masked) + 1);
    if (dab.refusal != Refusal::None)
        return ofRefusal[static_cast<std::size_t>(dab.refusal)];
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
    return {detailLength, EdgeBounds::minimumPerDetail * detailLength};
}

double radiusFor(double detailLength, double detail)
{
    return detailLength / edgeBounds(1, detail).detail;
}
} // namespace core
