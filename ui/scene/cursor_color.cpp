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
    switch (stroke.tool) {
    case core::Tool::Pull:
        return {255, 246, 232};
    case core::Tool::Push:
        return inverted;
    case core::Tool::Inflate:
        return {255, 206, 178};
    case core::Tool::Clay:
        return {232, 178, 150};
    case core::Tool::Layer:
        return {255, 196, 120};
    case core::Tool::Flatten:
        return {246, 224, 140};
    case core::Tool::Scrape:
        return {222, 240, 140};
    case core::Tool::Smooth:
        return {176, 240, 176};
    case core::Tool::Pinch:
        return {255, 180, 200};
    case core::Tool::Crease:
        return {255, 150, 150};
    case core::Tool::Grab:
        return {150, 240, 226};
    case core::Tool::SnakeHook:
        return {120, 224, 170};
    case core::Tool::Twist:
        return {198, 186, 255};
    case core::Tool::Stamp:
        return {160, 214, 150};
    case core::Tool::Paint:
        return {236, 176, 236};
    case core::Tool::Mask:
        return {176, 184, 204};
    }
    return Qt::white;
}
} // namespace ui
