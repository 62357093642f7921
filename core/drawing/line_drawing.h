#pragma once

#include "core/mesh/draw_arrays.h"

#include <optional>
#include <stop_token>

namespace core
{
/// The sides from which drawings show a model, as on a sheet: front (x right, y up), right (z left, y up), top (x
/// right, z down).
enum class DrawnSide { Front, Right, Top };
inline constexpr std::array drawnSides{DrawnSide::Front, DrawnSide::Right, DrawnSide::Top};

/// On paper: mm of the model to the right and up.
using Vec2f = Eigen::Vector2f;

/// A point of the model as side `side` shows it: to the right, up, and towards the eye.
Vec3f onPaper(DrawnSide side, const Vec3f& point);

/// A line that can be seen. Each of its points lies on an edge of the model. A closed one ends where it begins.
using DrawnLine = std::vector<Vec2f>;

/// What is seen, pixel by pixel: colours under one lamp. Rows from the top.
struct DrawnImage
{
    int width = 0, height = 0;
    Vec2f topLeft = Vec2f::Zero();                   ///< corner of the first pixel, mm
    float pixel = 0;                                 ///< mm
    std::vector<std::array<std::uint8_t, 4>> pixels; ///< sRGB; alpha 255 where the model is, else 0
};

struct DrawnView
{
    Eigen::AlignedBox2f box;         ///< of the model, mm on paper
    std::vector<DrawnLine> outlines; ///< where the surface turns away from the eye
    std::vector<DrawnLine> creases;  ///< where it bends sharply
    DrawnImage shaded;               ///< empty if it was not asked for
};

/// The model drawn from three sides, and its measures. A value: it may be handed to any thread.
struct LineDrawing
{
    std::array<DrawnView, 3> views; ///< by DrawnSide
    Box box;                        ///< mm; empty if there is no model
    double volume = 0;              ///< mm^3
    float pixel = 0;                ///< mm: where a line goes behind something, it ends within two of these
    bool hasCreases = true;         ///< false: they are left out, for they are too many
    bool isInterim = false;         ///< who made it lets a finer one follow

    const DrawnView& view(DrawnSide side) const { return views[static_cast<std::size_t>(side)]; }
};

struct DrawingDetail
{
    int pixels = 2048; ///< along the model's longest side: what hides what is decided on this grid
    bool shaded = false;
    std::size_t maxEdges = std::size_t(-1); ///< beyond so many edges in question creases are left out
};

/// Two faces that turn by more than 40 degrees meet in a crease.
inline constexpr double creaseCosine = 0.7660444431189780, halfCreaseCosine = 0.9396926207859084;

/// Nothing if it was stopped. Each line's points are exact; what is hidden is decided by a depth image per side.
/// Deterministic; each side has a thread of its own, the worker pool is left to the strokes. Cost: a few passes over
/// the faces (at a million vertices some 50 ms and, a side, 25 ms with 512 pixels, 60 ms with 2048), the rest grows
/// with the lines drawn. To draw a model again and again while it changes, use an IncrementalLineDrawing.
std::optional<LineDrawing> drawLines(const DrawArrays& model, const DrawingDetail& detail, const std::stop_token& stop);
} // namespace core
