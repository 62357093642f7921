#pragma once

#include "core/mesh/draw_arrays.h"

#include <optional>
#include <stop_token>

namespace core
{
/// The three views of a technical drawing: front (x to the right, y up), right (z to the left, y up), top (x to the
/// right, z down).
enum class DrawnSide { Front, Right, Top };
inline constexpr std::array drawnSides{DrawnSide::Front, DrawnSide::Right, DrawnSide::Top};

/// A point in the plane of a view: mm of the model, to the right and up.
using Vec2f = Eigen::Vector2f;

/// Converts a point of the model to the view from `side`: mm to the right, up, and towards the eye.
Vec3f onPaper(DrawnSide side, const Vec3f& point);

/// A visible line. Each of its points is on an edge of the model. A closed line ends at its first point.
using DrawnLine = std::vector<Vec2f>;

/// A shaded picture of the model under one lamp. Rows from the top.
struct DrawnImage
{
    int width = 0, height = 0;
    Vec2f topLeft = Vec2f::Zero();                   ///< top left corner of the picture in the view's plane, mm
    float pixel = 0;                                 ///< size of a pixel, mm
    std::vector<std::array<std::uint8_t, 4>> pixels; ///< sRGB; alpha is 255 on the model and 0 elsewhere
};

struct DrawnView
{
    Eigen::AlignedBox2f box;         ///< bounding box of the model in the view's plane, mm
    std::vector<DrawnLine> outlines; ///< lines where the surface turns away from the eye
    std::vector<DrawnLine> creases;  ///< lines where the surface bends by more than the crease angle
    DrawnImage shaded;               ///< empty unless it was requested
};

/// The model drawn from three sides, and its size. It shares no data and may be passed between threads.
struct LineDrawing
{
    std::array<DrawnView, 3> views; ///< indexed by DrawnSide
    Box box;                        ///< bounding box of the model, mm; empty if there is no model
    double volume = 0;              ///< volume of the model, mm^3
    /// Pixel size of the hidden-line test, mm; a line that is partly hidden ends within two pixels of the exact place.
    float pixel = 0;
    bool hasCreases = true; ///< false: creases were omitted because there were too many
    bool isInterim = false; ///< set by the caller if a finer drawing will follow

    const DrawnView& view(DrawnSide side) const { return views[static_cast<std::size_t>(side)]; }
};

struct DrawingDetail
{
    int pixels = 2048; ///< resolution of the hidden-line test along the model's longest side
    bool shaded = false;
    std::size_t maxEdges = std::size_t(-1); ///< limit on possible outlines and creases; beyond it creases are omitted
};

/// An edge is a crease if its faces meet at an angle of more than 40 degrees between their normals.
inline constexpr double creaseCosine = 0.7660444431189780, halfCreaseCosine = 0.9396926207859084;

/// Draws the model from three sides. Returns nothing if it was stopped. The points of lines are exact; hidden parts are
/// found with one depth image for each side. Deterministic. Each side uses a thread of its own, because the worker pool
/// is reserved for strokes. Cost: a few passes over the faces, and then proportional to the lines drawn. A million
/// vertices take about 50 ms, plus 25 ms a side with 512 pixels or 60 ms with 2048. Use IncrementalLineDrawing to
/// redraw a changing model.
std::optional<LineDrawing> drawLines(const DrawArrays& model, const DrawingDetail& detail, const std::stop_token& stop);
} // namespace core
