// The stroke file, read in one pass without a tree: each value goes straight to its place, so a file costs what its
// samples cost, and a nest of brackets is refused at the first bracket that the format does not have.
#include "stroke_file.h"

#include <nlohmann/json.hpp>

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
using Kind = StrokeFileError::Kind;
using Json = nlohmann::json;

constexpr std::size_t maxFileBytes = std::size_t(1) << 30;
constexpr double leastSpacing = 1e-3;   ///< but for 0: a typing error shall not ask for 10^12 dabs
constexpr double leastDirection = 1e-9; ///< of a ray's direction

/// The keys of one kind of object; the first `required` of them must be there.
template <std::size_t N> struct Keys
{
    std::array<std::string_view, N> names;
    unsigned required;

    int indexOf(std::string_view name) const
    {
        const auto found = std::find(names.begin(), names.end(), name);
        return found == names.end() ? -1 : static_cast<int>(found - names.begin());
    }
};

enum FileKey { Format, Version, Strokes };
constexpr Keys<3> fileKeys{{"format", "version", "strokes"}, 3};

enum StrokeKey {
    ToolKey, RadiusKey, SamplesKey, BrushKey, StrengthKey, FalloffKey, DetailKey, DetailLengthKey, TopologyKey, FusionKey,
    SymmetryKey, SpacingKey, PlaceKey, AddKey, ColorKey, TurntableKey
};
constexpr Keys<16> strokeKeys{{"tool", "radius", "samples", "brush", "strength", "falloff", "detail", "detail_length",
                               "topology", "fusion", "symmetry", "spacing", "place", "add", "color",
                               "turntable_deg_per_s"},
                              3};

enum SampleKey { PositionKey, TimeKey, DirectionKey, PressureKey, RotationKey, SampleRadiusKey, SampleStrengthKey };
constexpr Keys<7> sampleKeys{{"position", "t", "direction", "pressure", "rotation", "radius", "strength"}, 1};

/// The xz plane (section 3.5.2): what `"symmetry": true` means.
constexpr Symmetry paperPlane = Symmetry::Y;

/// By Taylor series of sine and cosine, so that it has the same bits on every machine.
Eigen::Quaterniond turnAboutY(double degrees)
{
    constexpr double halfDegree = 3.14159265358979323846 / 360;
    const double x = std::remainder(degrees, 360.0) * halfDegree; // within a quarter turn
    double sine = 0, cosine = 0, term = 1;
    for (int i = 0; i < 24; i += 2) {
        const double sign = i % 4 == 0 ? 1 : -1;
        cosine += sign * term;
        term *= x / (i + 1);
        sine += sign * term;
        term *= x / (i + 2);
    }
    return Eigen::Quaterniond(cosine, 0, sine, 0).normalized();
}

/// Takes the parser's events; knows where in the format it stands. Throws at the first that does not belong there.
class StrokeReader : public Json::json_sax_t
{
public:
    explicit StrokeReader(std::string_view text) : m_text(text) {}
    std::vector<Stroke> take() { return std::move(m_strokes); }

    bool null() override { refuse(m_level == Level::Start ? Kind::NotStrokes : Kind::WrongType); }
    bool boolean(bool value) override;
    bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return number(value); }
    bool string(string_t& value) override;
    bool binary(binary_t&) override { refuse(Kind::WrongType); }
    bool start_object(std::size_t) override;
    bool key(string_t& name) override;
    bool end_object() override;
    bool start_array(std::size_t) override;
    bool end_array() override;
    bool parse_error(std::size_t position, const std::string& token, const Json::exception& error) override;

private:
    enum class Level { Start, File, Strokes, Stroke, Samples, Sample };

    [[noreturn]] void refuse(Kind kind, std::string_view value = {}) const;
    [[noreturn]] void refuse(Kind kind, const std::string& key, std::optional<double> least,
                             std::optional<double> most) const;
    StrokeFileError errorHere(Kind kind, std::string key) const;
    std::string_view keyName() const;
    double inRange(double value, double least, double most) const;
    double inRange(double value, Parameter parameter) const;
    double zeroOrInRange(double value, double least, double most) const;

    template <std::size_t N> void noteKey(const Keys<N>& keys, const std::string& name);
    template <std::size_t N> void requireKeys(const Keys<N>& keys);
    bool number(double value);
    void strokeNumber(double value);
    void sampleNumber(double value);
    void strokeWord(const std::string& word);
    std::size_t vectorLength() const;
    void endVector();
    void endSample();
    void endStroke();

    std::string_view m_text;
    std::vector<Stroke> m_strokes;
    Level m_level = Level::Start;
    int m_key = -1;          ///< in the level's keys
    unsigned m_seen = 0;     ///< bit per key of the innermost object
    unsigned m_seenOuter = 0, m_seenStroke = 0;
    bool m_inVector = false; ///< between the brackets of a list of numbers
    std::size_t m_count = 0; ///< of them so far
    std::array<double, 4> m_vector{};
    double m_turntable = 0;
    std::optional<std::size_t> m_undirected; ///< the stroke's first sample without a direction
};

void StrokeReader::refuse(Kind kind, std::string_view value) const
{
    std::string key(keyName());
    if (!value.empty())
        key = key.empty() ? std::string(value) : key + ": " + std::string(value.substr(0, 60));
    throw errorHere(kind, std::move(key));
}

void StrokeReader::refuse(Kind kind, const std::string& key, std::optional<double> least,
                          std::optional<double> most) const
{
    StrokeFileError error = errorHere(kind, key);
    error.least = least;
    error.most = most;
    throw error;
}

StrokeFileError StrokeReader::errorHere(Kind kind, std::string key) const
{
    StrokeFileError error(kind, std::move(key));
    if (m_level >= Level::Stroke && !m_strokes.empty())
        error.stroke = m_strokes.size() - 1;
    if (m_level == Level::Sample)
        error.sample = m_strokes.back().samples.size() - 1;
    return error;
}

std::string_view StrokeReader::keyName() const
{
    if (m_key < 0)
        return {};
    const auto index = static_cast<std::size_t>(m_key);
    switch (m_level) {
    case Level::File: return fileKeys.names[index];
    case Level::Stroke: return strokeKeys.names[index];
    case Level::Sample: return sampleKeys.names[index];
    case Level::Strokes: return "strokes";
    case Level::Samples: return "samples";
    case Level::Start: break;
    }
    return {};
}

double StrokeReader::inRange(double value, double least, double most) const
{
    if (!(value >= least && value <= most))
        refuse(Kind::OutOfRange, std::string(keyName()), least, most);
    return value;
}

double StrokeReader::zeroOrInRange(double value, double least, double most) const
{
    if (value == 0 || (value >= least && value <= most))
        return value;
    StrokeFileError error = errorHere(Kind::OutOfRange, std::string(keyName()));
    error.least = least;
    error.most = most;
    error.orZero = true;
    throw error;
}

double StrokeReader::inRange(double value, Parameter parameter) const
{
    return inRange(value, info(parameter).min, info(parameter).max);
}

template <std::size_t N> void StrokeReader::noteKey(const Keys<N>& keys, const std::string& name)
{
    m_key = keys.indexOf(name);
    if (m_key < 0)
        refuse(m_level == Level::File && !(m_seen & (1u << Format)) ? Kind::NotStrokes : Kind::UnknownKey,
               name.empty() ? std::string_view("\"\"") : std::string_view(name));
    if (m_seen & (1u << m_key))
        refuse(Kind::DuplicateKey);
    m_seen |= 1u << m_key;
}

template <std::size_t N> void StrokeReader::requireKeys(const Keys<N>& keys)
{
    for (unsigned i = 0; i < keys.required; ++i) {
        m_key = static_cast<int>(i);
        if (!(m_seen & (1u << i)))
            refuse(m_level == Level::File && i == Format ? Kind::NotStrokes : Kind::MissingKey);
    }
}

bool StrokeReader::key(string_t& name)
{
    switch (m_level) {
    case Level::File: noteKey(fileKeys, name); break;
    case Level::Stroke: noteKey(strokeKeys, name); break;
    default: noteKey(sampleKeys, name); break;
    }
    return true;
}

bool StrokeReader::start_object(std::size_t)
{
    switch (m_level) {
    case Level::Start:
        m_level = Level::File;
        break;
    case Level::Strokes:
        m_strokes.emplace_back();
        m_level = Level::Stroke;
        m_turntable = 0;
        m_undirected.reset();
        m_seenOuter = std::exchange(m_seen, 0);
        break;
    case Level::Samples:
        m_strokes.back().samples.emplace_back();
        m_level = Level::Sample;
        m_seenStroke = std::exchange(m_seen, 0);
        break;
    default: refuse(Kind::WrongType);
    }
    m_key = -1;
    return true;
}

bool StrokeReader::end_object()
{
    switch (m_level) {
    case Level::File:
        requireKeys(fileKeys);
        break;
    case Level::Stroke:
        requireKeys(strokeKeys);
        endStroke();
        m_level = Level::Strokes;
        m_seen = m_seenOuter;
        break;
    default:
        requireKeys(sampleKeys);
        if (!(m_seen & (1u << DirectionKey)) && !m_undirected)
            m_undirected = m_strokes.back().samples.size() - 1;
        m_level = Level::Samples;
        m_seen = m_seenStroke;
        break;
    }
    m_key = 0;
    return true;
}

bool StrokeReader::start_array(std::size_t)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (!m_inVector && m_level == Level::File && m_key == Strokes)
        m_level = Level::Strokes;
    else if (!m_inVector && m_level == Level::Stroke && m_key == SamplesKey)
        m_level = Level::Samples;
    else if (!m_inVector && vectorLength() > 0)
        m_inVector = true;
    else
        refuse(Kind::WrongType);
    m_count = 0;
    return true;
}

bool StrokeReader::end_array()
{
    if (m_inVector) {
        endVector();
    } else if (m_level == Level::Strokes) {
        m_level = Level::File;
        m_key = Strokes;
    } else {
        m_level = Level::Stroke;
        m_key = SamplesKey;
    }
    return true;
}

/// How many numbers the key's list holds; 0: the key has no list.
std::size_t StrokeReader::vectorLength() const
{
    if (m_level == Level::Stroke)
        return m_key == ColorKey ? 3 : 0;
    if (m_level == Level::Sample)
        return m_key == RotationKey ? 4 : m_key == PositionKey || m_key == DirectionKey ? 3 : 0;
    return 0;
}

void StrokeReader::endVector()
{
    m_inVector = false;
    if (m_count != vectorLength())
        refuse(Kind::WrongType);
    if (m_level == Level::Stroke) {
        const auto byte = [](double value) { return static_cast<std::uint8_t>(value); };
        m_strokes.back().settings.color = {byte(m_vector[0]), byte(m_vector[1]), byte(m_vector[2])};
        return;
    }
    StrokeSample& sample = m_strokes.back().samples.back();
    if (m_key == RotationKey) {
        sample.rotation = Eigen::Quaterniond(m_vector[3], m_vector[0], m_vector[1], m_vector[2]);
        const double length = sample.rotation.squaredNorm();
        if (!(std::abs(length - 1) <= rotationTolerance))
            refuse(Kind::OutOfRange);
        if (std::abs(length - 1) > 8 * std::numeric_limits<double>::epsilon())
            sample.rotation.normalize();
    } else {
        (m_key == PositionKey ? sample.position : sample.direction) = Vec3(m_vector[0], m_vector[1], m_vector[2]);
    }
}

bool StrokeReader::number(double value)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (!std::isfinite(value))
        refuse(Kind::NotANumber);
    if (m_inVector) {
        if (m_count == vectorLength())
            refuse(Kind::WrongType);
        const bool isColor = m_level == Level::Stroke;
        m_vector[m_count++] = isColor ? inRange(value, 0, 255) : inRange(value, -farthestSample, farthestSample);
        if (isColor && value != std::trunc(value))
            refuse(Kind::WrongType);
    } else if (m_level == Level::Sample) {
        sampleNumber(value);
    } else if (m_level == Level::Stroke) {
        strokeNumber(value);
    } else if (m_level != Level::File || m_key != Version) {
        refuse(Kind::WrongType);
    } else if (value != 1) {
        refuse(Kind::NotStrokes);
    }
    return true;
}

void StrokeReader::strokeNumber(double value)
{
    StrokeSettings& settings = m_strokes.back().settings;
    switch (m_key) {
    case RadiusKey: settings.radius = inRange(value, Parameter::Radius); break;
    case StrengthKey: settings.strength = inRange(value, Parameter::Strength); break;
    case DetailKey: settings.detail = inRange(value, Parameter::Detail); break;
    case DetailLengthKey: settings.detailLength = inRange(value, info(Parameter::Radius).min, info(Parameter::Radius).max); break;
    case TurntableKey: m_turntable = inRange(value, -farthestSample, farthestSample); break;
    case SpacingKey: settings.spacing = zeroOrInRange(value, leastSpacing, info(Parameter::Spacing).max); break;
    case FalloffKey:
        zeroOrInRange(value, leastFalloff, info(Parameter::Falloff).max);
        if (value != std::trunc(value))
            refuse(Kind::WrongType);
        settings.falloff = static_cast<int>(value);
        break;
    default: refuse(Kind::WrongType);
    }
}

void StrokeReader::sampleNumber(double value)
{
    StrokeSample& sample = m_strokes.back().samples.back();
    switch (m_key) {
    case TimeKey: sample.time = inRange(value, -farthestSample, farthestSample); break;
    case PressureKey: sample.pressure = inRange(value, 0, 1); break;
    case SampleRadiusKey: sample.radius = inRange(value, Parameter::Radius); break;
    case SampleStrengthKey: sample.strength = inRange(value, Parameter::Strength); break;
    default: refuse(Kind::WrongType);
    }
}

bool StrokeReader::boolean(bool value)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (m_level != Level::Stroke || m_inVector || (m_key != FusionKey && m_key != SymmetryKey && m_key != AddKey))
        refuse(Kind::WrongType);
    if (m_key == SymmetryKey)
        m_strokes.back().settings.symmetry = value ? paperPlane : Symmetry::None;
    if (m_key == AddKey)
        m_strokes.back().settings.add = value;
    else if (m_key == FusionKey)
        m_strokes.back().settings.fusion = value;
    return true;
}

bool StrokeReader::string(string_t& value)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (m_level == Level::Stroke && !m_inVector)
        strokeWord(value);
    else if (m_level != Level::File || m_key != Format)
        refuse(Kind::WrongType);
    else if (value != "fettle-strokes")
        refuse(Kind::NotStrokes);
    return true;
}

void StrokeReader::strokeWord(const std::string& word)
{
    StrokeSettings& settings = m_strokes.back().settings;
    bool known = true;
    switch (m_key) {
    case ToolKey:
        known = toolNamed(word).has_value();
        settings.tool = toolNamed(word).value_or(settings.tool);
        break;
    case BrushKey:
        known = brushNamed(word).has_value();
        settings.brush = brushNamed(word).value_or(settings.brush);
        break;
    case TopologyKey:
        known = topologyNamed(word).has_value();
        settings.topology = topologyNamed(word).value_or(settings.topology);
        break;
    case SymmetryKey:
        known = symmetryNamed(word).has_value();
        settings.symmetry = symmetryNamed(word).value_or(settings.symmetry);
        break;
    case PlaceKey:
        known = placementNamed(word).has_value();
        settings.place = placementNamed(word).value_or(settings.place);
        break;
    default: refuse(Kind::WrongType);
    }
    if (!known)
        refuse(Kind::UnknownValue, "\"" + word + "\"");
}

void StrokeReader::endStroke()
{
    Stroke& stroke = m_strokes.back();
    const bool alongRays = stroke.settings.place == Placement::Ray || stroke.settings.brush == BrushShape::Ray;
    if (alongRays && m_undirected) {
        StrokeFileError error = errorHere(Kind::MissingKey, "direction");
        error.sample = m_undirected;
        throw error;
    }
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        StrokeSample& sample = stroke.samples[i];
        if (alongRays && sample.direction.cwiseAbs().maxCoeff() < leastDirection) {
            StrokeFileError error = errorHere(Kind::OutOfRange, "direction");
            error.sample = i;
            throw error;
        }
        if (m_turntable != 0)
            sample.rotation = turnAboutY(m_turntable * sample.time) * sample.rotation;
    }
}

bool StrokeReader::parse_error(std::size_t position, const std::string&, const Json::exception& error)
{
    constexpr int numberOverflow = 406;
    // `position` is the count of bytes read: the one that did not fit is the last of them.
    const std::size_t at = std::min(std::max<std::size_t>(position, 1) - 1, m_text.size());
    const std::string_view rest = m_text.substr(at);
    const bool isNumber = error.id == numberOverflow || rest.starts_with("NaN") || rest.starts_with("Inf");
    StrokeFileError result = errorHere(isNumber ? Kind::NotANumber : Kind::Syntax, std::string(keyName()));
    result.line = 1 + static_cast<std::size_t>(std::count(m_text.begin(), m_text.begin() + static_cast<long>(at), '\n'));
    result.byte = at + 1;
    throw result;
}
} // namespace

StrokeFileError::StrokeFileError(Kind errorKind, std::string keyName)
    : std::runtime_error("stroke file: error " + std::to_string(static_cast<int>(errorKind)) + " at \"" + keyName + "\""),
      kind(errorKind), key(std::move(keyName))
{
}

std::vector<Stroke> parseStrokes(std::string_view text)
{
    StrokeReader reader(text);
    Json::sax_parse(text.begin(), text.end(), &reader);
    return reader.take();
}

std::vector<Stroke> readStrokes(const std::string& path)
{
    StrokeFileError tooLarge(Kind::TooLarge);
    tooLarge.most = static_cast<double>(maxFileBytes);
    std::error_code noSize; // of a pipe
    if (const auto size = std::filesystem::file_size(path, noSize); !noSize && size > maxFileBytes)
        throw tooLarge;
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string text;
    std::array<char, 1 << 16> chunk;
    while (file.good() && text.size() <= maxFileBytes) {
        file.read(chunk.data(), chunk.size());
        text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (text.size() > maxFileBytes)
        throw tooLarge;
    if (!file.eof()) {
        StrokeFileError error(Kind::CannotRead);
        error.systemError = errno;
        throw error;
    }
    return parseStrokes(text);
}
} // namespace core
