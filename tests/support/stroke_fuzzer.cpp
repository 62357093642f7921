#include "tests/support/stroke_fuzzer.h"

#include "tests/support/clay.h"

#include "core/primitives/starter_models.h"
#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"

#include <cmath>

using core::Slot;
using core::Vec3;

namespace
{
/// Returns brush models with holes, overhangs and corners: a flat torus, a cube, a crystal, a bowl and a cut ring.
const std::vector<std::shared_ptr<const core::BrushModel>>& brushModels()
{
    static const std::vector<std::shared_ptr<const core::BrushModel>> models = {
        core::BrushModel::of(core::starterModel(core::Starter::Torus), {}).model,
        core::BrushModel::of(core::starterModel(core::Starter::Cube), {}).model,
        core::BrushModel::of(core::icosphere(1, 1), {}).model, core::BrushModel::of(clay::bowl(), {}).model,
        core::BrushModel::of(clay::cutRing(0.2), {}).model};
    return models;
}
} // namespace

Vec3 StrokeFuzzer::direction()
{
    while (true) {
        const Vec3 p(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        if (p.squaredNorm() > 0.01 && p.squaredNorm() <= 1)
            return p / std::sqrt(p.squaredNorm());
    }
}

Slot StrokeFuzzer::liveVertex(const core::Mesh& mesh)
{
    while (true) {
        const Slot v = static_cast<Slot>(below(mesh.slots().vertices));
        if (mesh.isVertex(v))
            return v;
    }
}

core::Stroke StrokeFuzzer::strongPull(const core::Mesh& mesh)
{
    const Slot at = liveVertex(mesh);
    core::Stroke pull;
    pull.settings.radius = uniform(0.08, 0.3);
    pull.settings.strength = uniform(4, 10);
    core::StrokeSample sample;
    sample.position = mesh.point(at).cast<double>();
    pull.samples = {sample};
    return pull;
}

core::Stroke StrokeFuzzer::stroke(const core::Mesh& mesh)
{
    const auto point = [&](Slot v) { return mesh.point(v).cast<double>(); };
    core::Box box;
    for (Slot v = 0; v < mesh.slots().vertices; ++v) {
        if (mesh.isVertex(v))
            box.extend(point(v));
    }
    const Slot start = liveVertex(mesh);
    const double edge = (point(mesh.to(mesh.outgoing(start))) - point(start)).norm();
    const double size = box.sizes().maxCoeff();
    const double least = std::min(3 * edge, 0.5 * size);

    core::Stroke stroke;
    core::StrokeSettings& s = stroke.settings;
    constexpr core::Placement placements[] = {core::Placement::Point, core::Placement::Nearest, core::Placement::Ray};
    constexpr core::Symmetry planes[] = {core::Symmetry::X, core::Symmetry::Y, core::Symmetry::Z};
    constexpr int falloffs[] = {4, 4, 4, 3, 8, 16, 0};
    s.tool = static_cast<core::Tool>(below(core::toolNames().size()));
    s.inverted = below(3) == 0;
    s.brush = below(3) == 0 ? core::BrushShape::Ray : core::BrushShape::Sphere;
    s.topology = static_cast<core::Topology>(below(4));
    s.add = below(2) == 0;
    s.fusion = below(3) != 0;
    s.symmetry = below(3) == 0 ? planes[below(3)] : core::Symmetry::None;
    s.radial = below(14) == 0 ? 2 + static_cast<int>(below(6)) : 1;
    s.color = {static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(256)), 90};
    s.place = placements[below(3)];
    // cubed below so that small radii are more frequent; std::pow would round differently in other libraries
    const double large = uniform();
    s.radius = least + (0.5 * size - least) * large * large * large;
    s.strength = below(3) == 0 ? uniform(0, 10) : uniform(0, 2);
    s.falloff = falloffs[below(7)];
    s.detail = uniform(0.3, 3);
    s.spacing = below(2) == 0 ? 0 : uniform(0.05, 1);
    s.airbrush = below(4) == 0 ? uniform(1, 20) : 0;
    s.join = below(4) == 0;
    s.anchored = below(6) == 0;

    if (below(5) == 0) {
        s.alpha = core::builtInAlpha(core::builtInAlphas()[below(core::builtInAlphas().size())]);
        s.alphaFollows = below(2) == 0;
    }
    if (below(3) != 0)
        s.model = brushModels()[below(brushModels().size())];
    // Stamps and alphas refine the mesh more, so a coarser detail keeps the cost of their dabs similar to that of
    // others.
    if (s.tool == core::Tool::Stamp || (s.alpha && core::usesAlpha(s.tool)))
        s.detail = uniform(2, 8);

    // Drag tools make several dabs of a sample; fewer samples leave other tools their share of the dabs.
    const std::uint64_t samples = 1 + below(s.spacing == 0 && !core::isDragTool(s.tool) ? 10 : 4);
    Vec3 at = point(start) + uniform(0, 0.3) * s.radius * direction();
    const Vec3 heading = direction(), view = direction();
    const double longest = core::isDragTool(s.tool) && below(4) == 0 ? 3 : 0.6;
    for (std::uint64_t i = 0; i < samples; ++i) {
        core::StrokeSample sample;
        sample.time = (s.airbrush > 0 ? 0.3 : 0.01) * static_cast<double>(i);
        sample.position = at;
        if (s.place == core::Placement::Ray || s.brush == core::BrushShape::Ray) {
            // The view is fixed if dabs are interpolated: between two views they would fill a long path.
            const bool staysPut = s.spacing != 0 || core::isDragTool(s.tool);
            sample.direction = staysPut ? view : direction();
            sample.position = at - 2 * size * sample.direction;
        }
        sample.pressure = below(2) == 0 ? 1 : uniform();
        stroke.samples.push_back(sample);
        const bool rests = s.airbrush > 0 && below(2) == 0;
        if (!rests)
            at += uniform(0, longest) * s.radius * (heading + 0.5 * direction());
    }
    return stroke;
}
