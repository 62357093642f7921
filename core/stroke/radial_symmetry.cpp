#include "core/stroke/radial_symmetry.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr double quarter = 1.57079632679489661923;

bool usesMotion(Tool tool)
{
    return sharpens(tool) || tool == Tool::Grab || tool == Tool::SnakeHook;
}

/// Returns whether the dab's effect depends on its up direction, so that a turned dab differs from the original.
bool hasFrame(const StrokeSettings& settings)
{
    return settings.tool == Tool::Stamp ? settings.model != nullptr : usesAlpha(settings.tool) && settings.alpha;
}

Vec3 mirrored(Vec3 p, Symmetry symmetry)
{
    if (symmetry != Symmetry::None) {
        double& across = p[static_cast<int>(symmetry) - static_cast<int>(Symmetry::X)];
        across = -across;
    }
    return p;
}

/// Returns how much two balls of equal radius overlap: 1 if they coincide, 0 if they only touch.
double overlap(const Vec3& a, const Vec3& b, double radius)
{
    return std::max(0.0, 1 - (a - b).norm() / (2 * radius));
}
} // namespace

Turn Turn::by(double angle)
{
    double sine = 0, cosine = 0, term = 1;
    for (int i = 0; i < 24; i += 2) {
        const double sign = i % 4 == 0 ? 1 : -1;
        cosine += sign * term;
        term *= angle / (i + 1);
        sine += sign * term;
        term *= angle / (i + 2);
    }
    return {cosine, sine};
}

Turn Turn::part(int k, int n)
{
    constexpr Turn quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const Turn whole = quarters[4 * k / n];
    const int rest = 4 * k % n; // angle beyond the last whole quarter turn, in units of 1/n of a quarter turn
    if (rest == 0)
        return whole;
    Turn within = by(quarter * std::min(rest, n - rest) / n);
    if (2 * rest > n)
        std::swap(within.cosine, within.sine);
    return {whole.cosine * within.cosine - whole.sine * within.sine,
            whole.sine * within.cosine + whole.cosine * within.sine};
}

Vec3f Turn::operator*(const Vec3f& p) const
{
    const float c = static_cast<float>(cosine), s = static_cast<float>(sine);
    return {c * p.x() + s * p.z() + 0.0f, p.y(), c * p.z() - s * p.x() + 0.0f};
}

Vec3 Turn::operator*(const Vec3& p) const
{
    return {cosine * p.x() + sine * p.z() + 0.0, p.y(), cosine * p.z() - sine * p.x() + 0.0};
}

Dab operator*(const Turn& turn, Dab dab)
{
    dab.position = turn * dab.position;
    dab.direction = turn * dab.direction;
    dab.motion = turn * dab.motion;
    dab.heading = turn * dab.heading;
    dab.axis = turn * dab.axis;
    dab.up = turn * dab.up;
    dab.ahead = turn * dab.ahead;
    return dab;
}

std::vector<Dab> sectorDabs(const StrokeSettings& settings, const Dab& dab)
{
    std::vector<Dab> dabs = {dab};
    double overlaps = 1;
    for (int k = 1; k < settings.radial; ++k) {
        const Dab other = Turn::part(k, settings.radial) * dab;
        if (!isAmong(dabs, other, settings)) {
            const Vec3 image = mirrored(other.position, settings.symmetry);
            overlaps +=
                std::max(overlap(dab.position, other.position, dab.radius), overlap(dab.position, image, dab.radius));
        }
        dabs.push_back(other);
    }
    for (Dab& each : dabs)
        each.strength /= settings.tool == Tool::Layer ? 1 : overlaps;
    return dabs;
}

bool isAmong(std::span<const Dab> others, const Dab& dab, const StrokeSettings& settings, bool adds)
{
    const bool isMoving = usesMotion(settings.tool), isTurned = !adds && hasFrame(settings);
    return std::ranges::any_of(others, [&](const Dab& other) {
        const bool isSame = other.position == dab.position && (!(isMoving || isTurned) || other.motion == dab.motion) &&
                            (!isTurned || (other.up == dab.up && other.ahead == dab.ahead));
        return isSame || (!isTurned && settings.symmetry != Symmetry::None &&
                          mirrored(other.position, settings.symmetry) == dab.position &&
                          (!isMoving || mirrored(other.motion, settings.symmetry) == dab.motion));
    });
}

std::vector<Vec3> imagesOf(const Vec3& place, const StrokeSettings& settings)
{
    std::vector<Vec3> places;
    for (int k = 0; k < settings.radial; ++k) {
        places.push_back(Turn::part(k, settings.radial) * place);
        if (settings.symmetry != Symmetry::None)
            places.push_back(mirrored(places.back(), settings.symmetry));
    }
    return places;
}
} // namespace core
