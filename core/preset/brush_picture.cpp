// Draws the picture of a brush preset: makes a ball, roughens it if the tool smooths, does one stroke over its front,
// and draws the result.

#include "core/preset/brush_picture.h"

#include "core/mesh/mesh_builder.h"
#include "core/primitives/starter_models.h"
#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/sculptor.h"

#include <algorithm>
#include <cmath>

namespace core
{
namespace
{
constexpr double ballRadius = 50;
constexpr double extent = 112; ///< width and height of the pictured area, mm
/// The brush's radius is magnified for the small picture, and clamped to minRadius to maxRadius, mm.
constexpr double magnification = 1.6, minRadius = 8, maxRadius = 32;
constexpr double draggedRadius = 0.7 * ballRadius; ///< radius of an anchored dab, mm
constexpr double printStep = 1; ///< smallest spacing, in radii, at which dabs do not merge into a line
constexpr int samples = 48;
constexpr double pi = 3.14159265358979323846;

bool evensOut(Tool tool)
{
    return tool == Tool::Smooth || tool == Tool::Flatten || tool == Tool::Scrape;
}

void play(Sculptor& sculptor, const StrokeSettings& settings, const std::vector<StrokeSample>& path,
          const std::stop_token& stop)
{
    sculptor.beginStroke(settings);
    for (const StrokeSample& sample : path)
        if (!stop.stop_requested())
            sculptor.addSample(sample);
    sculptor.endStroke();
}

/// Returns rays from the front that follow a wave from left to right. `tapers`: the pressure rises and falls along the
/// stroke.
std::vector<StrokeSample> wave(bool tapers)
{
    std::vector<StrokeSample> path;
    for (int i = 0; i <= samples; ++i) {
        const double at = double(i) / samples;
        StrokeSample sample;
        sample.time = at;
        sample.position =
            Vec3(ballRadius * (1.3 * at - 0.65), 0.3 * ballRadius * std::sin(2 * pi * at), 4 * ballRadius);
        sample.direction = -Vec3::UnitZ();
        if (tapers)
            sample.pressure = 0.25 + 0.75 * std::sin(pi * at);
        path.push_back(sample);
    }
    return path;
}

/// Returns a path from the ball's surface outwards, to the right and up.
std::vector<StrokeSample> horn()
{
    std::vector<StrokeSample> path;
    const Vec3 from = ballRadius * Vec3(0.35, 0.35, 0.87), way = ballRadius * Vec3(0.45, 0.42, 0.1);
    for (int i = 0; i <= samples; ++i) {
        const double at = double(i) / samples;
        StrokeSample sample;
        sample.time = at;
        sample.position = from + at * way + 0.12 * ballRadius * std::sin(pi * at) * Vec3(-1, 1, 0);
        path.push_back(sample);
    }
    return path;
}

/// Returns two rays: one through the middle, and one to where an anchored dab of that radius is dragged.
std::vector<StrokeSample> drag(double radius)
{
    std::vector<StrokeSample> path(2);
    path[0].position = Vec3(0, 0, 4 * ballRadius);
    path[1].position = path[0].position + radius * Vec3(0.5, 0.87, 0);
    path[0].direction = path[1].direction = -Vec3::UnitZ();
    return path;
}

/// Covers the front of the ball evenly with bumps (Vogel's spiral).
void roughen(Sculptor& sculptor, const std::stop_token& stop)
{
    constexpr int bumps = 110;
    constexpr double goldenAngle = 2.399963229728653;
    StrokeSettings settings;
    settings.tool = Tool::Inflate;
    settings.place = Placement::Ray;
    settings.radius = 5.5;
    settings.strength = 3;
    std::vector<StrokeSample> path;
    for (int i = 0; i < bumps; ++i) {
        const double distance = 0.93 * ballRadius * std::sqrt((i + 0.5) / bumps);
        StrokeSample sample;
        sample.position =
            Vec3(distance * std::cos(i * goldenAngle), distance * std::sin(i * goldenAngle), 4 * ballRadius);
        sample.direction = -Vec3::UnitZ();
        path.push_back(sample);
    }
    play(sculptor, settings, path, stop);
}

StrokeSettings onBall(StrokeSettings brush)
{
    const bool drags = isDragTool(brush.tool);
    brush.place = drags ? Placement::Point : Placement::Ray;
    brush.brush = BrushShape::Sphere;
    brush.topology = Topology::Refine;
    brush.symmetry = Symmetry::None;
    brush.radial = 1;
    brush.radius = std::clamp(magnification * brush.radius, minRadius, maxRadius);
    brush.spacing = drags ? 0 : brush.spacing;
    brush.airbrush = 0;
    brush.add = false;
    brush.model = nullptr;
    return brush;
}

ThumbnailView frontView(int pixels)
{
    ThumbnailView view;
    view.extent = extent;
    view.width = view.height = pixels;
    return view;
}
} // namespace

std::optional<ModelThumbnail> drawBrush(const StrokeSettings& brush, int pixels, const std::stop_token& stop)
{
    Sculptor sculptor(buildMesh(starterModel(Starter::Ball)).mesh);
    if (evensOut(brush.tool))
        roughen(sculptor, stop);
    // Separate dabs, and Layer, are drawn with the same pressure everywhere.
    const bool isEven = brush.spacing >= printStep || brush.tool == Tool::Layer;
    const std::vector<StrokeSample> path = isAnchored(brush)        ? drag(draggedRadius)
                                           : isDragTool(brush.tool) ? horn()
                                                                    : wave(!isEven);
    play(sculptor, onBall(brush), path, stop);
    if (stop.stop_requested())
        return std::nullopt;
    return drawThumbnail(extractMesh(sculptor.mesh()), frontView(pixels), stop);
}
} // namespace core
