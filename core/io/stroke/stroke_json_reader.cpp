// The structure of the stroke file: the objects and the keys that each may have. Values are handled in
// stroke_json_values.cpp.
#include "core/io/stroke/stroke_json_reader.h"

namespace core
{
void StrokeJsonReader::refuse(Kind kind, std::string_view value) const
{
    std::string key(keyName());
    if (!value.empty())
        key = key.empty() ? std::string(value) : key + ": " + std::string(value.substr(0, 60));
    throw errorHere(kind, std::move(key));
}

StrokeFileError StrokeJsonReader::errorHere(Kind kind, std::string key) const
{
    StrokeFileError error(kind, std::move(key));
    if (m_level >= Level::Stroke && !m_entries.empty())
        error.stroke = m_entries.size() - 1;
    if (m_level == Level::Sample)
        error.sample = std::get<Stroke>(m_entries.back()).samples.size() - 1;
    return error;
}

std::string_view StrokeJsonReader::keyName() const
{
    if (m_key < 0)
        return {};
    const auto index = static_cast<std::size_t>(m_key);
    switch (m_level) {
    case Level::File:
        return fileKeys.names[index];
    case Level::Stroke:
        return strokeKeys.names[index];
    case Level::Sample:
        return sampleKeys.names[index];
    case Level::Strokes:
        return "strokes";
    case Level::Samples:
        return "samples";
    case Level::Start:
        break;
    }
    return {};
}

template <std::size_t N> void StrokeJsonReader::noteKey(const Keys<N>& keys, const std::string& name)
{
    m_key = keys.indexOf(name);
    if (m_key < 0)
        refuse(m_level == Level::File && !(m_seen & bit(Format)) ? Kind::NotStrokes : Kind::UnknownKey,
               name.empty() ? std::string_view("\"\"") : std::string_view(name));
    if (m_seen & bit(static_cast<std::size_t>(m_key)))
        refuse(Kind::DuplicateKey);
    m_seen |= bit(static_cast<std::size_t>(m_key));
}

template <std::size_t N> void StrokeJsonReader::requireKeys(const Keys<N>& keys)
{
    for (unsigned i = 0; i < keys.required; ++i) {
        m_key = static_cast<int>(i);
        if (!(m_seen & bit(i)))
            refuse(m_level == Level::File && i == Format ? Kind::NotStrokes : Kind::MissingKey);
    }
}

bool StrokeJsonReader::key(string_t& name)
{
    switch (m_level) {
    case Level::File:
        noteKey(fileKeys, name);
        break;
    case Level::Stroke:
        noteKey(strokeKeys, name == "center" ? "centre" : name);
        break;
    default:
        noteKey(sampleKeys, name);
        break;
    }
    return true;
}

bool StrokeJsonReader::start_object(std::size_t)
{
    switch (m_level) {
    case Level::Start:
        m_level = Level::File;
        break;
    case Level::Strokes:
        m_entries.emplace_back();
        m_command = {};
        m_level = Level::Stroke;
        m_turntable = 0;
        m_undirected.reset();
        m_seenOuter = std::exchange(m_seen, 0);
        break;
    case Level::Samples:
        stroke().samples.emplace_back();
        m_level = Level::Sample;
        m_seenStroke = std::exchange(m_seen, 0);
        break;
    default:
        refuse(Kind::WrongType);
    }
    m_key = -1;
    return true;
}

bool StrokeJsonReader::end_object()
{
    switch (m_level) {
    case Level::File:
        requireKeys(fileKeys);
        break;
    case Level::Stroke:
        if (isCommand()) {
            endCommand();
        } else {
            requireNoneOf(commandKeys);
            requireKeys(strokeKeys);
            endStroke();
        }
        m_level = Level::Strokes;
        m_seen = m_seenOuter;
        break;
    default:
        requireKeys(sampleKeys);
        if (!(m_seen & bit(DirectionKey)) && !m_undirected)
            m_undirected = stroke().samples.size() - 1;
        m_level = Level::Samples;
        m_seen = m_seenStroke;
        break;
    }
    m_key = 0;
    return true;
}

bool StrokeJsonReader::start_array(std::size_t)
{
    if (m_level == Level::Start)
        refuse(Kind::NotStrokes);
    if (!m_inVector && m_level == Level::File && m_key == Strokes)
        m_level = Level::Strokes;
    else if (!m_inVector && m_level == Level::Stroke && m_key == SamplesKey)
        m_level = Level::Samples;
    else if (!m_inVector && !m_inOutline && m_level == Level::Stroke && m_key == OutlineKey)
        m_inOutline = true;
    else if (!m_inVector && !m_inProfile && m_level == Level::Stroke && (m_key == ProfileKey || m_key == PathKey))
        m_inProfile = true;
    else if (!m_inVector && (vectorLength() > 0 || isPartList()))
        m_inVector = true;
    else
        refuse(Kind::WrongType);
    m_count = 0;
    return true;
}

bool StrokeJsonReader::end_array()
{
    if (m_inVector) {
        endVector();
    } else if (m_inOutline) {
        m_inOutline = false;
    } else if (m_inProfile) {
        m_inProfile = false;
    } else if (m_level == Level::Strokes) {
        m_level = Level::File;
        m_key = Strokes;
    } else {
        m_level = Level::Stroke;
        m_key = SamplesKey;
    }
    return true;
}

bool StrokeJsonReader::parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& error)
{
    constexpr int numberOverflow = 406;
    // `position` is the number of bytes read; the last of them is the one that did not parse.
    const std::size_t at = std::min(std::max<std::size_t>(position, 1) - 1, m_text.size());
    const std::string_view rest = m_text.substr(at);
    const bool isNumber = error.id == numberOverflow || rest.starts_with("NaN") || rest.starts_with("Inf");
    StrokeFileError result = errorHere(isNumber ? Kind::NotANumber : Kind::Syntax, std::string(keyName()));
    result.line =
        1 + static_cast<std::size_t>(std::count(m_text.begin(), m_text.begin() + static_cast<long>(at), '\n'));
    result.byte = at + 1;
    throw result;
}
} // namespace core
