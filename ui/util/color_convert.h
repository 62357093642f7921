#pragma once

#include "core/geometry/geometry.h"

#include <QColor>

namespace ui
{
inline QColor toQt(const core::Rgb& color)
{
    return {color.r, color.g, color.b};
}

inline core::Rgb toRgb(const QColor& color)
{
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    return {byte(color.red()), byte(color.green()), byte(color.blue())};
}
} // namespace ui
