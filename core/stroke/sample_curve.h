#pragma once

#include "core/stroke/stroke.h"

namespace core
{
/// A sample and the centre of its dab, mm.
struct PlacedSample
{
    StrokeSample sample;
    Vec3 center;
};

/// Interpolates between two samples. Position and direction follow a parabola through these two and a third,
/// neighbouring sample, so that a few samples of a curve give a curve. All other values are interpolated linearly, the
/// rotation too (and normalised). The up vector is the later sample's, as are radius and strength unless both samples
/// have their own.
class SampleCurve
{
public:
    SampleCurve() = default;
    /// `before`, `after`: the samples before `from` and after `to`, or null. `before` is used if both are given.
    /// The interpolation is linear without either, if the path turns by more than 60 degrees at the shared sample (a
    /// corner), and if its two parts there differ more than eightfold in length.
    SampleCurve(const PlacedSample& from, const PlacedSample& to, const PlacedSample* before,
                const PlacedSample* after);

    /// Returns the interpolated sample at t, 0 to 1.
    StrokeSample at(double t) const;

private:
    StrokeSample m_from, m_to;
    /// bends of the parabolas for position and direction: linear interpolation + t (1 - t) bend
    Vec3 m_bend = Vec3::Zero(), m_directionBend = Vec3::Zero();
};
} // namespace core
