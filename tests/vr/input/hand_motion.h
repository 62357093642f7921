#pragma once

#include "vr/openxr/wand_state.h"

#include <algorithm>
#include <vector>

/// Frame rates of headsets, and of overloaded computers, in frames per second.
inline constexpr double frameRates[] = {5, 20, 90, 144};
inline constexpr double frameLength = 1 / 90.0; ///< seconds

/// Returns the times of the frames in [0, seconds], both ends included.
inline std::vector<double> frameTimes(double seconds, double rate)
{
    std::vector<double> times;
    for (int i = 0; i <= seconds * rate + 1e-9; ++i)
        times.push_back(i / rate);
    return times;
}

/// Returns a tracked, active wand with nothing pressed or touched.
inline vr::WandState restingWand()
{
    vr::WandState wand;
    wand.isTracked = wand.isActive = true;
    return wand;
}

inline vr::WandState touching(const Eigen::Vector2d& pad)
{
    vr::WandState wand = restingWand();
    wand.padTouched = true;
    wand.pad = pad;
    return wand;
}

inline vr::WandState pressing(const Eigen::Vector2d& pad)
{
    vr::WandState wand = touching(pad);
    wand.padPressed = true;
    return wand;
}

inline vr::WandState pulling(double trigger)
{
    vr::WandState wand = restingWand();
    wand.trigger = trigger;
    return wand;
}

inline vr::WandState squeezing()
{
    vr::WandState wand = restingWand();
    wand.side = true;
    return wand;
}

inline vr::WandState pressingMenu()
{
    vr::WandState wand = restingWand();
    wand.menu = true;
    return wand;
}

inline vr::WandState pushing(const Eigen::Vector2d& stick)
{
    vr::WandState wand = restingWand();
    wand.isStick = true;
    wand.pad = stick;
    return wand;
}

/// Returns true if `time` is in [from, to).
inline bool isWithin(double time, double from, double to)
{
    return time >= from - 1e-9 && time < to - 1e-9;
}

/// A thumb's movement from one place to another, which rests before `begins` and after `ends`.
struct ThumbWay
{
    double begins, ends;
    Eigen::Vector2d from, to;

    Eigen::Vector2d at(double time) const
    {
        return from + std::clamp((time - begins) / (ends - begins), 0.0, 1.0) * (to - from);
    }
};
