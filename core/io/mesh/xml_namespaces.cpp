// Source: W3C, Namespaces in XML 1.0.
#include "core/io/mesh/xml_namespaces.h"

#include <algorithm>

namespace core::io
{
namespace
{
constexpr std::string_view declaration = "xmlns";
} // namespace

void XmlNamespaces::begin(const char** pairs)
{
    ++m_depth;
    for (; *pairs; pairs += 2) {
        const std::string_view name(pairs[0]);
        if (name == declaration)
            m_declared.push_back({"", pairs[1], m_depth});
        else if (name.starts_with(declaration) && name[declaration.size()] == ':')
            m_declared.push_back({std::string(name.substr(declaration.size() + 1)), pairs[1], m_depth});
    }
}

void XmlNamespaces::end()
{
    while (!m_declared.empty() && m_declared.back().depth == m_depth)
        m_declared.pop_back();
    --m_depth;
}

std::string_view XmlNamespaces::element(std::string_view name)
{
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? joined({}, name) : joined(name.substr(0, colon), name.substr(colon + 1));
}

std::string_view XmlNamespaces::attribute(std::string_view name)
{
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : joined(name.substr(0, colon), name.substr(colon + 1));
}

std::string_view XmlNamespaces::spaceOf(std::string_view prefix) const
{
    const auto latest =
        std::find_if(m_declared.rbegin(), m_declared.rend(), [&](const Declared& d) { return d.prefix == prefix; });
    return latest == m_declared.rend() ? std::string_view() : latest->space;
}

std::string_view XmlNamespaces::joined(std::string_view prefix, std::string_view name)
{
    const std::string_view space = spaceOf(prefix);
    if (space.empty())
        return name;
    m_joined.assign(space).append("|").append(name);
    return m_joined;
}
} // namespace core::io
