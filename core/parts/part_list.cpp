#include "core/parts/part_list.h"

#include <algorithm>
#include <cassert>

namespace core
{
PartList::PartList(std::vector<Part> parts)
{
    assert(isUsable(parts));
    if (parts != PartList().all())
        m_parts = std::make_shared<const std::vector<Part>>(std::move(parts));
}

bool PartList::isUsable(const std::vector<Part>& parts)
{
    std::vector<PartId> ids;
    for (const Part& part : parts)
        ids.push_back(part.id);
    std::ranges::sort(ids);
    return !parts.empty() && parts.size() <= maxParts && std::ranges::adjacent_find(ids) == ids.end() &&
           std::ranges::all_of(parts, [](const Part& part) { return part.name.size() <= maxNameBytes; });
}

const std::vector<Part>& PartList::all() const
{
    static const std::vector<Part> first(1);
    return m_parts ? *m_parts : first;
}

const Part* PartList::find(PartId id) const
{
    const auto found = std::ranges::find(all(), id, &Part::id);
    return found == all().end() ? nullptr : &*found;
}

bool PartList::isVisible(PartId id) const
{
    const Part* part = find(id);
    return part && part->isVisible;
}

bool PartList::isEditable(PartId id) const
{
    const Part* part = find(id);
    return part && part->isVisible && !part->isLocked;
}

PartId PartList::freeId() const
{
    PartId id = 0;
    while (find(id))
        ++id;
    return id;
}

std::string PartList::freeName(const std::string& name) const
{
    constexpr std::size_t numberBytes = 5; // a space and up to four digits, because there are at most 1000 names
    const auto isTaken = [this](const std::string& tried) {
        return std::ranges::find(all(), tried, &Part::name) != all().end();
    };
    const std::string plain = shortened(name);
    if (plain.empty() || !isTaken(plain))
        return plain;
    const std::string start = shortened(plain, maxNameBytes - numberBytes) + ' ';
    std::size_t number = 2;
    while (isTaken(start + std::to_string(number)))
        ++number;
    return start + std::to_string(number);
}

PartList PartList::with(Part part) const
{
    std::vector<Part> parts = all();
    const auto found = std::ranges::find(parts, part.id, &Part::id);
    if (found == parts.end())
        parts.push_back(std::move(part));
    else
        *found = std::move(part);
    return PartList(std::move(parts));
}

PartList PartList::without(const std::vector<PartId>& ids) const
{
    std::vector<Part> parts = all();
    std::erase_if(parts, [&](const Part& part) { return std::ranges::find(ids, part.id) != ids.end(); });
    return PartList(std::move(parts));
}

std::string shortened(std::string name, std::size_t maxBytes)
{
    if (name.size() <= maxBytes)
        return name;
    std::size_t end = maxBytes;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) // inside a character
        --end;
    name.resize(end);
    return name;
}
} // namespace core
