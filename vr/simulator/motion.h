#pragma once

#include "vr/util/pose.h"

#include <openxr/openxr.h>

#include <algorithm>
#include <vector>

namespace simulator
{
inline double between(double a, double b, double part)
{
    return a + (b - a) * part;
}

inline core::Vec3 between(const core::Vec3& a, const core::Vec3& b, double part)
{
    return a + (b - a) * part;
}

inline Eigen::Quaterniond between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double part)
{
    return a.slerp(part, b);
}

/// A value as a function of time: still, or on its way evenly to the next.
template <class T> class Track
{
public:
    struct Leg
    {
        XrTime start = 0;
        XrDuration duration = 0; ///< 0: it is there at once
        T from, to;

        bool isUnderway(XrTime time) const { return time >= start && time < start + duration; }
    };

    explicit Track(const T& value) : m_legs{Leg{0, 0, value, value}} {}

    /// From `start` on; a leg that is underway ends there, and those to come are given up. What was long before is forgotten.
    void go(const T& to, XrTime start, XrDuration duration)
    {
        while (m_legs.size() > 1 && m_legs[1].start < start - memory)
            m_legs.erase(m_legs.begin());
        while (m_legs.size() > 1 && m_legs.back().start > start)
            m_legs.pop_back();
        m_legs.push_back({start, duration, at(start), to});
    }

    /// The one that tells the value at that time, which may not be forgotten.
    const Leg& leg(XrTime time) const
    {
        const auto after = std::upper_bound(m_legs.begin() + 1, m_legs.end(), time,
                                            [](XrTime t, const Leg& leg) { return t < leg.start; });
        return *(after - 1);
    }

    T at(XrTime time) const
    {
        const Leg& now = leg(time);
        if (!now.isUnderway(time))
            return now.to;
        return between(now.from, now.to, static_cast<double>(time - now.start) / static_cast<double>(now.duration));
    }

private:
    static constexpr XrDuration memory = 2'000'000'000; ///< longer than clients ask back

    std::vector<Leg> m_legs; ///< by start, the first from ever
};

/// A pose that moves: its position evenly along a line, its rotation evenly about an axis.
struct Motion
{
    Track<core::Vec3> position{core::Vec3::Zero()};
    Track<Eigen::Quaterniond> rotation{Eigen::Quaterniond::Identity()};

    vr::Pose at(XrTime time) const { return {rotation.at(time), position.at(time)}; }

    /// Metres a second.
    core::Vec3 velocity(XrTime time) const
    {
        const auto& leg = position.leg(time);
        return leg.isUnderway(time) ? core::Vec3((leg.to - leg.from) / seconds(leg.duration)) : core::Vec3::Zero();
    }

    /// Radians a second, about an axis of the room.
    core::Vec3 turning(XrTime time) const
    {
        const auto& leg = rotation.leg(time);
        if (!leg.isUnderway(time))
            return core::Vec3::Zero();
        Eigen::Quaterniond way = leg.to * leg.from.conjugate();
        if (way.w() < 0)
            way.coeffs() = -way.coeffs();
        const Eigen::AngleAxisd turn(way);
        return turn.axis() * turn.angle() / seconds(leg.duration);
    }

    static double seconds(XrDuration duration) { return static_cast<double>(duration) * 1e-9; }
};
} // namespace simulator
