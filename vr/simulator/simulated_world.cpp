#include "vr/simulator/simulated_world.h"

namespace simulator
{
namespace
{
constexpr double eyeHeight = 1.6;

Motion still(const core::Vec3& position)
{
    Motion motion;
    motion.position = Track<core::Vec3>(position);
    return motion;
}
} // namespace

SimulatedWorld::SimulatedWorld()
{
    constexpr double tilt = -0.6; // radians: a wand in a relaxed hand points a little downwards
    aim = {Eigen::Quaterniond(Eigen::AngleAxisd(tilt, core::Vec3::UnitX())), core::Vec3(0, -0.01, -0.05)};
    pinch.position = core::Vec3(0, 0.03, -0.07);
    head.motion = still({0, eyeHeight, 0});
    local = still({0, eyeHeight, 0});
    wands[0].grip = still({-0.2, 1.1, -0.3});
    wands[1].grip = still({0.2, 1.1, -0.3});
}
} // namespace simulator
