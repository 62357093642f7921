#include "ui/util/path_display.h"

#include "ui/util/format_filters.h"

#include "core/util/file_error.h"
#include "core/util/system_code.h"

#include <QLocale>

#include <algorithm>

namespace ui
{
namespace
{
namespace fs = std::filesystem;

bool isHidden(const fs::path& name)
{
    return name.native().starts_with('.');
}

/// Returns true for a regular file. An entry that may not be examined also counts, so that reading it reports the
/// reason.
bool mayBeFile(const fs::directory_entry& entry)
{
    std::error_code problem;
    const bool isFile = entry.is_regular_file(problem);
    return problem ? problem == std::errc::permission_denied : isFile;
}

bool isModelFile(const fs::directory_entry& entry, const QStringList& endings)
{
    const fs::path name = entry.path().filename();
    return !isHidden(name) && endings.contains(displayName(name.extension()).mid(1).toLower()) && mayBeFile(entry);
}

core::FileError unreadable(const fs::path& folder, const std::error_code& problem)
{
    const bool isGone = problem == std::errc::no_such_file_or_directory;
    core::FileError error(isGone ? core::FileErrorKind::NotFound : core::FileErrorKind::FolderNotReadable, folder);
    error.systemError = core::systemCodeOf(problem);
    return error;
}
} // namespace

QString displayName(const fs::path& path)
{
    const std::u8string bytes = path.u8string();
    return QString::fromUtf8(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
}

/// Returns the collator. Without a language set (C locale) it uses English, because the C locale sorts by bytes.
QCollator nameCollator()
{
    QCollator collator(QLocale().language() == QLocale::C ? QLocale(QLocale::English) : QLocale());
    collator.setNumericMode(true);
    collator.setCaseSensitivity(Qt::CaseInsensitive);
    return collator;
}

void sortByName(QList<fs::path>& files)
{
    const QCollator collator = nameCollator();
    std::ranges::sort(files, [&collator](const fs::path& a, const fs::path& b) {
        const int byName = collator.compare(displayName(a.filename()), displayName(b.filename()));
        return byName != 0 ? byName < 0 : a < b;
    });
}

QList<fs::path> modelsIn(const fs::path& folder)
{
    const QStringList endings = modelEndings();
    QList<fs::path> files;
    std::error_code problem;
    for (fs::directory_iterator at(folder, problem); !problem && at != fs::directory_iterator(); at.increment(problem))
        if (isModelFile(*at, endings))
            files << at->path();
    if (problem)
        throw unreadable(folder, problem);
    if (files.isEmpty())
        throw core::FileError(core::FileErrorKind::NoModel, folder);
    sortByName(files);
    return files;
}
} // namespace ui
