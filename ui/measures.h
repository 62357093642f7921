#pragma once

#include <QString>

#include <cstdint>

namespace ui
{
/// With the separators of the person's language.
QString number(std::uint64_t n);

/// A length in mm, without its unit: four figures at least, tenths at most for what people hold in their hands.
QString millimetres(double value);

/// "12.5 cm³", or mm³ for what is small. `cubicMillimetres` is not negative.
QString volumeText(double cubicMillimetres);
} // namespace ui
