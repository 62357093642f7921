#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// A sample and its dab's centre, mm.
struct PlacedSample
{
    StrokeSample sample;
    Vec3 center;
};

/// The way of the hand from one sample to the next. Position and direction follow the parabola through a third sample
/// beside these two, so that few samples of a curve make a curve; the rest is linear, the model's rotation too (and
/// then of unit length), except that up is the later sample's.
class SampleCurve
{
public:
    SampleCurve() = default;
    /// `before`, `after`: the samples beside these two, or null. The one before counts first; without both the way is
    /// straight, and so it is where it turns by more than 60 degrees at a sample, as at a corner.
    SampleCurve(const PlacedSample& from, const PlacedSample& to, const PlacedSample* before,
                const PlacedSample* after);

    /// Returns the sample at t, from 0 to 1.
    StrokeSample at(double t) const;

private:
    StrokeSample m_from, m_to;
    Vec3 m_bend = Vec3::Zero(), m_directionBend = Vec3::Zero(); ///< the parabola is linear + t (1 - t) bend
};
} // namespace core
