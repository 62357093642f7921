#pragma once

#include "core/io/stroke/brush_file.h"
#include "core/io/stroke/stroke_json_reader.h"

namespace core
{
/// Receives the JSON parser's events for a preset file. Forwards the content of "stroke" to the stroke file's reader as
/// a stroke without samples, so that both files share keywords, ranges and errors.
class BrushJsonReader : public nlohmann::json::json_sax_t
{
public:
    explicit BrushJsonReader(std::string_view text) : m_strokes(text) { m_preset.stroke.spacing = presetSpacing; }
    BrushPreset take() { return std::move(m_preset); }

    bool null() override;
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
    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) override;

private:
    using Kind = StrokeFileError::Kind;
    enum class Level { Start, File, Stroke };

    [[noreturn]] void refuse(Kind kind, const std::string& value = {}) const;
    template <class Pass> bool pass(const Pass& pass);
    bool number(double value);
    void beginStroke();
    void endStroke();
    void strokeKey(const std::string& name);

    StrokeJsonReader m_strokes;
    BrushPreset m_preset;
    Level m_level = Level::Start;
    std::string m_key;
    std::vector<std::string> m_seen; ///< keys read in the outermost object
    std::vector<std::string> m_seenInStroke;
};
} // namespace core
