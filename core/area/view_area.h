#pragma once

#include "core/geometry/geometry.h"
#include "core/stroke/symmetry_plane.h"

#include <optional>
#include <vector>

namespace core
{
/// An area of the view: the points that are seen within a closed curve, or beside it. Each corner of the curve stands
/// for a straight line: from the eye, or, without one, along the direction of the view. Where the curve crosses or
/// overlaps itself, every point that it goes around is inside (non-zero winding rule). What lies behind the eye is
/// beside the curve. Lengths are in the document's unit.
struct ViewArea
{
    enum class Side { Inside, Outside };
    static constexpr std::size_t maxCorners = 10'000; ///< that stroke files may have

    std::vector<Vec3> outline;       ///< corners; all in front of the eye, if there is one
    Vec3 direction = -Vec3::UnitZ(); ///< direction of the view, any length but zero
    std::optional<Vec3> eye;         ///< set if the view is a perspective one
    Side side = Side::Inside;
    bool isFrontOnly = false;           ///< only what is seen first; each command says what that means
    Symmetry symmetry = Symmetry::None; ///< the curve's mirror image about this plane counts as well
};
} // namespace core
