#include "core/io/stroke/brush_json_reader.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr std::array<std::string_view, 6> brushFileKeys{"format", "version",      "name",
                                                        "stroke", "radius_share", "alpha_image"};
constexpr std::size_t requiredKeys = 4;
/// The keys of a stroke that a preset may also have.
constexpr std::array<std::string_view, 13> presetKeys{"tool",          "brush",    "strength", "falloff", "detail",
                                                      "topology",      "spacing",  "airbrush", "invert",  "alpha",
                                                      "alpha_follows", "anchored", "color"};

template <class List> bool contains(const List& list, std::string_view what)
{
    return std::ranges::find(list, what) != std::end(list);
}

/// Returns whether the text fits a name shown to users: not blank, not too long, no control characters. The JSON parser
/// has already refused invalid UTF-8.
bool isName(const std::string& name)
{
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    const bool isBlank = std::ranges::all_of(name, [](char c) { return c == ' '; });
    return !isBlank && name.size() <= maxPresetName && std::ranges::none_of(name, isControl);
}

bool isBase64(const std::string& text)
{
    const auto isDigit = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/' ||
               c == '=';
    };
    return !text.empty() && std::ranges::all_of(text, isDigit);
}
} // namespace

void BrushJsonReader::refuse(Kind kind, const std::string& value) const
{
    if (m_level == Level::Start)
        throw StrokeFileError(Kind::NotBrush);
    throw StrokeFileError(kind, value.empty() ? m_key : m_key + ": \"" + value.substr(0, 60) + '"');
}

/// Forwards one event to the stroke reader. Removes the stroke's index from its errors, since a preset has only one
/// stroke.
template <class Pass> bool BrushJsonReader::pass(const Pass& pass)
{
    try {
        return pass(m_strokes);
    } catch (StrokeFileError& error) {
        error.stroke.reset();
        throw;
    }
}

bool BrushJsonReader::null()
{
    if (m_level != Level::Stroke)
        refuse(Kind::WrongType);
    return pass([](StrokeJsonReader& strokes) { return strokes.null(); });
}

bool BrushJsonReader::boolean(bool value)
{
    if (m_level != Level::Stroke)
        refuse(Kind::WrongType);
    return pass([&](StrokeJsonReader& strokes) { return strokes.boolean(value); });
}

bool BrushJsonReader::number(double value)
{
    if (m_level == Level::Stroke)
        return pass([&](StrokeJsonReader& strokes) { return strokes.number_float(value, {}); });
    if (m_level == Level::File && m_key == "version")
        return true; // parseBrush() has checked the version already
    if (m_level != Level::File || m_key != "radius_share")
        refuse(Kind::WrongType);
    if (!(value >= minPresetRadius && value <= maxPresetRadius)) {
        StrokeFileError error(Kind::OutOfRange, m_key);
        error.min = minPresetRadius;
        error.max = maxPresetRadius;
        throw error;
    }
    m_preset.radiusShare = value;
    return true;
}

bool BrushJsonReader::string(string_t& value)
{
    if (m_level == Level::Stroke)
        return pass([&](StrokeJsonReader& strokes) { return strokes.string(value); });
    if (m_key == "name") {
        if (!isName(value))
            refuse(Kind::UnknownValue, value);
        m_preset.name = value;
    } else if (m_key == "alpha_image") {
        if (!isBase64(value))
            refuse(Kind::UnknownValue, value);
        m_preset.alphaImage = value;
    } else if (m_key != "format") {
        refuse(Kind::WrongType);
    }
    return true;
}

bool BrushJsonReader::start_object(std::size_t size)
{
    if (m_level == Level::Stroke)
        return pass([&](StrokeJsonReader& strokes) { return strokes.start_object(size); });
    if (m_level == Level::Start)
        m_level = Level::File;
    else if (m_key == "stroke")
        beginStroke();
    else
        refuse(Kind::WrongType);
    return true;
}

bool BrushJsonReader::key(string_t& name)
{
    if (m_level == Level::Stroke) {
        strokeKey(name);
        return true;
    }
    m_key = name;
    if (!contains(brushFileKeys, name))
        throw StrokeFileError(Kind::UnknownKey, name.empty() ? "\"\"" : name.substr(0, 60));
    if (contains(m_seen, name))
        refuse(Kind::DuplicateKey);
    m_seen.push_back(name);
    return true;
}

bool BrushJsonReader::end_object()
{
    if (m_level == Level::Stroke) {
        endStroke();
        return true;
    }
    for (std::size_t i = 0; i < requiredKeys; ++i) {
        m_key = brushFileKeys[i];
        if (!contains(m_seen, m_key))
            refuse(Kind::MissingKey);
    }
    if (!m_preset.alphaImage.empty() && m_preset.alpha.file.empty()) {
        m_key = "alpha_image";
        refuse(Kind::UnknownKey); // the preset names no alpha file whose image this could be
    }
    return true;
}

bool BrushJsonReader::start_array(std::size_t size)
{
    if (m_level != Level::Stroke)
        refuse(Kind::WrongType);
    return pass([&](StrokeJsonReader& strokes) { return strokes.start_array(size); });
}

bool BrushJsonReader::end_array()
{
    return pass([&](StrokeJsonReader& strokes) { return strokes.end_array(); });
}

bool BrushJsonReader::parse_error(std::size_t position, const std::string& token,
                                  const nlohmann::json::exception& error)
{
    try {
        return pass([&](StrokeJsonReader& strokes) { return strokes.parse_error(position, token, error); });
    } catch (StrokeFileError& problem) {
        if (m_level != Level::Stroke)
            problem.key = m_key;
        throw;
    }
}

/// Sends events to the stroke reader until it is inside a stroke whose radius has been read.
void BrushJsonReader::beginStroke()
{
    m_level = Level::Stroke;
    pass([](StrokeJsonReader& strokes) {
        const auto enter = [&](std::string name) { strokes.key(name); };
        std::string format = "fettle-strokes";
        strokes.start_object(0);
        enter("format");
        strokes.string(format);
        enter("version");
        strokes.number_unsigned(1);
        enter("strokes");
        strokes.start_array(0);
        strokes.start_object(0);
        enter("radius");
        return strokes.number_unsigned(1);
    });
}

void BrushJsonReader::strokeKey(const std::string& name)
{
    if (!contains(presetKeys, name))
        throw StrokeFileError(Kind::UnknownKey, name.empty() ? "\"\"" : name.substr(0, 60));
    m_seenInStroke.push_back(name);
    std::string key = name;
    pass([&](StrokeJsonReader& strokes) { return strokes.key(key); });
}

void BrushJsonReader::endStroke()
{
    pass([](StrokeJsonReader& strokes) {
        std::string samples = "samples";
        return strokes.key(samples) && strokes.start_array(0) && strokes.end_array() && strokes.end_object() &&
               strokes.end_array();
    });
    m_level = Level::File;
    const Stroke stroke = std::get<Stroke>(m_strokes.take().front());
    const auto says = [&](std::string_view key) { return contains(m_seenInStroke, key); };
    m_preset.stroke = stroke.settings;
    m_preset.stroke.radius = info(Parameter::Radius).defaultValue;
    m_preset.stroke.spacing = says("spacing") ? stroke.settings.spacing : presetSpacing;
    m_preset.stroke.airbrush = says("airbrush") ? stroke.settings.airbrush : defaultAirbrush;
    m_preset.alpha = stroke.alpha;
    m_preset.chosen = {says("brush"), says("topology"), says("detail"), says("color")};
}
} // namespace core
