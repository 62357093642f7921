#pragma once

#include "vr/simulator/call_failure.h"

#include <map>
#include <string>
#include <vector>

namespace simulator
{
/// The path strings of one instance and their numbers.
class Paths
{
public:
    /// Returns the number of a path, which is added if it is new. Fails if the text is not well-formed.
    XrPath number(const std::string& text);
    /// Returns the number of a path that was added before; 0: it was not.
    XrPath known(std::string_view text) const;
    const std::string& text(XrPath path) const;

    static bool isWellFormed(std::string_view path);
    /// Returns whether the name may be used between two slashes of a path, and as the name of an action.
    static bool isLevel(std::string_view name);

private:
    std::map<std::string, XrPath, std::less<>> m_numbers;
    std::vector<std::string> m_texts;
};
} // namespace simulator
