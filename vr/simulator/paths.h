#pragma once

#include "vr/simulator/call_failure.h"

#include <map>
#include <string>
#include <vector>

namespace simulator
{
/// The paths of one instance and their numbers.
class Paths
{
public:
    /// Of a well-formed text, else fails.
    XrPath number(const std::string& text);
    /// The number it has already; 0: none.
    XrPath known(std::string_view text) const;
    const std::string& text(XrPath path) const;

    static bool isWellFormed(std::string_view path);
    /// What may stand between two slashes, and as an action's name.
    static bool isLevel(std::string_view name);

private:
    std::map<std::string, XrPath, std::less<>> m_numbers;
    std::vector<std::string> m_texts;
};
} // namespace simulator
