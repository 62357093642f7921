#include "ui/settings/settings.h"

#include <QDir>

#include <chrono>
#include <future>
#include <memory>
#include <thread>

namespace ui
{
namespace
{
constexpr qsizetype maxRecentFiles = 10;

QString keyOf(core::Parameter parameter)
{
    const std::string_view key = core::info(parameter).key;
    return QStringLiteral("brush/") + QLatin1StringView(key.data(), static_cast<qsizetype>(key.size()));
}

double defaultOf(core::Parameter parameter)
{
    return parameter == core::Parameter::Spacing ? defaultSpacing : core::info(parameter).defaultValue;
}

/// Returns true if the folder exists and its disk answers within 500 ms; a lost server's disk does not.
bool isThere(const QString& folder)
{
    constexpr auto longest = std::chrono::milliseconds(500);
    if (folder.isEmpty())
        return false;
    auto answer = std::make_shared<std::promise<bool>>();
    std::future<bool> isFolder = answer->get_future();
    std::thread([answer, folder] { answer->set_value(QDir(folder).exists()); }).detach();
    return isFolder.wait_for(longest) == std::future_status::ready && isFolder.get();
}

template <class S, class T> void addKept(const stored::Row<S, T>& row, QStringList& keys)
{
    if (row.reset == stored::Reset::Keep)
        keys << QLatin1StringView(row.key);
}

QStringList keptKeys()
{
    QStringList keys;
    const auto add = [&](const auto&... row) { (addKept(row, keys), ...); };
    std::apply(add, stored::rows<Setting>);
    std::apply(add, stored::rows<StoredShapes>);
    return keys;
}
} // namespace

QList<core::Rgb> firstSwatches()
{
    return {{200, 110, 80}, {138, 90, 60},  {242, 227, 204}, {255, 255, 255}, {128, 128, 128}, {32, 32, 32},
            {216, 58, 52},  {240, 180, 41}, {76, 154, 74},   {47, 111, 181},  {122, 79, 160}};
}

QStringList Settings::recentFiles() const
{
    return get(&Setting::recentFiles).mid(0, maxRecentFiles);
}

void Settings::addRecentFile(const QString& path)
{
    QStringList paths = recentFiles();
    paths.removeAll(path);
    paths.prepend(path);
    set(&Setting::recentFiles, paths.mid(0, maxRecentFiles));
}

QString Settings::lastFolder() const
{
    const QString folder = get(&Setting::lastFolder);
    return isThere(folder) ? folder : QDir::homePath();
}

FileBrowserSettings Settings::files() const
{
    FileBrowserSettings files = get<FileBrowserSettings>();
    if (!isThere(files.folder))
        files.folder = lastFolder();
    return files;
}

double Settings::value(core::Parameter parameter) const
{
    const core::ParameterInfo& row = core::info(parameter);
    return stored::number(m_settings, keyOf(parameter), row.min, row.max, defaultOf(parameter));
}

void Settings::setValue(core::Parameter parameter, double value)
{
    m_settings.setValue(keyOf(parameter), value);
}

void Settings::reset()
{
    const QStringList kept = keptKeys();
    for (const QString& key : m_settings.allKeys())
        if (!kept.contains(key))
            m_settings.remove(key);
    for (const auto& applySettings : m_onReset)
        applySettings();
}

void Settings::onReset(std::function<void()> applySettings)
{
    m_onReset.push_back(std::move(applySettings));
}
} // namespace ui
