#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace core::io
{
/// Keeps the namespaces that prefixes stand for, as elements begin and end. A prefix that is not declared stands for
/// none: names with it belong to an extension that the file forgot to declare, and are not read.
class XmlNamespaces
{
public:
    /// Begins an element. `attributes`: pairs of name and value, null behind the last.
    void begin(const char** pairs);
    void end();

    /// Returns "namespace|name" of an element's or an attribute's name; the name alone where it has no namespace.
    /// Elements without a prefix have the default one, attributes none. The view lasts until the next call.
    std::string_view element(std::string_view name);
    std::string_view attribute(std::string_view name);

    /// Returns the namespace that the prefix stands for; empty if none. It lasts until the element ends.
    std::string_view spaceOf(std::string_view prefix) const;

private:
    struct Declared
    {
        std::string prefix, space;
        int depth;
    };
    std::string_view joined(std::string_view prefix, std::string_view name);

    std::vector<Declared> m_declared;
    int m_depth = 0;
    std::string m_joined;
};
} // namespace core::io
