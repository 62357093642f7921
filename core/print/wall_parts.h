#pragma once

#include "core/print/wall_balls.h"
#include "core/print/wall_ridges.h"
#include "core/print/wall_thickness.h"

#include <queue>

namespace core
{
/// Divides a face into parts, each with about one thickness. Cells are halved across their longest side; the cell with
/// the largest doubtful area is halved first.
class WallParts
{
public:
    struct Limits
    {
        /// A face is not divided where the matter is thicker than this, in the model's unit.
        double largestBall = 0;
        std::size_t parts = 1; ///< largest number of parts per face
        double area = 0;       ///< doubtful areas below this are ignored
    };

    /// Keeps references to all arguments but the limits.
    WallParts(const WallSurface& surface, const WallRays& rays, const WallBalls& balls, const WallRidges& ridges,
              const Limits& limits)
        : m_surface(surface)
        , m_rays(rays)
        , m_balls(balls)
        , m_ridges(ridges)
        , m_limits(limits)
    {}

    /// Returns whether the thickness at the centre of a face is not enough for the whole face. `centre`: that
    /// thickness; `reach`: distance that was searched from the centre.
    bool isLarge(Slot position, double centre, double reach) const;
    /// Returns the parts of a face; none if the thickness at the centre holds for the whole face.
    std::vector<WallPart> divide(Slot position, double centre, const JobControl& control) const;
    /// Returns whether a face is so small that its thickness is about that at its centre, which is `centre`.
    bool isEven(Slot position, double centre) const;
    /// Returns the whole face as one part if a point of it is thinner than `below`. Precondition: the face is not
    /// divided, and the thickness at its centre is `centre`.
    std::optional<WallPart> thinnerThan(Slot position, double centre, double below) const;

private:
    struct Cell
    {
        WallCell cell;
        double share = 1;
        std::array<double, 4> atPlaces = {}; ///< thickness in the middle and near each corner
        double least = 0, most = 0;
        Vec3 thinnest = Vec3::Zero();
        double doubt = 0; ///< area whose thickness is uncertain
        std::size_t number = 0;

        bool operator<(const Cell& other) const // the queue's first element is its greatest
        {
            return doubt != other.doubt ? doubt < other.doubt : number > other.number;
        }
    };

    /// Start diameters for the search in the whole cell and at its places.
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
    const WallRidges& m_ridges;
    Limits m_limits;
};
} // namespace core
