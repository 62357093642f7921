#include "ui/util/number_format.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace ui
{
namespace
{
struct NumberFormat
{
    Q_DECLARE_TR_FUNCTIONS(ui::NumberFormat)
};
} // namespace

QString number(std::uint64_t n)
{
    return QLocale().toString(static_cast<qulonglong>(n));
}

QString millimetres(double value)
{
    const double size = std::max(std::abs(value), 1e-6);
    const int decimals = value == 0 ? 1 : std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 1, 6);
    return QLocale().toString(value, 'f', decimals);
}

QString volumeText(double cubicMillimetres)
{
    return cubicMillimetres < 1000 ? NumberFormat::tr("%1 mm³").arg(millimetres(cubicMillimetres))
                                   : NumberFormat::tr("%1 cm³").arg(millimetres(cubicMillimetres / 1000));
}

QString areaText(double squareMillimetres)
{
    return squareMillimetres < 100 ? NumberFormat::tr("%1 mm²").arg(millimetres(squareMillimetres))
                                   : NumberFormat::tr("%1 cm²").arg(millimetres(squareMillimetres / 100));
}

QString durationText(double seconds)
{
    constexpr qint64 minute = 60, hour = 60 * minute;
    const auto whole = static_cast<qint64>(std::llround(seconds));
    if (whole < minute)
        return NumberFormat::tr("%1 s").arg(QLocale().toString(whole));
    const qint64 minutes = (whole + minute / 2) / minute * minute;
    if (minutes < hour)
        return NumberFormat::tr("%1 min").arg(QLocale().toString(minutes / minute));
    return NumberFormat::tr("%1 h %2 min")
        .arg(QLocale().toString(minutes / hour))
        .arg(minutes % hour / minute, 2, 10, QLatin1Char('0'));
}
} // namespace ui
