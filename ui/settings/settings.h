#pragma once

#include "ui/settings/settings_table.h"

#include "core/stroke/tool.h"

#include <QSettings>
#include <QVariant>

#include <functional>
#include <vector>

namespace ui
{
inline constexpr core::Parameter storedParameters[] = {core::Parameter::Strength, core::Parameter::Falloff,
                                                       core::Parameter::Detail, core::Parameter::Spacing};

/// Reads and writes the stored settings by their table (settings_table.h). A missing or invalid entry gives the
/// default. Precondition: the program has set the organisation and application names. Thread: gui.
class Settings
{
public:
    /// Returns one setting: get(&Setting::turnSpeed).
    template <class T> T get(T Setting::*what) const
    {
        Setting all;
        forEachRow<Setting>([&](const auto& row) {
            if (isRowOf(row, what))
                read({}, row, all);
        });
        return all.*what;
    }

    template <class T> void set(T Setting::*what, const std::type_identity_t<T>& value)
    {
        Setting all;
        all.*what = value;
        forEachRow<Setting>([&](const auto& row) {
            if (isRowOf(row, what))
                write({}, row, all);
        });
    }

    /// Returns a struct of settings: get<ViewAppearance>(). `group`: prefix of the stored keys, ending in '/', for
    /// structs that are stored several times. `otherwise`: values of entries that are missing or invalid.
    template <class S> S get(const QString& group = {}, const S& otherwise = {}) const
    {
        return readAll<S>(group, otherwise);
    }
    template <class S>
    requires(std::is_class_v<S>) void set(const S& settings, const QString& group = {}) { writeAll(group, settings); }

    /// Returns the recent files, latest first.
    QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    /// Returns the folder of the last file opened or exported, or the user's home if there is none, or it no longer
    /// exists or does not answer within half a second.
    QString lastFolder() const;
    /// Returns the settings of the files panel, with lastFolder() in place of a folder that no longer exists.
    FileBrowserSettings files() const;

    /// Returns a stored parameter of the brush, except the radius (Setting::radiusShare).
    double value(core::Parameter parameter) const;
    void setValue(core::Parameter parameter, double value);

    /// Resets everything except what the user created: recent files and folder, swatches, brush files, printers. Then
    /// calls the functions given to onReset(), in order.
    void reset();
    /// Adds a function for reset() to call, which must apply the current settings.
    void onReset(std::function<void()> applySettings);

private:
    template <class S, class Function> static void forEachRow(const Function& function)
    {
        std::apply([&](const auto&... row) { (function(row), ...); }, stored::rows<S>);
    }

    template <class T, class U> static bool isRowOf(const stored::Row<Setting, T>& row, U Setting::*what)
    {
        if constexpr (std::is_same_v<T, U>)
            return row.member == what;
        else
            return false;
    }

    template <class S> S readAll(const QString& group, S settings = {}) const
    {
        forEachRow<S>([&](const auto& row) { read(group, row, settings); });
        return settings;
    }

    template <class S> void writeAll(const QString& group, const S& settings)
    {
        forEachRow<S>([&](const auto& row) { write(group, row, settings); });
    }

    template <class S, class T> void read(const QString& group, const stored::Row<S, T>& row, S& settings) const
    {
        const QString key = group + QLatin1StringView(row.key);
        T& value = settings.*row.member;
        if constexpr (std::is_same_v<T, bool>)
            value = stored::yesNo(m_settings, key, value);
        else if constexpr (std::is_enum_v<T>)
            value = stored::choice(m_settings, key, row.valid, value);
        else if constexpr (std::is_arithmetic_v<T>)
            value = static_cast<T>(
                stored::number(m_settings, key, row.valid.min, row.valid.max, static_cast<double>(value)));
        else
            stored::read(m_settings, key, value);
    }

    template <class S, class T> void read(const QString& group, const stored::Part<S, T>& part, S& settings) const
    {
        settings.*part.member = readAll<T>(group);
    }

    template <class S, class T> void write(const QString& group, const stored::Row<S, T>& row, const S& settings)
    {
        const QString key = group + QLatin1StringView(row.key);
        if constexpr (std::is_enum_v<T>)
            m_settings.setValue(key, stored::wordFor(settings.*row.member, row.valid));
        else
            stored::write(m_settings, key, settings.*row.member);
    }

    template <class S, class T> void write(const QString& group, const stored::Part<S, T>& part, const S& settings)
    {
        writeAll(group, settings.*part.member);
    }

    QSettings m_settings;
    std::vector<std::function<void()>> m_onReset;
};
} // namespace ui
