// The table of synonyms.

#include "ui/actions/synonyms.h"

#include <QCoreApplication>

#include <algorithm>

namespace ui
{
namespace
{
struct Row
{
    const char* id;    ///< action id
    const char* words; ///< untranslated, separated by commas; a translation may have more or fewer words
};

struct Synonyms
{
    Q_DECLARE_TR_FUNCTIONS(ui::Synonyms)

public:
    // clang-format off
    static constexpr Row rows[] = {
        {"tool.pull", QT_TR_NOOP("add, raise, build, extrude, bump")},
        {"tool.push", QT_TR_NOOP("carve, dig, dent, hole, sink")},
        {"tool.inflate", QT_TR_NOOP("swell, blow up, fatten")},
        {"tool.clay", QT_TR_NOOP("build up, fill, strips")},
        {"tool.flatten", QT_TR_NOOP("plane, level")},
        {"tool.scrape", QT_TR_NOOP("plane, polish, shave")},
        {"tool.smooth", QT_TR_NOOP("blur, relax, soften, even")},
        {"tool.pinch", QT_TR_NOOP("squeeze, sharpen, gather")},
        {"tool.crease", QT_TR_NOOP("line, groove, wrinkle")},
        {"tool.grab", QT_TR_NOOP("move, drag, pull out")},
        {"tool.snake", QT_TR_NOOP("horn, tail, tentacle, handle")},
        {"tool.twist", QT_TR_NOOP("rotate, turn, screw")},
        {"tool.stamp", QT_TR_NOOP("imprint, pattern, hollow")},
        {"tool.paint", QT_TR_NOOP("color, colour, draw")},
        {"tool.mask", QT_TR_NOOP("protect, freeze, lock")},
        {"mask.clear", QT_TR_NOOP("eraser, unfreeze, unlock")},
        {"brush.larger", QT_TR_NOOP("size, bigger, wider, thicker")},
        {"brush.smaller", QT_TR_NOOP("size, thinner, finer")},
        {"brush.radius", QT_TR_NOOP("size, bigger, diameter")},
        {"brush.strength", QT_TR_NOOP("power, intensity, pressure")},
        {"brush.invert", QT_TR_NOOP("opposite, subtract, eraser")},
        {"brush.add", QT_TR_NOOP("sphere, primitive, eye")},
        {"brush.presets", QT_TR_NOOP("brushes, library")},
        {"brush.steady", QT_TR_NOOP("lazy, stabilizer, tremor")},
        {"turntable.on", QT_TR_NOOP("pottery, lathe, wheel, spin")},
        {"symmetry.on", QT_TR_NOOP("mirror, both sides, half")},
        {"topology.fusion", QT_TR_NOOP("join, merge, union, boolean")},
        {"topology.uniform", QT_TR_NOOP("remesh, voxel, even")},
        {"edit.undo", QT_TR_NOOP("back, mistake, eraser")},
        {"edit.lastStroke", QT_TR_NOOP("adjust, change, correct")},
        {"edit.preferences", QT_TR_NOOP("settings, options, language, dark, pen, pressure, tablet")},
        {"model.scale", QT_TR_NOOP("size, bigger, smaller, resize, unit")},
        {"model.mirror", QT_TR_NOOP("flip, reflect")},
        {"model.remesh", QT_TR_NOOP("voxel, resolution, subdivide, triangles")},
        {"model.insert", QT_TR_NOOP("boolean, union, difference, merge, combine")},
        {"model.insertPrimitive", QT_TR_NOOP("boolean, hole, drill, cube, sphere, lathe")},
        {"model.placeSolid", QT_TR_NOOP("primitive, cube, sphere, cylinder, drag out")},
        {"model.tube", QT_TR_NOOP("pipe, rope, tail, arm, horn, spline")},
        {"model.flattenBase", QT_TR_NOOP("cut, bottom, stand, trim")},
        {"area.trim", QT_TR_NOOP("cut, slice, crop, scissors, knife, trim")},
        {"area.split", QT_TR_NOOP("cut, slice, divide, knife, lasso")},
        {"area.mask", QT_TR_NOOP("lasso, select, box, polygon")},
        {"area.hide", QT_TR_NOOP("lasso, select, box, polygon")},
        {"model.printCheck", QT_TR_NOOP("watertight, thickness, overhang, hollow, support")},
        {"file.revert", QT_TR_NOOP("recover, restore, reload")},
        {"file.exportFor", QT_TR_NOOP("stl, slicer, reduce, decimate")},
        {"file.timeLapse", QT_TR_NOOP("video, film, animation")},
        {"view.frame", QT_TR_NOOP("zoom, fit, center, lost")},
        {"view.cavity", QT_TR_NOOP("shadow, contrast, relief")},
        {"view.wireframe", QT_TR_NOOP("mesh, polygons, edges")},
        {"view.orthographic", QT_TR_NOOP("parallel, isometric")},
        {"background.light", QT_TR_NOOP("bright, daylight")},
        {"vr.enter", QT_TR_NOOP("VR, headset, goggles, vive")},
        {"help.guide", QT_TR_NOOP("manual, documentation")},
        {"help.lessons", QT_TR_NOOP("tutorial, course, learn")},
    };
    // clang-format on
};
} // namespace

QStringList synonymsOf(QStringView id)
{
    const auto* found =
        std::ranges::find_if(Synonyms::rows, [id](const Row& row) { return id == QLatin1StringView(row.id); });
    return found == std::end(Synonyms::rows) ? QStringList() : Synonyms::tr(found->words).split(QStringLiteral(", "));
}
} // namespace ui
