#include "core/io/mesh/object_labels.h"

#include "core/io/mesh/format.h"

#include <algorithm>
#include <limits>

namespace core::io
{
std::string cleanName(std::string_view name)
{
    constexpr unsigned char del = 0x7f;
    std::string clean;
    while (!name.empty() && clean.size() <= PartList::maxNameBytes) {
        const auto first = static_cast<unsigned char>(name.front());
        const std::size_t length = utf8Length(name);
        const bool isControl =
            first < ' ' || first == del || (length == 2 && first == 0xc2 && static_cast<unsigned char>(name[1]) < 0xa0);
        const bool isNoCharacter =
            name.starts_with("\xef\xbf\xbe") || name.starts_with("\xef\xbf\xbf"); // U+FFFE, U+FFFF
        if (length == 0)
            clean += '?';
        else if (isControl || isNoCharacter)
            clean += ' ';
        else
            clean += name.substr(0, length);
        if (clean == " ") // at the beginning
            clean.clear();
        name.remove_prefix(std::max<std::size_t>(length, 1));
    }
    clean = shortened(std::move(clean));
    clean.erase(clean.find_last_not_of(' ') + 1);
    return clean;
}

void leaveOutPart(ReadRemarks& remarks, bool isNegative, std::string_view name)
{
    constexpr std::size_t maxNames = 3, maxBytes = 40;
    ++(isNegative ? remarks.negativeParts : remarks.otherParts);
    std::vector<std::string>& names = isNegative ? remarks.negativeNames : remarks.otherNames;
    std::string clean = cleanName(shortened(cleanName(name), maxBytes));
    if (!clean.empty() && names.size() < maxNames && std::ranges::find(names, clean) == names.end())
        names.push_back(std::move(clean));
}

void ObjectLabels::begin(std::string_view name)
{
    if (!m_isOn)
        return;
    m_isOn = m_names.size() <= std::numeric_limits<PartId>::max();
    m_names.push_back(cleanName(name));
}

void ObjectLabels::label(TriangleMesh& mesh) const
{
    if (m_isOn)
        mesh.parts.resize(mesh.points.size(), static_cast<PartId>(m_names.size() - 1));
}

PartList ObjectLabels::finish(TriangleMesh& mesh) const
{
    std::vector<bool> hasFaces(m_names.size(), false);
    for (const Triangle& t : mesh.triangles)
        if (m_isOn)
            hasFaces[mesh.parts[t[0]]] = true;
    const auto count = static_cast<std::size_t>(std::ranges::count(hasFaces, true));
    if (count < 2 || count > PartList::maxParts) {
        mesh.parts.clear();
        return {};
    }
    std::vector<PartId> idOf(m_names.size(), 0);
    std::vector<Part> parts;
    for (std::size_t object = 0; object < m_names.size(); ++object) {
        if (!hasFaces[object])
            continue;
        idOf[object] = static_cast<PartId>(parts.size());
        parts.push_back({idOf[object], m_names[object], true, false, std::nullopt});
    }
    for (PartId& label : mesh.parts)
        label = idOf[label];
    return PartList(std::move(parts));
}

bool ObjectLabels::finishAs(const PartList& parts, TriangleMesh& mesh) const
{
    if (!m_isOn || m_names.size() != parts.size())
        return false;
    for (PartId& label : mesh.parts)
        label = parts.all()[label].id;
    if (std::ranges::all_of(mesh.parts, [](PartId part) { return part == 0; }))
        mesh.parts.clear();
    return true;
}
} // namespace core::io
