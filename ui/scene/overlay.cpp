#include "ui/scene/overlay.h"

#include <algorithm>
#include <string_view>

namespace ui
{
void Overlay::set(const char* name, const Value& value)
{
    const auto found = std::ranges::find_if(
        m_uniforms, [&](const Uniform& uniform) { return std::string_view(uniform.name) == name; });
    if (found == m_uniforms.end())
        m_uniforms.push_back({name, value});
    else
        found->value = value;
}
} // namespace ui
