#include "core/io/stroke/stroke_file.h"
#include "core/io/stroke/stroke_keys.h"

#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"
#include "core/util/overloaded.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <ostream>

namespace core
{
namespace
{
std::string shortest(double value)
{
    if (value == 0 && std::signbit(value))
        return "-0.0"; // the JSON parser would read "-0" as an integer and lose the sign
    std::array<char, 32> text;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return std::string(text.data(), end);
}

std::string list(std::initializer_list<double> values)
{
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "[" : ",") + shortest(value);
    return text + "]";
}

std::string list(const Vec3& v)
{
    return list({v.x(), v.y(), v.z()});
}

std::string list(const Rgb& color)
{
    return list({double(color.r), double(color.g), double(color.b)});
}

std::string list(const Eigen::Quaterniond& turn)
{
    return list({turn.x(), turn.y(), turn.z(), turn.w()});
}

std::string list(const std::vector<PartId>& parts)
{
    return nlohmann::json(parts).dump();
}

/// Returns the text as JSON; bytes that are no UTF-8 are replaced.
std::string quoted(const std::string& text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void writeSample(std::ostream& out, const StrokeSample& sample)
{
    out << "{\"t\":" << shortest(sample.time) << ",\"position\":" << list(sample.position)
        << ",\"direction\":" << list(sample.direction) << ",\"pressure\":" << shortest(sample.pressure)
        << ",\"rotation\":" << list(sample.rotation);
    if (sample.radius)
        out << ",\"radius\":" << shortest(*sample.radius);
    if (sample.strength)
        out << ",\"strength\":" << shortest(*sample.strength);
    if (sample.up)
        out << ",\"up\":" << list(*sample.up);
    out << '}';
}

/// Writes the alpha and the model. A file that is not loaded into the settings yet is written with the path that was
/// read. A model that has no file is left out, because it could not be read again.
void writeShapes(std::ostream& out, const Stroke& stroke)
{
    const StrokeSettings& settings = stroke.settings;
    StrokeNeed alpha = stroke.alpha, model = stroke.model;
    if (settings.alpha)
        alpha = {settings.alpha->source(), settings.alpha->isBuiltIn() ? "" : settings.alpha->fingerprint()};
    if (settings.model)
        model = {settings.model->source(), settings.model->fingerprint()};
    const auto writeNeed = [&](const StrokeNeed& need, const char* key) {
        if (need.file.empty())
            return;
        out << ",\"" << key << "\":" << nlohmann::json(need.file).dump();
        if (!need.fingerprint.empty())
            out << ",\"" << key << "_hash\":\"" << need.fingerprint << '"';
    };
    writeNeed(alpha, "alpha");
    if (settings.alphaFollows)
        out << ",\"alpha_follows\":true";
    writeNeed(model, "model");
}

void write(std::ostream& out, const Stroke& stroke)
{
    const StrokeSettings& settings = stroke.settings;
    out << "{\"tool\":\"" << name(settings.tool) << "\",\"brush\":\"" << name(settings.brush)
        << "\",\"radius\":" << shortest(settings.radius) << ",\"strength\":" << shortest(settings.strength)
        << ",\"falloff\":" << settings.falloff << ",\"detail\":" << shortest(settings.detail) << ",\"topology\":\""
        << name(settings.topology) << "\",\"fusion\":" << (settings.fusion ? "true" : "false") << ",\"symmetry\":\""
        << name(settings.symmetry) << "\",\"spacing\":" << shortest(settings.spacing) << ",\"place\":\""
        << name(settings.place) << "\",\"add\":" << (settings.add ? "true" : "false")
        << ",\"color\":" << list(settings.color);
    if (settings.part != 0)
        out << ",\"part\":" << settings.part;
    if (settings.join)
        out << ",\"join\":true";
    if (settings.anchored)
        out << ",\"anchored\":true";
    if (settings.airbrush > 0)
        out << ",\"airbrush\":" << shortest(settings.airbrush);
    if (settings.radial > 1)
        out << ",\"radial\":" << settings.radial;
    if (settings.inverted)
        out << ",\"invert\":true";
    if (settings.detailLength > 0)
        out << ",\"detail_length\":" << shortest(settings.detailLength);
    writeShapes(out, stroke);
    out << ",\"samples\":[";
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        out << (i == 0 ? "\n" : ",\n");
        writeSample(out, stroke.samples[i]);
    }
    out << "]}";
}

/// Returns the keys of an area, each after a comma. `sideKey`: the key that tells the side.
std::string keysOf(const ViewArea& area, std::string_view sideKey)
{
    std::string text = R"(,"outline":[)";
    for (std::size_t i = 0; i < area.outline.size(); ++i)
        text += (i == 0 ? "" : ",") + list(area.outline[i]);
    text += R"(],"along":)" + list(area.direction);
    text += area.eye ? R"(,"eye":)" + list(*area.eye) : "";
    text += ",\"" + std::string(sideKey) + (area.side == ViewArea::Side::Inside ? R"(":"inside")" : R"(":"outside")");
    text += R"(,"symmetry":")" + std::string(name(area.symmetry)) + '"';
    return area.isFrontOnly ? text + R"(,"front":true)" : text;
}

std::string colorKey(const std::optional<Rgb>& color)
{
    return color ? R"(,"color":)" + list(*color) : std::string();
}

std::string keysOf(const Trim& trim)
{
    return R"("trim")" + keysOf(trim.area, "remove") + colorKey(trim.color);
}

std::string keysOf(const MaskArea& mask)
{
    return R"("mask_area")" + keysOf(mask.area, "side") + (mask.isErasing ? R"(,"invert":true)" : "");
}

std::string keysOf(const HideArea& hide)
{
    return R"("hide_area")" + keysOf(hide.area, "side");
}

std::string keysOf(const SplitPart& split)
{
    return R"("split_part")" + keysOf(split.area, "side") + R"(,"name":)" + quoted(split.name) + colorKey(split.color);
}

std::string keysOf(const Primitive& primitive)
{
    std::string text = R"("primitive":")" + std::string(name(primitive.kind)) + '"';
    for (const Primitive::Measure measure : measuresOf(primitive.kind))
        text += ",\"" + std::string(name(measure)) + "\":" + shortest(primitive.length(measure));
    if (primitive.kind == Primitive::Kind::Lathe) {
        std::string points;
        for (const ProfilePoint& p : primitive.profile)
            points += (points.empty() ? "" : ",") + list({p.radius, p.height});
        text += R"(,"profile":[)" + points + ']';
    }
    if (primitive.kind == Primitive::Kind::Tube) {
        std::string points;
        for (const TubePoint& p : primitive.path)
            points += (points.empty() ? "" : ",") + list({p.position.x(), p.position.y(), p.position.z(), p.radius});
        text += R"(,"path":[)" + points + ']';
    }
    if (primitive.edge > 0)
        text += R"(,"edge_length":)" + shortest(primitive.edge);
    if (!hasAxis(primitive.kind) || primitive.axis == Vec3::UnitY())
        return text;
    for (int axis = 0; axis < 3; ++axis) {
        if (primitive.axis == Vec3::Unit(axis))
            return text + R"(,"axis":")" + std::string(axisNames[static_cast<std::size_t>(axis)]) + '"';
    }
    return text + R"(,"along":)" + list(primitive.axis);
}

std::string keysOf(const Transform& transform)
{
    std::string text = R"("transform","centre":)" + list(transform.centre);
    if (!transform.by.isZero(0))
        text += R"(,"by":)" + list(transform.by);
    if (transform.rotation != Eigen::Quaterniond::Identity())
        text += R"(,"rotation":)" + list(transform.rotation);
    if (transform.scale == Vec3::Ones())
        return text;
    text += R"(,"scale":)" + list(transform.scale);
    return transform.scaleAxes == Eigen::Quaterniond::Identity()
               ? text
               : text + R"(,"scale_axes":)" + list(transform.scaleAxes);
}

std::string keysOf(const Insert& insert, const std::string& file)
{
    std::string text =
        R"("insert",)" + (insert.primitive ? keysOf(*insert.primitive) : R"("file":)" + nlohmann::json(file).dump());
    text += R"(,"where":")" + std::string(placeNames[static_cast<std::size_t>(insert.place)]) + '"';
    if (insert.place == Insert::Place::Centre || insert.place == Insert::Place::Floor)
        text += R"(,"centre":)" + list(insert.centre);
    if (insert.combination != Insert::Combination::Apart)
        text += R"(,"combine":")" + std::string(combinationNames[static_cast<std::size_t>(insert.combination)]) + '"';
    if (insert.combination == Insert::Combination::Part && !insert.name.empty())
        text += R"(,"name":)" + quoted(insert.name);
    if (insert.symmetry != Symmetry::None)
        text += R"(,"symmetry":")" + std::string(name(insert.symmetry)) + '"';
    return text;
}

/// Returns the text that follows "command": in the file, up to the closing brace.
std::string keysOf(const FileCommand& entry)
{
    using Text = std::string;
    const Overloaded keys{
        [](const Move& move) { return R"("move","by":)" + list(move.by); },
        [](const Rotate& rotate) { return R"("rotate","rotation":)" + list(rotate.rotation); },
        [](const Scale& scale) { return R"("scale","factor":)" + shortest(scale.factor); },
        [](const Mirror& mirror) { return Text(R"("mirror","plane":")") + "xyz"[mirror.axis] + '"'; },
        [](const Recentre&) { return Text(R"("recentre")"); },
        [&](const Insert& insert) { return keysOf(insert, entry.file); },
        [](const Fill& fill) { return R"("fill","color":)" + list(fill.color); },
        [](const MaskOperation& mask) {
            const Text text = R"("mask","how":")" + Text(maskChangeNames[static_cast<std::size_t>(mask.how)]) + '"';
            return mask.how == MaskOperation::Kind::Color ? text + R"(,"color":)" + list(mask.color) : text;
        },
        [](const RemeshUniformly& remesh) {
            const Text length = R"(,"detail_length":)" + shortest(remesh.detailLength);
            return R"("remesh")" + (remesh.detailLength > 0 ? length : Text());
        },
        [](const Symmetrize& symmetrize) {
            return R"("symmetrize","plane":")" + Text(name(symmetrize.plane)) + R"(","keep":")" +
                   (symmetrize.keep == Half::Positive ? "positive" : "negative") + '"';
        },
        [](const Reset&) { return Text(R"("reset")"); },
        [](const PlaceOnBed&) { return Text(R"("place_on_bed")"); },
        [](const FlattenBase& flatten) { return R"("flatten_base","height":)" + shortest(flatten.height); },
        [](const EditPart& edit) {
            return R"("edit_part","name":)" + quoted(edit.name) + R"(,"locked":)" + (edit.isLocked ? "true" : "false") +
                   (edit.tag ? R"(,"tag":)" + list(*edit.tag) : Text()) +
                   (edit.position
                        ? R"(,"list_position":)" + std::to_string(std::min(*edit.position, PartList::maxParts))
                        : Text());
        },
        [](const ShowParts& show) { return R"("show_parts","parts":)" + list(show.visible); },
        [](const DuplicatePart& duplicate) { return R"("duplicate_part","name":)" + quoted(duplicate.name); },
        [](const DeletePart&) { return Text(R"("delete_part")"); },
        [](const SeparatePart&) { return Text(R"("separate_part")"); },
        [](const CombineParts& combination) {
            constexpr std::string_view operations[] = {"union", "subtract", "intersect"};
            return R"("combine_parts","operation":")" +
                   Text(operations[static_cast<std::size_t>(combination.operation)]) + R"(","parts":)" +
                   list(combination.others);
        },
        [](const Hide& hide) {
            constexpr std::string_view words[] = {"masked", "unmasked", "none", "no_part"};
            return R"("hide","what":")" + Text(words[static_cast<std::size_t>(hide.what)]) + '"';
        },
        [](const auto& command) { return keysOf(command); },
    };
    return std::visit(keys, entry.command);
}

void write(std::ostream& out, const FileCommand& entry)
{
    out << "{\"command\":" << keysOf(entry);
    if (entry.part != 0)
        out << ",\"part\":" << entry.part;
    out << '}';
}
} // namespace

void writeStrokes(std::ostream& out, const std::vector<FileEntry>& entries)
{
    out << R"({"format":"fettle-strokes","version":1,"strokes":[)";
    for (std::size_t i = 0; i < entries.size(); ++i) {
        out << (i == 0 ? "\n" : ",\n");
        std::visit([&](const auto& entry) { write(out, entry); }, entries[i]);
    }
    out << "]}\n";
}
} // namespace core
