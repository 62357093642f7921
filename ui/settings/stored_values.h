#pragma once

#include "ui/settings/shortcut_preset.h"

#include <QSettings>
#include <QString>

#include <algorithm>
#include <cmath>

/// How the parts of Settings read what is stored: what is missing or makes no sense gives the default.
namespace ui::stored
{
// What a person made, which Settings::reset() leaves.
inline const QString alphaFilesKey = QStringLiteral("brush/alphaFiles");
inline const QString modelFilesKey = QStringLiteral("brush/modelFiles");
inline const QString swatchesKey = QStringLiteral("color/swatches");
inline const QString referenceKeys = QStringLiteral("reference/"); ///< and the side

inline double number(const QSettings& settings, const QString& key, double min, double max, double otherwise)
{
    bool ok = false;
    const double stored = settings.value(key).toDouble(&ok);
    return ok && std::isfinite(stored) && stored >= min && stored <= max ? stored : otherwise;
}

inline bool yesNo(const QSettings& settings, const QString& key, bool otherwise)
{
    const QString stored = settings.value(key).toString();
    return stored == QLatin1StringView("true") || (stored != QLatin1StringView("false") && otherwise);
}

template <class T, std::size_t count>
T choice(const QSettings& settings, const QString& key, const std::array<Named<T>, count>& choices, T otherwise)
{
    const QString stored = settings.value(key).toString();
    const auto found =
        std::ranges::find_if(choices, [&](const Named<T>& row) { return stored == QLatin1StringView(row.key); });
    return found != choices.end() ? found->value : otherwise;
}

template <class T, std::size_t count> QString wordFor(T value, const std::array<Named<T>, count>& choices)
{
    return QLatin1StringView(std::ranges::find(choices, value, &Named<T>::value)->key);
}
} // namespace ui::stored
