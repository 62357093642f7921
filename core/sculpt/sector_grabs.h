#pragma once

#include "core/sculpt/grab.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/stroke/radial_symmetry.h"

namespace core
{
/// A grab by place: so that it can be found again in another sector.
struct GrabSnapshot
{
    struct Point
    {
        Vec3f place;
        double distance; ///< from the brush's centre when it was grabbed, in mm
    };
    GrabState own{}, image{};
    std::vector<Point> ownPoints{};
    std::vector<Point> imagePoints{}; ///< none where a half stands for both sides of the mirror
    Dab dab{};                        ///< the dab before which the snapshot was taken
};

/// The grabs of a stroke, by sector; one that is not radial has one sector.
class SectorGrabs
{
public:
    explicit SectorGrabs(const VerifiedMesh& surface) : m_surface(surface) {}

    /// Releases all grabs.
    void beginStroke();
    void setSectors(std::size_t count) { m_sectors.resize(count); }

    /// A tool that selects with each dab needs no other.
    GrabPair& first() { return m_sectors[0].grabs; }
    const GrabPair& first() const { return m_sectors[0].grabs; }
    /// Returns the sector's grabs, without vertices that dabs in other sectors have removed.
    GrabPair& in(std::size_t sector, Tool tool);
    /// Drops the vertices that dabs have removed from the grabs of all sectors.
    void dropRemoved();

    /// Returns a snapshot of these grabs, before the dab.
    GrabSnapshot snapshot(const GrabPair& grabs, const Dab& dab, Symmetry symmetry) const;
    /// Gives the sector grabs of its own for the rest of the stroke, if it has none: those of the snapshot, turned.
    void separate(std::size_t sector, const GrabSnapshot& snapshot, const Turn& turn, Symmetry symmetry);
    /// Whether the sector's grabs are its own, and no image of the first sector's.
    bool isSeparate(std::size_t sector) const { return m_sectors[sector].isSeparate; }

private:
    struct Sector
    {
        GrabPair grabs;
        bool isSeparate = false;
    };
    void grabHalf(GrabPair& grabs, const GrabSnapshot& snapshot, const Turn& turn, Symmetry symmetry) const;
    void grabPoints(Region& region, const std::vector<GrabSnapshot::Point>& points, const Turn& turn) const;

    const VerifiedMesh& m_surface;
    std::vector<Sector> m_sectors{1};
};
} // namespace core
