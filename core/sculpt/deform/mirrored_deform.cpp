#include "core/sculpt/deform/mirrored_deform.h"

#include "core/sculpt/deform/dab_weights.h"
#include "core/sculpt/deform/deform.h"

#include <algorithm>

namespace core
{
void keepHalf(Region& region, const MirrorMap& mirror)
{
    region.forEach([&](Slot v) {
        if (!mirror.isInHalf(v))
            region.remove(v);
    });
}

void selectWhole(Region& whole, const Region& half, MirrorMap& mirror, const Mesh& mesh, const Sphere& ball)
{
    whole.clear();
    half.forEach([&](Slot v) {
        whole.add(v, half.distance(v));
        const Slot image = mirror.imageOf(v);
        if (image == v || image == noSlot)
            return;
        const double distance = (mesh.point(image).cast<double>() - ball.center).norm();
        if (distance <= ball.radius)
            whole.add(image, distance);
    });
}

void selectWholeGrabbed(Region& whole, const Region& half, MirrorMap& mirror, double radius)
{
    whole.clear();
    half.forEach([&](Slot v) {
        whole.add(v, half.distance(v));
        const Slot image = mirror.imageOf(v);
        if (image != v && image != noSlot && half.carried(v) <= radius)
            whole.add(image, half.carried(v));
    });
}

namespace
{
/// Returns the weight that the dab's image has at the dab's centre, for Grab and Snake Hook; 0 for other tools.
double imageWeight(const MirrorMap& mirror, const DeformInput& input)
{
    const Dab& dab = input.dab;
    if (input.settings.tool != Tool::Grab && input.settings.tool != Tool::SnakeHook)
        return 0;
    return weightAt((mirror.imageOf(dab.position) - dab.position).norm(), input.settings, dab);
}

/// Returns the divisor of the sum of two displacements with these weights. `imageAtCenter`: imageWeight().
double divisor(double weight, double other, double imageAtCenter)
{
    const auto [least, most] = std::minmax(weight, other);
    const double shared = most > 0 ? imageAtCenter * least / most : 0;
    return std::max(1 + shared, weight + other);
}
} // namespace

double planMirrored(Region& half, Region& whole, MirrorMap& mirror, const DeformInput& input)
{
    planDeformation(whole, input);
    const DabWeights shares(whole, input.mesh, input.settings, input.dab, input.moved);
    const bool isLayer = input.settings.tool == Tool::Layer;
    const double imageAtCenter = imageWeight(mirror, input);
    double longest2 = 0;
    half.forEach([&](Slot v) {
        Vec3 plan = whole.plan(v);
        const Slot image = mirror.imageOf(v);
        if (image != noSlot && whole.contains(image)) {
            const Vec3 other = mirror.imageOf(whole.plan(image));
            const double length = plan.norm(), otherLength = other.norm(), sum = length + otherLength;
            plan += other;
            if (!isLayer)
                plan /= divisor(shares.of(v), shares.of(image), imageAtCenter);
            else if (sum > 0)
                plan *= std::max(length, otherLength) / sum;
        }
        half.setPlan(v, plan);
        longest2 = std::max(longest2, plan.squaredNorm());
    });
    return std::sqrt(longest2);
}
} // namespace core
