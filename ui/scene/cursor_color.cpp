#include "ui/scene/cursor_color.h"

namespace ui
{
namespace
{
constexpr QColor inverted(150, 205, 255);
} // namespace

QColor cursorColor(const core::StrokeSettings& stroke)
{
    if (stroke.inverted)
        return inverted;
    static constexpr QColor colors[] = {{255, 246, 232}, inverted,        {255, 206, 178}, {232, 178, 150},
                                        {255, 196, 120}, {246, 224, 140}, {222, 240, 140}, {176, 240, 176},
                                        {255, 180, 200}, {255, 150, 150}, {150, 240, 226}, {120, 224, 170},
                                        {198, 186, 255}, {160, 214, 150}, {236, 176, 236}, {176, 184, 204}};
    static_assert(std::size(colors) == core::toolNames().size());
    return colors[static_cast<std::size_t>(stroke.tool)];
}
} // namespace ui
