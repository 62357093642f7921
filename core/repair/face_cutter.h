#pragma once

#include "core/repair/exact_point.h"
#include "core/repair/triangle_soup.h"

#include <span>

namespace core::repair
{
struct FacePiece
{
    Triangle corners; ///< indices into FacePieces::points
    int jump;         ///< see ArrangedFace::jump
};

/// A face cut along the lines at which others meet it.
struct FacePieces
{
    ExactPoints points; ///< the face's own corners first
    std::vector<FacePiece> pieces;
    /// The other faces that are in the plane of this face and cover some of it, ascending.
    std::vector<Slot> upon;
};

/// Cuts a face, exactly. Precondition: `others` contains all faces that meet it, ascending, and all faces have area.
/// Thread: any. Cost: quadratic in the number of lines.
FacePieces cutFace(const TriangleSoup& surface, Slot face, std::span<const Slot> others);
} // namespace core::repair
