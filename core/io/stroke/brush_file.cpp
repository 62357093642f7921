#include "core/io/stroke/brush_file.h"

#include "core/io/stroke/brush_json_reader.h"

#include "core/sculpt/deform/alpha.h"

#include <cmath>

namespace core
{
namespace
{
constexpr std::string_view brushFormat = "fettle-brush";
constexpr double brushVersion = 1;
constexpr std::size_t maxBrushBytes = std::size_t(32) << 20; ///< bytes; leaves room for the largest alpha image

/// Reads the file's format and version and ignores all other content.
class HeaderReader : public nlohmann::json::json_sax_t
{
public:
    std::string format;
    double version = 0;
    bool isObject = false;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return number(value); }
    bool string(string_t& value) override
    {
        if (m_depth == 1 && m_key == "format")
            format = value;
        return true;
    }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override
    {
        isObject = isObject || m_depth == 0;
        ++m_depth;
        return true;
    }
    bool key(string_t& name) override
    {
        if (m_depth == 1)
            m_key = name;
        return true;
    }
    bool end_object() override
    {
        --m_depth;
        return true;
    }
    bool start_array(std::size_t) override
    {
        ++m_depth;
        return true;
    }
    bool end_array() override
    {
        --m_depth;
        return true;
    }
    /// Ends parsing silently: BrushJsonReader parses the file again and reports the syntax error.
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override { return false; }

private:
    bool number(double value)
    {
        if (m_depth == 1 && m_key == "version")
            version = value;
        return true;
    }

    std::size_t m_depth = 0;
    std::string m_key;
};

void requireVersion(std::string_view text)
{
    using Kind = StrokeFileError::Kind;
    HeaderReader header;
    const bool isJson = nlohmann::json::sax_parse(text.begin(), text.end(), &header);
    if (header.format == brushFormat && header.version > brushVersion)
        throw StrokeFileError(Kind::NewerVersion, "version");
    if (!isJson)
        return;
    if (header.format != brushFormat)
        throw StrokeFileError(Kind::NotBrush, header.isObject ? "format" : "");
    if (header.version != brushVersion)
        throw StrokeFileError(Kind::NotBrush, "version");
}

nlohmann::ordered_json strokeOf(const BrushPreset& preset)
{
    const StrokeSettings& settings = preset.stroke;
    nlohmann::ordered_json stroke{{"tool", name(settings.tool)}};
    if (preset.chosen.reach)
        stroke["brush"] = name(settings.brush);
    stroke["strength"] = settings.strength;
    stroke["falloff"] = settings.falloff;
    if (preset.chosen.detail)
        stroke["detail"] = settings.detail;
    if (preset.chosen.topology)
        stroke["topology"] = name(settings.topology);
    stroke["spacing"] = settings.spacing;
    stroke["airbrush"] = settings.airbrush;
    if (settings.inverted)
        stroke["invert"] = true;
    if (const std::string alpha = settings.alpha ? settings.alpha->source() : preset.alpha.file; !alpha.empty())
        stroke["alpha"] = alpha;
    if (settings.alphaFollows)
        stroke["alpha_follows"] = true;
    if (settings.anchored)
        stroke["anchored"] = true;
    if (preset.chosen.color)
        stroke["color"] = {settings.color.r, settings.color.g, settings.color.b};
    return stroke;
}
} // namespace

BrushPreset parseBrush(std::string_view text)
{
    requireVersion(text);
    BrushJsonReader reader(text);
    nlohmann::json::sax_parse(text.begin(), text.end(), &reader);
    return reader.take();
}

BrushPreset readBrush(const std::filesystem::path& path)
{
    return parseBrush(readStrokeText(path, maxBrushBytes));
}

std::string toJson(const BrushPreset& preset)
{
    nlohmann::ordered_json file{{"format", brushFormat}, {"version", 1}, {"name", preset.name}};
    if (preset.radiusShare)
        file["radius_share"] = *preset.radiusShare;
    file["stroke"] = strokeOf(preset);
    if (!preset.alphaImage.empty())
        file["alpha_image"] = preset.alphaImage;
    return file.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}
} // namespace core
