// The stroke file is read in one pass without building a JSON tree: each value is stored at once in its member. Memory
// is therefore proportional to the samples, and deeply nested brackets are refused at the first bracket that the format
// does not allow.
#include "core/io/stroke/stroke_file.h"

#include "core/io/stroke/stroke_json_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace core
{
namespace
{
constexpr std::size_t maxFileBytes = std::size_t(1) << 30;

using Value = StrokeFileError::Value;

/// The keys of stroke files and preset files whose value is not a keyword. A key has the same type in every object.
constexpr std::pair<std::string_view, Value> otherThanWords[] = {
    {"version", Value::WholeNumber},
    {"strokes", Value::Objects},
    {"samples", Value::Objects},
    {"stroke", Value::Object},
    {"falloff", Value::WholeNumber},
    {"radial", Value::WholeNumber},
    {"radius", Value::Number},
    {"radius_share", Value::Number},
    {"strength", Value::Number},
    {"detail", Value::Number},
    {"detail_length", Value::Number},
    {"spacing", Value::Number},
    {"airbrush", Value::Number},
    {"turntable_deg_per_s", Value::Number},
    {"factor", Value::Number},
    {"height", Value::Number},
    {"width", Value::Number},
    {"depth", Value::Number},
    {"top_radius", Value::Number},
    {"tube_radius", Value::Number},
    {"edge_length", Value::Number},
    {"profile", Value::Pairs},
    {"path", Value::Quadruples},
    {"outline", Value::Triples},
    {"t", Value::Number},
    {"pressure", Value::Number},
    {"position", Value::ThreeNumbers},
    {"direction", Value::ThreeNumbers},
    {"up", Value::ThreeNumbers},
    {"by", Value::ThreeNumbers},
    {"centre", Value::ThreeNumbers},
    {"eye", Value::ThreeNumbers},
    {"along", Value::ThreeNumbers},
    {"scale", Value::ThreeNumbers},
    {"rotation", Value::FourNumbers},
    {"scale_axes", Value::FourNumbers},
    {"color", Value::ThreeBytes},
    {"tag", Value::ThreeBytes},
    {"part", Value::WholeNumber},
    {"list_position", Value::WholeNumber},
    {"parts", Value::WholeNumbers},
    {"locked", Value::TrueOrFalse},
    {"front", Value::TrueOrFalse},
    {"symmetry", Value::WordOrTruth},
    {"fusion", Value::TrueOrFalse},
    {"add", Value::TrueOrFalse},
    {"join", Value::TrueOrFalse},
    {"invert", Value::TrueOrFalse},
    {"alpha_follows", Value::TrueOrFalse},
    {"anchored", Value::TrueOrFalse},
};

Value valueOf(std::string_view key)
{
    const auto* const found = std::ranges::find(otherThanWords, key, &std::pair<std::string_view, Value>::first);
    return found == std::end(otherThanWords) ? Value::Word : found->second;
}
} // namespace

StrokeFileError::StrokeFileError(Kind errorKind, std::string keyName)
    : std::runtime_error("stroke file: error " + std::to_string(static_cast<int>(errorKind)) + " at \"" + keyName +
                         "\"")
    , kind(errorKind)
    , key(std::move(keyName))
{
    if (kind == Kind::WrongType)
        wanted = valueOf(key);
}

std::vector<FileEntry> parseStrokes(std::string_view text)
{
    StrokeJsonReader reader(text);
    nlohmann::json::sax_parse(text.begin(), text.end(), &reader);
    return reader.take();
}

std::vector<FileEntry> readStrokes(const std::string& path)
{
    return parseStrokes(readStrokeText(path, maxFileBytes));
}

std::string readStrokeText(const std::string& path, std::size_t maxBytes)
{
    StrokeFileError tooLarge(StrokeFileError::Kind::TooLarge);
    tooLarge.max = static_cast<double>(maxBytes);
    std::error_code noSize; // file_size() fails for a pipe
    if (const auto size = std::filesystem::file_size(path, noSize); !noSize && size > maxBytes)
        throw tooLarge;
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string text;
    std::array<char, 1 << 16> chunk;
    while (file.good() && text.size() <= maxBytes) {
        file.read(chunk.data(), chunk.size());
        text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (text.size() > maxBytes)
        throw tooLarge;
    if (!file.eof()) {
        StrokeFileError error(StrokeFileError::Kind::CannotRead);
        error.systemError = errno;
        throw error;
    }
    return text;
}

void requireFit(const Stroke& stroke, const Lattice& lattice, const Vec3& offset)
{
    const double wall = lattice.halfVolume();
    const StrokeSettings& settings = stroke.settings;
    const double min = radiusFor(lattice.minDetail(), settings.detail);
    const bool isPosition = settings.brush != BrushShape::Ray && settings.place != Placement::Ray;
    const auto refuse = [](const std::string& key, double from, double to, std::optional<std::size_t> sample) {
        StrokeFileError error(StrokeFileError::Kind::OutOfRange, key);
        error.sample = sample;
        error.min = from;
        error.max = to;
        throw error;
    };
    if (settings.radius < min || settings.radius > wall)
        refuse("radius", min, wall, std::nullopt);
    if (settings.detailLength != 0 && settings.detailLength < lattice.minDetail())
        refuse("detail_length", lattice.minDetail(), wall, std::nullopt);
    for (std::size_t j = 0; j < stroke.samples.size(); ++j) {
        const StrokeSample& sample = stroke.samples[j];
        const double radius = sample.radius.value_or(settings.radius);
        if (radius < min || radius > wall)
            refuse("radius", min, wall, j);
        if (!isPosition)
            continue;
        const Vec3 onModel = sample.rotation.conjugate() * sample.position;
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(onModel[i]) <= wall)) {
                const std::string key = offset.isZero(0) ? "position" : "position[" + std::to_string(i) + "]";
                refuse(key, offset[i] - wall, offset[i] + wall, j);
            }
    }
}
} // namespace core
