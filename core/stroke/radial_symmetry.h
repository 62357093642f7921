#pragma once

#include "core/stroke/stroke.h"

#include <span>

namespace core
{
/// A rotation about the document's Y axis, anticlockwise seen from above: +z turns towards +x.
struct Turn
{
    double cosine = 1, sine = 0;

    /// Makes a turn by an angle of at most a quarter turn, in radians. Computed by a Taylor series, so that all
    /// machines give the same bits.
    static Turn by(double angle);
    /// Makes a turn by k/n of a full turn, 0 <= k < n. Quarter turns are exact; other turns have the same bits on every
    /// machine.
    static Turn part(int k, int n);

    bool isNone() const { return cosine == 1; }
    /// Returns the turned point. Exact for a quarter turn of a lattice point; never returns -0.
    Vec3f operator*(const Vec3f& p) const;
    Vec3 operator*(const Vec3& p) const;
};

/// Returns the dab, turned into another sector.
Dab operator*(const Turn& turn, Dab dab);

/// Returns the dabs of all `settings.radial` sectors, starting with the given dab. Where the dabs or their mirror
/// images overlap, each is weakened; if all are centred on the axis, together they are as strong as one dab, once the
/// caller has left out those that only repeat another (isAmong()). Dabs of Layer keep their strength, because Layer
/// limits its own height.
std::vector<Dab> sectorDabs(const StrokeSettings& settings, const Dab& dab);

/// Returns whether the dab has the same effect as one of the others or, with a plane of symmetry, as the mirror image
/// of one. `adds`: the dab adds a solid.
bool isAmong(std::span<const Dab> others, const Dab& dab, const StrokeSettings& settings, bool adds = false);

/// Returns the centres of all images of a dab at `place`: in every sector and, with a plane of symmetry, mirrored. The
/// first is `place` itself.
std::vector<Vec3> imagesOf(const Vec3& place, const StrokeSettings& settings);
} // namespace core
