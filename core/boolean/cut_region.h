#pragma once

#include "core/boolean/solid_parts.h"
#include "core/repair/resolution.h"

namespace core::boolean
{
/// A surface on the lattice, and the float32 coordinates of its points.
struct PlacedSurface
{
    repair::TriangleSoup surface;
    std::vector<Vec3f> points; ///< one per point, in the solids' coordinates
    double exactVolume = 0;    ///< volume before rounding, lattice units^3
};

/// The part of the solids that is cut: the faces that others meet, and the faces near these. Other faces stay as they
/// are. Precondition: the arguments of the constructor outlive this.
class CutRegion
{
public:
    CutRegion(const SolidSoup& soup, const std::vector<Fate>& fates);

    /// Cuts the region, and keeps the faces that bound the result. isDone: no faces of the region meet any more.
    /// `tolerance`: lattice units; nearer points of faces that meet are merged. With 0, points move only by rounding.
    repair::Resolution cut(double tolerance, const JobControl& control);
    /// Returns the kept faces of the region and beyond it. Points of faces that were not cut keep the coordinates of
    /// the solids bit for bit.
    PlacedSurface merged(std::span<const TriangleMesh> solids) const;

private:
    std::vector<bool> facesNearCuts() const;
    repair::LeftOut leftOut() const;

    const SolidSoup& m_soup;
    const std::vector<Fate>& m_fates;
    std::vector<bool> m_isNear;     ///< for each face, whether it is in the region
    repair::TriangleSoup m_surface; ///< the faces of the region
    double m_exactVolume = 0;       ///< part of the result's volume that is due to the region
    std::vector<Slot> m_unmoved;    ///< points of the region that no cut face has, as slots of the soup
};
} // namespace core::boolean
