#pragma once

#include "core/sculpt/grab.h"
#include "core/sculpt/verify/verified_mesh.h"
#include "core/stroke/radial_symmetry.h"

namespace core
{
/// A copy of a grab that identifies vertices by position, so that the grab can be rebuilt in another sector.
struct GrabSnapshot
{
    struct Point
    {
        Vec3f place;
        double distance; ///< distance from the brush's centre at the time of grabbing, mm
    };
    GrabState own{}, image{};
    std::vector<Point> ownPoints{};
    std::vector<Point> imagePoints{}; ///< empty if GrabState::isHalf: then ownPoints are the points of both sides
    Dab dab{};                        ///< the dab before which the snapshot was taken
};

/// The grabs of a stroke, one pair per sector. A stroke without radial symmetry has one sector.
class SectorGrabs
{
public:
    explicit SectorGrabs(const VerifiedMesh& surface) : m_surface(surface) {}

    /// Releases all grabs.
    void beginStroke();
    void setSectors(std::size_t count) { m_sectors.resize(count); }

    /// Returns the grabs of the first sector. A tool that selects again with each dab uses only these.
    GrabPair& first() { return m_sectors[0].grabs; }
    const GrabPair& first() const { return m_sectors[0].grabs; }
    /// Returns the sector's grabs, after dropping the vertices that dabs in other sectors have removed.
    GrabPair& in(std::size_t sector, Tool tool);
    /// Drops vertices that dabs have removed from the mesh. Does so for the grabs of all sectors.
    void dropRemoved();

    /// Returns a snapshot of these grabs. To be taken before the dab is applied.
    GrabSnapshot snapshot(const GrabPair& grabs, const Dab& dab, Symmetry symmetry) const;
    /// Gives the sector its own grabs for the rest of the stroke, unless it has them already: the snapshot's grabs,
    /// turned.
    void separate(std::size_t sector, const GrabSnapshot& snapshot, const Turn& turn, Symmetry symmetry);
    /// Returns whether the sector has its own grabs, which are no longer exact images of the first sector's.
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
