#pragma once

#include "ui/settings/printer_presets.h"
#include "ui/settings/view_appearance.h"

#include "core/geometry/geometry.h"

#include <QList>
#include <QMap>
#include <QSettings>
#include <QString>
#include <QVariant>

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>

/// Reading and writing of stored values. A missing or invalid value gives the default.
namespace ui::stored
{
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

/// The values of an enumeration and their stored names.
template <class T> using Words = std::type_identity_t<std::span<const Named<T>>>;

template <class T> T choice(const QSettings& settings, const QString& key, Words<T> words, T otherwise)
{
    const QString stored = settings.value(key).toString();
    const auto found =
        std::ranges::find_if(words, [&](const Named<T>& row) { return stored == QLatin1StringView(row.key); });
    return found != words.end() ? found->value : otherwise;
}

template <class T> QString wordFor(T value, Words<T> words)
{
    return QLatin1StringView(std::ranges::find(words, value, &Named<T>::value)->key);
}

/// Reads a type that QVariant supports: text, list of texts, bytes. Without an entry, `value` is unchanged.
template <class T> void read(const QSettings& settings, const QString& key, T& value)
{
    if (settings.contains(key))
        value = settings.value(key).value<T>();
}

template <class T> void write(QSettings& settings, const QString& key, const T& value)
{
    settings.setValue(key, value);
}

/// Reads colours and skips invalid ones. A stored list may be empty. Without an entry, `colors` is unchanged.
void read(const QSettings& settings, const QString& key, QList<core::Rgb>& colors);
void write(QSettings& settings, const QString& key, const QList<core::Rgb>& colors);
/// Reads printers. Without a valid printer, `printers` is unchanged.
void read(const QSettings& settings, const QString& key, QList<PrinterPreset>& printers);
void write(QSettings& settings, const QString& key, const QList<PrinterPreset>& printers);
/// Reads and writes texts by name in a settings group of their own, which writing replaces as a whole.
void read(const QSettings& settings, const QString& group, QMap<QString, QString>& texts);
void write(QSettings& settings, const QString& group, const QMap<QString, QString>& texts);
} // namespace ui::stored
