// The stroke file is read in one pass without building a JSON tree: each value is stored at once in its member. Memory
// is therefore proportional to the samples, and deeply nested brackets are refused at the first bracket that the format
// does not allow.
#include "core/io/stroke/stroke_file.h"

#include "core/io/stroke/stroke_json_reader.h"
#include "core/util/system_code.h"
#include "core/util/system_path.h"

#include <algorithm>
#include <array>
#include <cmath>
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

StrokeFileError tooLarge(std::size_t maxBytes)
{
    StrokeFileError error(StrokeFileError::Kind::TooLarge);
    error.max = static_cast<double>(maxBytes);
    return error;
}

/// Returns the rest of the stream. Throws StrokeFileError: TooLarge, or CannotRead if the stream failed or was not
/// open. Precondition: clearStreamCode() was called before the stream was opened.
std::string textOf(std::istream& stream, std::size_t maxBytes)
{
    std::string text;
    std::array<char, 1 << 16> chunk;
    while (stream.good() && text.size() <= maxBytes) {
        stream.read(chunk.data(), chunk.size());
        text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (text.size() > maxBytes)
        throw tooLarge(maxBytes);
    if (!stream.eof()) {
        StrokeFileError error(StrokeFileError::Kind::CannotRead);
        error.systemError = streamCode();
        throw error;
    }
    return text;
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

std::vector<FileEntry> readStrokes(const std::filesystem::path& path)
{
    return parseStrokes(readStrokeText(path, maxFileBytes));
}

std::vector<FileEntry> readStrokes(std::istream& stream)
{
    clearStreamCode();
    return parseStrokes(textOf(stream, maxFileBytes));
}

std::string readStrokeText(const std::filesystem::path& path, std::size_t maxBytes)
{
    if (fileStatus(path).size > maxBytes) // which a pipe does not tell
        throw tooLarge(maxBytes);
    clearStreamCode();
    std::ifstream file(systemPath(path), std::ios::binary);
    return textOf(file, maxBytes);
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
