#pragma once

#include "core/analysis/wall_balls.h"
#include "core/analysis/wall_thickness.h"

#include <queue>

namespace core
{
/// Divides a face into parts of about one thickness each: halves of halves across the longest side, those first of
/// which the most area is in doubt.
class WallParts
{
public:
    struct Limits
    {
        double largestBall = 0; ///< where the matter is thicker, a face is not divided
        std::size_t parts = 1;  ///< of a face, at most
        double area = 0;        ///< below which a doubt does not count
    };

    /// Keeps references.
    WallParts(const WallSurface& surface, const WallRays& rays, const WallBalls& balls, const Limits& limits)
        : m_surface(surface)
        , m_rays(rays)
        , m_balls(balls)
        , m_limits(limits)
    {}

    /// Returns whether a face is too large for its centre to speak for it. `centre`: the thickness there; `reach`: how
    /// far away the centre has seen.
    bool isLarge(Slot position, double centre, double reach) const;
    /// Returns the parts of a face; none if the centre speaks for all of it.
    std::vector<WallPart> divide(Slot position, double centre, const JobControl& control) const;

private:
    struct Cell
    {
        WallCell cell;
        double share = 1;
        std::array<double, 4> atPlaces = {}; ///< in its middle, and near its corners
        double least = 0, most = 0;
        Vec3 thinnest = Vec3::Zero();
        double doubt = 0; ///< area about whose thickness too little is known
        std::size_t number = 0;

        bool operator<(const Cell& other) const // the queue's first is its greatest
        {
            return doubt != other.doubt ? doubt < other.doubt : number > other.number;
        }
    };

    /// The diameters that the search begins with.
    struct Starts
    {
        double inCell, atPlaces;
    };

    double radiusOf(Slot position) const;
    Cell measured(Slot position, const WallCell& cell, double share, const Starts& starts) const;
    double doubtOf(const Cell& cell, Slot position, double hidden) const;
    double even() const;
    void addParts(Slot position, const Cell& cell, std::vector<WallPart>& parts) const;
    WallPart partOf(Slot position, const Cell& cell) const;

    const WallSurface& m_surface;
    const WallRays& m_rays;
    const WallBalls& m_balls;
    Limits m_limits;
};
} // namespace core
