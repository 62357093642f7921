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

/// "12.5 cm²", or mm² for what is small. `squareMillimetres` is not negative.
QString areaText(double squareMillimetres);

/// "1 h 05 min", "12 min", "40 s": no finer than a person would say it. `seconds` is not negative.
QString durationText(double seconds);
} // namespace ui
