#pragma once

#include <QString>

#include <cstdint>

namespace ui
{
/// Returns a number with the separators of the user's language.
QString number(std::uint64_t n);

/// Returns a length in mm without its unit, with one to six decimals: as many as three significant figures need.
QString millimetres(double value);

/// Returns "12.5 cm³", or mm³ for volumes below 1 cm³. Precondition: `cubicMillimetres` is not negative.
QString volumeText(double cubicMillimetres);

/// Returns "12.5 cm²", or mm² for areas below 1 cm². Precondition: `squareMillimetres` is not negative.
QString areaText(double squareMillimetres);

/// Returns "1 h 05 min", "12 min" or "40 s": rounded to minutes, or to seconds below one minute. Precondition:
/// `seconds` is not negative.
QString durationText(double seconds);
} // namespace ui
