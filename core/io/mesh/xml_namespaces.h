#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace core::io
{
/// Tracks the namespaces of prefixes while elements begin and end. An undeclared prefix has no namespace: such names
/// belong to an extension that the file forgot to declare, and are not read.
class XmlNamespaces
{
public:
    /// Begins an element. `pairs`: names and values of its attributes in turn, followed by null.
    void begin(const char** pairs);
    void end();

    /// Returns "namespace|name" for the name of an element or an attribute; the name alone if it has no namespace.
    /// Elements without a prefix are in the default namespace, such attributes in none. The view is valid until the
    /// next call.
    std::string_view element(std::string_view name);
    std::string_view attribute(std::string_view name);

    /// Returns the namespace of a prefix; empty if it has none. The view is valid until the element ends.
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
