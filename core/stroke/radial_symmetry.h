#pragma once

#include "core/stroke/stroke.h"

#include <span>

namespace core
{
/// A turn about the document's Y axis, anticlockwise seen from above: z goes towards x.
struct Turn
{
    double cosine = 1, sine = 0;

    /// Makes a turn by at most a quarter, in radians. A Taylor series gives it the same bits on every machine.
    static Turn by(double angle);
    /// Makes a turn by k of n equal parts of a whole one, 0 <= k < n. Quarter turns are exact, others have the same
    /// bits on every machine.
    static Turn part(int k, int n);

    bool isNone() const { return cosine == 1; }
    /// Of a quarter turn's image of a lattice point; never -0.
    Vec3f operator*(const Vec3f& p) const;
    Vec3 operator*(const Vec3& p) const;
};

/// The dab in another sector.
Dab operator*(const Turn& turn, Dab dab);

/// The dabs for which a dab stands that is done in `settings.radial` sectors, that of its own sector first; each is
/// weaker where they (and their mirror images) overlap, so that they come to one dab where they all stand on the axis.
/// But for Layer's, which go only so high.
std::vector<Dab> sectorDabs(const StrokeSettings& settings, const Dab& dab);

/// Whether it does what one of the others does, or, with a plane of symmetry, its mirror image. `adds`: a solid, of
/// which none stands in another.
bool isAmong(std::span<const Dab> others, const Dab& dab, const StrokeSettings& settings, bool adds = false);

/// Where the dab at that place works besides: in the other sectors and, with a plane of symmetry, across it. The place
/// itself stands first.
std::vector<Vec3> imagesOf(const Vec3& place, const StrokeSettings& settings);
} // namespace core
