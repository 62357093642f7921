#include "core/io/mesh/object_labels.h"

#include <algorithm>
#include <limits>

namespace core::io
{
namespace
{
/// Returns the length of the UTF-8 character at the start of the text, 0 if there is none (RFC 3629).
std::size_t characterLength(std::string_view text)
{
    const auto byteAt = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byteAt(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    if (length > text.size())
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byteAt(i) & 0xc0) != 0x80)
            return 0;
    const bool isTooLong = length > 2 && ((first == 0xe0 && byteAt(1) < 0xa0) || (first == 0xf0 && byteAt(1) < 0x90));
    const bool isSurrogate = first == 0xed && byteAt(1) >= 0xa0;
    const bool isTooLarge = first == 0xf4 && byteAt(1) >= 0x90;
    return isTooLong || isSurrogate || isTooLarge ? 0 : length;
}
} // namespace

std::string cleanName(std::string_view name)
{
    constexpr unsigned char del = 0x7f;
    std::string clean;
    while (!name.empty() && clean.size() <= PartList::maxNameBytes) {
        const auto first = static_cast<unsigned char>(name.front());
        const std::size_t length = characterLength(name);
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
