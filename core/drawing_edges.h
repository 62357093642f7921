#pragma once

#include "line_drawing.h"

namespace core
{
/// An edge that may be a line of a drawing.
struct DrawingEdge
{
    Slot a, b; ///< vertices
    std::array<Slot, 2> faces;
    std::uint8_t outlineIn; ///< bit by DrawnSide: one face looks to the eye, the other does not
    bool isCrease;
};

/// The model as drawings see it.
struct DrawingScan
{
    std::vector<std::uint8_t> facing; ///< by face slot; bit by DrawnSide: it looks to the eye. 0 of a free face
    std::vector<DrawingEdge> edges;   ///< by their vertices
    Box box;
    double volume = 0;
    bool hasCreases = true; ///< false: there were more than `mostEdges`
};

/// Nothing if it was stopped. The signs of facing are exact for vertices on the lattice.
std::optional<DrawingScan> scanForDrawing(const DrawArrays& model, std::size_t mostEdges, const std::stop_token& stop);

Vec3 drawnNormal(const DrawArrays& model, Slot face); ///< twice the face's area long
} // namespace core
