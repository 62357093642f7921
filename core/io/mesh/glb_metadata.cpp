#include "core/io/mesh/glb_metadata.h"

#include "core/io/mesh/binary.h"
#include "core/io/mesh/gltf_document.h"
#include "core/io/mesh/palette.h"

#include "core/io/stroke/stroke_file.h"
#include "core/sculpt/deform/alpha.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace core::io
{
namespace
{
using Json = nlohmann::json;

constexpr const char* extensionName = "FETTLE_document";
constexpr int version = 1;
/// Largest JSON chunk that is read, bytes. Fettle writes a few thousand bytes, and for each part about a thousand;
/// another program that rewrote the file may have added more.
constexpr std::size_t maxJson = 1 << 23;
/// Largest absolute exponent of a lattice that is accepted; imports stay well below it.
constexpr int maxExponent = 64;
constexpr double farthest = 1e9; ///< largest coordinate or length that is accepted, mm

nlohmann::ordered_json jsonOf(const SavedView& view)
{
    return {{"target", {view.target.x(), view.target.y(), view.target.z()}},
            {"distance", view.distance},
            {"yaw", view.yaw},
            {"pitch", view.pitch},
            {"orthographic", view.orthographic}};
}

/// Returns the brush as a stroke of a stroke file. Files that it uses are omitted, because whoever receives the model
/// does not have them.
nlohmann::ordered_json jsonOf(StrokeSettings brush)
{
    if (brush.alpha && !brush.alpha->isBuiltIn())
        brush.alpha = nullptr;
    brush.model = nullptr;
    std::ostringstream text;
    writeStrokes(text, {Stroke{std::move(brush), {}, {}, {}}});
    nlohmann::ordered_json stroke = nlohmann::ordered_json::parse(text.str())["strokes"][0];
    stroke.erase("samples");
    return stroke;
}

/// Returns the value at the key; a null value if there is none.
const Json& valueIn(const Json& object, const char* key)
{
    static const Json none;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : none;
}

std::optional<double> numberIn(const Json& object, const char* key, double min, double max)
{
    const Json& value = valueIn(object, key);
    if (!value.is_number() || !(value.get<double>() >= min && value.get<double>() <= max))
        return std::nullopt;
    return value.get<double>();
}

std::optional<MeshFrame> frameIn(const Json& metadata)
{
    const auto exponent = numberIn(metadata, "lattice", -maxExponent, maxExponent);
    if (!exponent || *exponent != std::trunc(*exponent))
        return std::nullopt;
    MeshFrame frame{Lattice(static_cast<int>(*exponent))};
    const auto detail = numberIn(metadata, "uniformDetail", frame.lattice.minDetail(), farthest);
    if (!detail)
        return std::nullopt;
    frame.uniformDetail = *detail;
    const Json& place = valueIn(metadata, "place");
    for (std::size_t i = 0; i < 3 && place.is_array() && place.size() == 3; ++i) {
        if (!place[i].is_number() || !(std::abs(place[i].get<double>()) <= farthest))
            return std::nullopt;
        frame.place[static_cast<int>(i)] = place[i].get<double>();
    }
    return frame;
}

std::optional<SavedView> viewIn(const Json& metadata)
{
    constexpr double fullTurn = 6.284;
    const Json& from = valueIn(metadata, "view");
    const Json& target = valueIn(from, "target");
    const auto distance = numberIn(from, "distance", 1 / farthest, farthest);
    const auto yaw = numberIn(from, "yaw", -fullTurn, fullTurn), pitch = numberIn(from, "pitch", -fullTurn, fullTurn);
    if (!distance || !yaw || !pitch || !target.is_array() || target.size() != 3)
        return std::nullopt;
    SavedView view{Vec3::Zero(), *distance, *yaw, *pitch, valueIn(from, "orthographic") == true};
    for (int i = 0; i < 3; ++i) {
        const Json& x = target[static_cast<std::size_t>(i)];
        if (!x.is_number() || !(std::abs(x.get<double>()) <= farthest))
            return std::nullopt;
        view.target[i] = x.get<double>();
    }
    return view;
}

/// Returns whether no element is itself a list or an object. This bounds the recursion when the JSON is copied and
/// written.
bool isFlat(const Json& value)
{
    return std::ranges::none_of(value, [](const Json& part) { return part.is_structured(); });
}

std::optional<StrokeSettings> brushIn(const Json& metadata)
{
    const Json& brush = valueIn(metadata, "brush");
    if (!brush.is_object() || brush.contains("command") || !std::ranges::all_of(brush, isFlat))
        return std::nullopt;
    Json stroke = brush;
    stroke["samples"] = Json::array();
    const Json file = {{"format", "fettle-strokes"}, {"version", 1}, {"strokes", Json::array({stroke})}};
    try {
        return std::get<Stroke>(parseStrokes(file.dump()).at(0)).settings;
    } catch (const StrokeFileError&) {
        return std::nullopt;
    }
}

std::optional<WorkDone> workIn(const Json& metadata)
{
    constexpr double maxStrokes = 9e15, longest = 1e10; // integers that a double holds exactly; 300 years
    const Json& work = valueIn(metadata, "work");
    const auto strokes = numberIn(work, "strokes", 0, maxStrokes), seconds = numberIn(work, "seconds", 0, longest);
    if (!strokes || *strokes != std::trunc(*strokes) || !seconds)
        return std::nullopt;
    return WorkDone{static_cast<std::uint64_t>(*strokes), *seconds};
}

nlohmann::ordered_json jsonOf(const SavedReference& reference)
{
    const std::u8string path = reference.path.generic_u8string();
    return {{"side", reference.side},
            {"path", std::string(path.begin(), path.end())},
            {"width", reference.width},
            {"x", reference.x},
            {"y", reference.y},
            {"opacity", reference.opacity},
            {"inFront", reference.inFront}};
}

/// Reads one reference image. Returns nothing if an entry is not valid, or if the path is on a network: a file from an
/// untrusted source must not cause network access.
std::optional<SavedReference> referenceIn(const Json& json)
{
    static constexpr std::string_view sides[] = {"front", "back", "right", "left", "top", "bottom"};
    const Json &side = valueIn(json, "side"), &path = valueIn(json, "path");
    const auto width = numberIn(json, "width", 1 / farthest, farthest), x = numberIn(json, "x", -farthest, farthest),
               y = numberIn(json, "y", -farthest, farthest), opacity = numberIn(json, "opacity", 0, 1);
    if (!side.is_string() || std::ranges::find(sides, side.get_ref<const std::string&>()) == std::end(sides) ||
        !path.is_string() || !width || !x || !y || !opacity)
        return std::nullopt;
    const auto& text = path.get_ref<const std::string&>();
    if (text.empty() || text.find('\0') != std::string::npos || text.starts_with("//") || text.starts_with("\\\\"))
        return std::nullopt;
    return SavedReference{side,     std::u8string(text.begin(), text.end()), *width, *x, *y,
                          *opacity, valueIn(json, "inFront") == true};
}

std::vector<SavedReference> referencesIn(const Json& metadata)
{
    std::vector<SavedReference> references;
    const Json& all = valueIn(metadata, "references");
    for (const Json& json : all.is_array() ? all : Json::array())
        if (auto reference = referenceIn(json);
            reference && std::ranges::find(references, reference->side, &SavedReference::side) == references.end())
            references.push_back(*std::move(reference));
    return references;
}

std::vector<Rgb> paletteIn(const Json& metadata)
{
    const Json& words = valueIn(metadata, "palette");
    std::vector<Rgb> palette;
    for (const Json& word : words.is_array() ? words : Json::array()) {
        const auto color = word.is_string() ? colorOf(word.get_ref<const std::string&>()) : std::nullopt;
        if (!color || palette.size() == maxPaletteColors)
            return {};
        palette.push_back(*color);
    }
    return palette;
}

nlohmann::ordered_json jsonOf(const Part& part)
{
    nlohmann::ordered_json json = {
        {"id", part.id}, {"name", part.name}, {"visible", part.isVisible}, {"locked", part.isLocked}};
    if (part.tag)
        json["tag"] = hexOf(*part.tag);
    if (const Eigen::Quaterniond& axes = part.axes; axes != Eigen::Quaterniond::Identity())
        json["axes"] = {axes.x(), axes.y(), axes.z(), axes.w()};
    return json;
}

/// Returns the turn of a part's axes, which a part may lack; nothing if it is no rotation.
std::optional<Eigen::Quaterniond> axesIn(const Json& json)
{
    const Json& axes = valueIn(json, "axes");
    if (axes.is_null())
        return Eigen::Quaterniond::Identity();
    if (!axes.is_array() || axes.size() != 4 || !std::ranges::all_of(axes, &Json::is_number))
        return std::nullopt;
    const auto at = [&](std::size_t i) { return axes[i].get<double>(); };
    const Eigen::Quaterniond turn(at(3), at(0), at(1), at(2));
    return std::abs(turn.squaredNorm() - 1) < 1e-6 ? std::optional(turn) : std::nullopt;
}

std::optional<Part> partIn(const Json& json)
{
    const auto id = numberIn(json, "id", 0, maxPartId);
    const Json &name = valueIn(json, "name"), &visible = valueIn(json, "visible"), &locked = valueIn(json, "locked"),
               &tag = valueIn(json, "tag");
    if (!id || *id != std::trunc(*id) || !name.is_string() || !visible.is_boolean() || !locked.is_boolean())
        return std::nullopt;
    const auto color = tag.is_string() ? colorOf(tag.get_ref<const std::string&>()) : std::nullopt;
    if (!tag.is_null() && !color)
        return std::nullopt;
    const auto axes = axesIn(json);
    if (!axes)
        return std::nullopt;
    return Part{
        static_cast<PartId>(*id), name.get<std::string>(), visible.get<bool>(), locked.get<bool>(), color, *axes};
}

/// Returns the extension in a glTF document; a null value if there is none of a version that can be read.
const Json& extensionIn(const Json& document)
{
    static const Json none;
    const Json& json = valueIn(valueIn(document, "extensions"), extensionName);
    return valueIn(json, "version") == version && valueIn(json, "unit") == "mm" ? json : none;
}

/// Returns the JSON chunk; empty if the file is not a GLB, ends early, or has more JSON than maxJson.
std::string jsonChunkOf(std::istream& file)
{
    std::array<char, glbHeadSize + glbChunkHeadSize> head{};
    if (!file.read(head.data(), head.size()))
        return {};
    const auto numberAt = [&](std::size_t at) { return load<std::uint32_t>(head.data() + at, std::endian::little); };
    const std::size_t size = numberAt(glbHeadSize);
    if (numberAt(0) != glbMagic || numberAt(glbHeadSize + 4) != glbJsonChunk || size > maxJson)
        return {};
    std::string text(size, '\0');
    file.read(text.data(), static_cast<std::streamsize>(size));
    return file ? text : std::string();
}
} // namespace

void addMetadata(nlohmann::ordered_json& document, const DocumentMetadata& metadata, const PartList& parts)
{
    if (!metadata.frame && metadata.palette.empty() && !metadata.view && !metadata.brush && !metadata.work &&
        metadata.references.empty() && parts == PartList())
        return;
    nlohmann::ordered_json json = {{"version", version}, {"unit", "mm"}};
    if (metadata.frame) {
        json["lattice"] = metadata.frame->lattice.exponent();
        json["uniformDetail"] = metadata.frame->uniformDetail;
        if (const Vec3& place = metadata.frame->place; !place.isZero(0))
            json["place"] = {place.x(), place.y(), place.z()};
    }
    for (const Rgb& color : metadata.palette)
        json["palette"].push_back(hexOf(color));
    if (metadata.view)
        json["view"] = jsonOf(*metadata.view);
    if (metadata.brush)
        json["brush"] = jsonOf(*metadata.brush);
    if (metadata.work)
        json["work"] = {{"strokes", metadata.work->strokes}, {"seconds", metadata.work->seconds}};
    for (const SavedReference& reference : metadata.references)
        json["references"].push_back(jsonOf(reference));
    for (const Part& part : parts == PartList() ? std::vector<Part>() : parts.all())
        json["parts"].push_back(jsonOf(part));
    document["extensionsUsed"] = nlohmann::ordered_json::array({extensionName});
    document["extensions"] = {{extensionName, std::move(json)}};
}

DocumentMetadata readGlbMetadata(std::istream& file)
{
    const std::string text = jsonChunkOf(file);
    if (text.find(extensionName) == std::string::npos)
        return {};
    const Json document = Json::parse(text, nullptr, false);
    const Json& json = extensionIn(document);
    DocumentMetadata metadata{paletteIn(json), frameIn(json), viewIn(json),
                              brushIn(json),   workIn(json),  referencesIn(json)};
    if (metadata.frame)
        metadata.frame->parts = partsIn(document).value_or(PartList());
    return metadata;
}

std::optional<PartList> partsIn(const Json& document)
{
    const Json &all = valueIn(extensionIn(document), "parts"), &nodes = valueIn(document, "nodes");
    if (!all.is_array() || !nodes.is_array() || all.size() != nodes.size())
        return std::nullopt;
    std::vector<Part> parts;
    for (const Json& json : all) {
        auto part = partIn(json);
        if (!part)
            return std::nullopt;
        parts.push_back(*std::move(part));
    }
    return PartList::isUsable(parts) ? std::optional(PartList(std::move(parts))) : std::nullopt;
}
} // namespace core::io
