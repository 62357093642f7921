#pragma once

#include "core/repair/exact_point.h"
#include "core/repair/triangle_soup.h"

#include <span>

namespace core::repair
{
struct FacePiece
{
    Triangle corners; ///< of FacePieces::points
    int jump;         ///< as in ArrangedFace
};

/// A face cut along the lines at which others meet it.
struct FacePieces
{
    ExactPoints points; ///< the face's own corners first
    std::vector<FacePiece> pieces;
    std::vector<Slot> upon; ///< those of the others that lie in its plane and cover some of it, ascending
};

/// Exact. `others`: all the faces that meet this one, ascending; all have area. Cost grows
/// with the square of the lines. Any thread.
FacePieces cutFace(const TriangleSoup& surface, Slot face, std::span<const Slot> others);
} // namespace core::repair
