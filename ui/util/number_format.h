#pragma once

#include <QString>

#include <cstdint>

namespace ui
{
/// Returns a number with the separators of the user's language.
QString number(std::uint64_t n);

/// Returns a length in mm without its unit, with at least three significant figures and at least one decimal.
QString millimetres(double value);

/// Returns "12.5 cm³", or mm³ for small volumes. Precondition: `cubicMillimetres` is not negative.
QString volumeText(double cubicMillimetres);

/// Returns "12.5 cm²", or mm² for small areas. Precondition: `squareMillimetres` is not negative.
QString areaText(double squareMillimetres);

/// Returns "1 h 05 min", "12 min" or "40 s", rounded as in speech. Precondition: `seconds` is not negative.
QString durationText(double seconds);
} // namespace ui
