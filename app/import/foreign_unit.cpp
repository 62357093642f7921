// Source: Terathon Software, Open Game Engine Exchange Specification 1.1, "Metric": "distance" is the unit in metres,
// and "up" is "y" or "z". Assimp (5.2 to 6.0) reads these values but ignores them.
#include "app/import/foreign_unit.h"

#include "app/import/import_folder.h"

#include "core/io/mesh/format.h"
#include "core/io/mesh/number_parsing.h"

#include <algorithm>

namespace app
{
namespace
{
/// Extensions of formats that are in metres by specification. LWS counts because it refers to LWO files.
constexpr std::string_view endingsInMetres[] = {".dae", ".zae", ".x3d", ".lwo", ".lws", ".ifc"};
constexpr double millimetresInMetre = 1000;

/// Splits OpenDDL text into words and single punctuation characters. Skips comments.
class DdlWords
{
public:
    explicit DdlWords(std::string_view text) : m_rest(text) {}

    /// Returns the next word without its quotes; empty at the end of the text.
    std::string_view next()
    {
        skip();
        if (m_rest.empty())
            return {};
        constexpr std::string_view ends = " \t\r\n{}()[]=,\"";
        if (m_rest.front() == '"') {
            const std::size_t end = std::min(m_rest.find('"', 1), m_rest.size());
            return take(end + 1).substr(1, end - 1);
        }
        return take(std::max<std::size_t>(std::min(m_rest.find_first_of(ends), m_rest.size()), 1));
    }

private:
    std::string_view take(std::size_t length)
    {
        const std::string_view word = m_rest.substr(0, length);
        m_rest.remove_prefix(word.size());
        return word;
    }
    void skip()
    {
        while (true) {
            m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\r\n"), m_rest.size()));
            if (m_rest.starts_with("//"))
                take(m_rest.find('\n'));
            else if (m_rest.starts_with("/*"))
                take(m_rest.find("*/") == std::string_view::npos ? m_rest.size() : m_rest.find("*/") + 2);
            else
                return;
        }
    }

    std::string_view m_rest;
};

/// Returns the value of `Metric (key = "name") {type {value}}`; a view of null if there is none.
std::string_view metricOf(std::string_view text, std::string_view name)
{
    DdlWords words(text);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (word != "Metric" || words.next() != "(" || words.next() != "key" || words.next() != "=" ||
            words.next() != name)
            continue;
        std::string_view value;
        for (word = words.next(); !word.empty() && word != "}"; word = words.next())
            value = word;
        return value;
    }
    return {};
}

[[noreturn]] void refuse(core::FileFault fault, const core::io::FileBytes& file, std::string_view value)
{
    throw core::io::malformed(fault, core::io::errorAtLine({}, file, value.data(), value));
}

Eigen::Matrix4d placeOfOpenGex(const core::io::FileBytes& file)
{
    Eigen::Matrix4d place = Eigen::Matrix4d::Identity();
    if (const std::string_view up = metricOf(file.bytes, "up"); up == "z")
        place << 1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1;
    else if (up.data() && up != "y")
        refuse(core::FileFault::UpAxis, file, up);
    if (const std::string_view distance = metricOf(file.bytes, "distance"); distance.data()) {
        const double metres = core::io::parseDouble(distance).value_or(0);
        if (metres <= 0)
            refuse(core::FileFault::PositiveNumber, file, distance);
        place.topRows<3>() *= millimetresInMetre * metres;
    }
    return place;
}

bool isInMetres(const std::string& ending)
{
    return std::ranges::find(endingsInMetres, ending) != std::end(endingsInMetres);
}
} // namespace

Eigen::Matrix4d placeOf(const std::filesystem::path& file, std::string_view start)
{
    const std::string ending = lowerEnding(file);
    if (ending == ".ogex")
        return placeOfOpenGex({file, start});
    const double unit = isInMetres(ending) ? millimetresInMetre : 1;
    return Eigen::Vector4d(unit, unit, unit, 1).asDiagonal();
}

bool holdsUnit(const std::filesystem::path& file)
{
    const std::string ending = lowerEnding(file);
    return ending == ".fbx" || ending == ".ogex" || isInMetres(ending);
}
} // namespace app
