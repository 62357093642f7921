#include "core/io/stroke/stroke_file.h"
#include "core/io/stroke/stroke_keys.h"

#include "core/sculpt/deform/alpha.h"
#include "core/sculpt/deform/brush_model.h"

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
        return "-0.0"; // "-0" would be read as a whole number, which has no sign at 0
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

void writeSample(std::ostream& out, const StrokeSample& sample)
{
    const auto& [x, y, z] = std::array{sample.position.x(), sample.position.y(), sample.position.z()};
    const Eigen::Quaterniond& turn = sample.rotation;
    out << "{\"t\":" << shortest(sample.time) << ",\"position\":" << list({x, y, z})
        << ",\"direction\":" << list({sample.direction.x(), sample.direction.y(), sample.direction.z()})
        << ",\"pressure\":" << shortest(sample.pressure)
        << ",\"rotation\":" << list({turn.x(), turn.y(), turn.z(), turn.w()});
    if (sample.radius)
        out << ",\"radius\":" << shortest(*sample.radius);
    if (sample.strength)
        out << ",\"strength\":" << shortest(*sample.strength);
    if (sample.up)
        out << ",\"up\":" << list({sample.up->x(), sample.up->y(), sample.up->z()});
    out << '}';
}

/// What is not in the settings yet is written as it was read. A model that came from no file is left out: nobody could
/// read it again.
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
        << ",\"color\":" << list({double(settings.color.r), double(settings.color.g), double(settings.color.b)});
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

std::string list(const Vec3& v)
{
    return list({v.x(), v.y(), v.z()});
}

std::string list(const Rgb& color)
{
    return list({double(color.r), double(color.g), double(color.b)});
}

/// What follows "command": in the file.
std::string keysOf(const Move& move, const std::string&)
{
    return "\"move\",\"by\":" + list(move.by);
}

std::string keysOf(const Rotate& rotate, const std::string&)
{
    const Eigen::Quaterniond& turn = rotate.rotation;
    return "\"rotate\",\"rotation\":" + list({turn.x(), turn.y(), turn.z(), turn.w()});
}

std::string keysOf(const Scale& scale, const std::string&)
{
    return "\"scale\",\"factor\":" + shortest(scale.factor);
}

std::string keysOf(const Mirror& mirror, const std::string&)
{
    return "\"mirror\",\"plane\":\"" + std::string(1, "xyz"[mirror.axis]) + "\"";
}

std::string keysOf(const Recentre&, const std::string&)
{
    return "\"recentre\"";
}

std::string keysOf(const Insert& insert, const std::string& file)
{
    const std::string keys = "\"insert\",\"file\":" + nlohmann::json(file).dump() + ",\"where\":";
    if (insert.place == Insert::Place::Centre)
        return keys + "\"centre\",\"centre\":" + list(insert.centre);
    return keys + (insert.place == Insert::Place::Beside ? "\"beside\"" : "\"as_it_is\"");
}

std::string keysOf(const Fill& fill, const std::string&)
{
    return "\"fill\",\"color\":" + list(fill.color);
}

std::string keysOf(const MaskOperation& change, const std::string&)
{
    const std::string keys =
        "\"mask\",\"how\":\"" + std::string(maskChangeNames[static_cast<std::size_t>(change.how)]) + "\"";
    return change.how == MaskOperation::Kind::Color ? keys + ",\"color\":" + list(change.color) : keys;
}

std::string keysOf(const RemeshUniformly& remesh, const std::string&)
{
    return "\"remesh\"" + (remesh.detailLength > 0 ? ",\"detail_length\":" + shortest(remesh.detailLength) : "");
}

std::string keysOf(const Symmetrize& symmetrize, const std::string&)
{
    return "\"symmetrize\",\"plane\":\"" + std::string(name(symmetrize.plane)) + "\",\"keep\":\"" +
           (symmetrize.keep == Half::Positive ? "positive" : "negative") + "\"";
}

std::string keysOf(const Reset&, const std::string&)
{
    return "\"reset\"";
}

std::string keysOf(const PlaceOnBed&, const std::string&)
{
    return "\"place_on_bed\"";
}

std::string keysOf(const FlattenBase& flatten, const std::string&)
{
    return "\"flatten_base\",\"height\":" + shortest(flatten.height);
}

void write(std::ostream& out, const FileCommand& entry)
{
    out << "{\"command\":"
        << std::visit([&](const auto& command) { return keysOf(command, entry.file); }, entry.command) << '}';
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
