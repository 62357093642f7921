#pragma once

#include "core/io/stroke/stroke_file.h"
#include "core/io/stroke/stroke_keys.h"

#include <nlohmann/json.hpp>

#include <span>

namespace core
{
/// The values of a command's keys, which may be read in any order.
struct CommandDraft
{
    std::string name, file;
    Vec3 by = Vec3::Zero(), centre = Vec3::Zero();
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(), scaleAxes = rotation;
    Vec3 scale = Vec3::Ones();
    double factor = 1;
    Symmetry plane = Symmetry::None;
    Half keep = Half::Positive;
    Insert::Place where = Insert::Place::Beside;
    Insert::Combination combination = Insert::Combination::Apart;
    Primitive primitive; ///< also has the height of a flattened base
    MaskOperation::Kind how = MaskOperation::Kind::Invert;
    std::vector<PartId> parts;
    std::string partName;
    bool isLocked = false;
    std::optional<Rgb> tag;
    SetOperation operation = SetOperation::Union;
    Hide::What hides = Hide::What::Masked;
    std::optional<std::size_t> position; ///< in the list of parts
    ViewArea area;                       ///< without its eye and symmetry
    Vec3 eye = Vec3::Zero();
    bool hasEye = false, hasColor = false; ///< the object has the keys "eye" and "color"
};

/// Receives the JSON parser's events and tracks the position in the format. Throws at the first event that the format
/// does not allow there.
class StrokeJsonReader : public nlohmann::json::json_sax_t
{
public:
    explicit StrokeJsonReader(std::string_view text) : m_text(text) {}
    std::vector<FileEntry> take() { return std::move(m_entries); }

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
    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) override;

private:
    using Kind = StrokeFileError::Kind;
    enum class Level { Start, File, Strokes, Stroke, Samples, Sample };

    [[noreturn]] void refuse(Kind kind, std::string_view value = {}) const;
    StrokeFileError errorHere(Kind kind, std::string key) const;
    std::string_view keyName() const;
    double inRange(double value, double min, double max, bool orZero = false) const;
    double inRange(double value, Parameter parameter) const;

    template <std::size_t N> void noteKey(const Keys<N>& keys, const std::string& name);
    template <std::size_t N> void requireKeys(const Keys<N>& keys);
    bool number(double value);
    void strokeNumber(double value);
    void sampleNumber(double value);
    void strokeWord(const std::string& word);
    std::size_t vectorLength() const;
    bool isColorKey() const { return m_level == Level::Stroke && (m_key == ColorKey || m_key == TagKey); }
    bool isPartList() const { return m_level == Level::Stroke && m_key == PartsKey; }
    PartId partIn(double value) const;
    double wholeIn(double value, double max) const;
    void endVector();
    void strokeVector(const Vec3& vector);
    Eigen::Quaterniond unitRotation() const;
    void endSample();
    void endStroke();
    bool isCommand() const { return m_seen & bit(CommandKey); }
    bool commandWord(const std::string& typed);
    void endCommand();
    KeySet insertKeys() const;
    KeySet primitiveKeys() const;
    void commandNumber(double value);
    void requireNoneOf(KeySet keys);
    /// Returns the entry that is being read. A command is stored as a stroke until its object ends: its color and
    /// detail_length are read into the stroke's settings.
    Stroke& stroke() { return std::get<Stroke>(m_entries.back()); }

    std::string_view m_text;
    std::vector<FileEntry> m_entries;
    CommandDraft m_command;
    Level m_level = Level::Start;
    int m_key = -1;                            ///< index of the current key in the keys of m_level; -1: none
    std::span<const std::string_view> m_words; ///< keywords allowed for the current key; empty: any text
    KeySet m_seen = 0;                         ///< keys read so far in the innermost object
    KeySet m_seenOuter = 0, m_seenStroke = 0;
    bool m_inOutline = false; ///< true between the outer brackets of a list of points
    bool m_inVector = false;  ///< true between the brackets of a list of numbers
    bool m_inProfile = false; ///< true between the outer brackets of a profile or a path
    std::size_t m_count = 0;  ///< numbers read so far in the open list
    std::array<double, 4> m_vector{};
    double m_turntable = 0;
    std::optional<std::size_t> m_undirected; ///< index of the stroke's first sample that has no direction
};
} // namespace core
