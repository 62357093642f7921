#pragma once

#include "vr/openxr/wand_state.h"

#include <algorithm>
#include <vector>

/// Frames a second that headsets have, and what a machine in trouble makes of them.
inline constexpr double frameRates[] = {5, 20, 90, 144};
inline constexpr double frameLength = 1 / 90.0; ///< seconds

/// The times of so many seconds, the last included.
inline std::vector<double> frameTimes(double seconds, double rate)
{
    std::vector<double> times;
    for (int i = 0; i <= seconds * rate + 1e-9; ++i)
        times.push_back(i / rate);
    return times;
}

/// A wand that is there, in nobody's way, with nothing pressed.
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

/// Whether `time` lies in [from, to).
inline bool isWithin(double time, double from, double to)
{
    return time >= from - 1e-9 && time < to - 1e-9;
}

/// From one place to another in that time, resting before and after.
struct ThumbWay
{
    double begins, ends;
    Eigen::Vector2d from, to;

    Eigen::Vector2d at(double time) const
    {
        return from + std::clamp((time - begins) / (ends - begins), 0.0, 1.0) * (to - from);
    }
};
