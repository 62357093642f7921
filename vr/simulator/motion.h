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

/// A value as a function of time: it is constant, or moves evenly to the next value.
template <class T> class Track
{
public:
    struct Segment
    {
        XrTime start = 0;
        XrDuration duration = 0; ///< nanoseconds; 0: the value changes at once
        T from, to;

        bool isUnderway(XrTime time) const { return time >= start && time < start + duration; }
    };

    explicit Track(const T& value) : m_segments{Segment{0, 0, value, value}} {}

    /// Moves the value from `start` on. A segment in progress ends at `start`, and later segments are removed. Segments
    /// that ended more than `memory` before `start` may be removed too.
    void moveTo(const T& to, XrTime start, XrDuration duration)
    {
        while (m_segments.size() > 1 && m_segments[1].start < start - memory)
            m_segments.erase(m_segments.begin());
        while (m_segments.size() > 1 && m_segments.back().start > start)
            m_segments.pop_back();
        m_segments.push_back({start, duration, at(start), to});
    }

    /// Returns the segment at a time. Precondition: moveTo() has not removed it.
    const Segment& segment(XrTime time) const
    {
        const auto after = std::upper_bound(m_segments.begin() + 1, m_segments.end(), time,
                                            [](XrTime t, const Segment& segment) { return t < segment.start; });
        return *(after - 1);
    }

    T at(XrTime time) const
    {
        const Segment& now = segment(time);
        if (!now.isUnderway(time))
            return now.to;
        return between(now.from, now.to, static_cast<double>(time - now.start) / static_cast<double>(now.duration));
    }

private:
    static constexpr XrDuration memory = 2'000'000'000; ///< nanoseconds; longer than clients look back

    std::vector<Segment> m_segments; ///< sorted by start; the first segment is valid for all earlier times too
};

/// A moving pose. Its position moves evenly along a line, its rotation evenly about an axis.
struct Motion
{
    Track<core::Vec3> position{core::Vec3::Zero()};
    Track<Eigen::Quaterniond> rotation{Eigen::Quaterniond::Identity()};

    vr::Pose at(XrTime time) const { return {rotation.at(time), position.at(time)}; }

    /// Returns the velocity, metres a second.
    core::Vec3 velocity(XrTime time) const
    {
        const auto& segment = position.segment(time);
        return segment.isUnderway(time) ? core::Vec3((segment.to - segment.from) / seconds(segment.duration))
                                        : core::Vec3::Zero();
    }

    /// Returns the angular velocity about an axis of the room, radians a second.
    core::Vec3 turning(XrTime time) const
    {
        const auto& segment = rotation.segment(time);
        if (!segment.isUnderway(time))
            return core::Vec3::Zero();
        Eigen::Quaterniond way = segment.to * segment.from.conjugate();
        if (way.w() < 0)
            way.coeffs() = -way.coeffs();
        const Eigen::AngleAxisd turn(way);
        return turn.axis() * turn.angle() / seconds(segment.duration);
    }

    static double seconds(XrDuration duration) { return static_cast<double>(duration) * 1e-9; }
};
} // namespace simulator
