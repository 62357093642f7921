#include "vr/simulator/paths.h"

#include <algorithm>

namespace simulator
{
bool Paths::isLevel(std::string_view name)
{
    const auto isAllowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    };
    return std::all_of(name.begin(), name.end(), isAllowed) && name.find_first_not_of('.') != std::string_view::npos;
}

bool Paths::isWellFormed(std::string_view path)
{
    if (path.empty() || path.size() >= XR_MAX_PATH_LENGTH || path.front() != '/')
        return false;
    while (!path.empty()) {
        path.remove_prefix(1);
        const std::size_t end = std::min(path.find('/'), path.size());
        if (!isLevel(path.substr(0, end)))
            return false;
        path.remove_prefix(end);
    }
    return true;
}

XrPath Paths::number(const std::string& text)
{
    require(isWellFormed(text), XR_ERROR_PATH_FORMAT_INVALID, "the path is not well-formed");
    const auto [it, isNew] = m_numbers.emplace(text, m_texts.size() + 1);
    if (isNew)
        m_texts.push_back(text);
    return it->second;
}

XrPath Paths::known(std::string_view text) const
{
    const auto found = m_numbers.find(text);
    return found == m_numbers.end() ? XR_NULL_PATH : found->second;
}

const std::string& Paths::text(XrPath path) const
{
    require(path != XR_NULL_PATH && path <= m_texts.size(), XR_ERROR_PATH_INVALID, "the path is null or unknown");
    return m_texts[path - 1];
}
} // namespace simulator
