#include "ui/files/file_jobs.h"

#include "ui/files/trash.h"
#include "ui/util/error_messages.h"
#include "ui/util/format_filters.h"

#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace ui
{
namespace
{
FileEntry entryFrom(const QFileInfo& file)
{
    return {file.absoluteFilePath(), file.isDir(), file.size(), file.lastModified().toMSecsSinceEpoch()};
}

bool isModel(const QFileInfo& file)
{
    return modelEndings().contains(file.suffix().toLower());
}

QString inFolder(const QFileInfo& file, const QString& base)
{
    return file.dir().absoluteFilePath(file.suffix().isEmpty() ? base
                                                               : QStringLiteral("%1.%2").arg(base, file.suffix()));
}
} // namespace

FolderContent FileJobs::list(const QString& folder, const std::stop_token& stop)
{
    FolderContent content{folder, {}, {}};
    const QFileInfo info(folder);
    if (!info.exists())
        content.problem = notThere(folder);
    else if (!info.isDir())
        content.problem = tr("%1 is not a folder.").arg(QDir::toNativeSeparators(folder));
    else if (!info.isReadable() || !info.isExecutable())
        content.problem = tr("%1 cannot be opened: permission denied.").arg(QDir::toNativeSeparators(folder));
    if (!content.problem.isEmpty())
        return content;
    QDirIterator each(folder, QDir::AllDirs | QDir::Files | QDir::NoDotAndDotDot);
    while (each.hasNext() && !stop.stop_requested()) {
        each.next();
        const QFileInfo file = each.fileInfo();
        if (file.isDir() || isModel(file))
            content.entries << entryFrom(file);
    }
    return content;
}

FileEntry FileJobs::entryOf(const QString& path)
{
    return entryFrom(QFileInfo(path));
}

FileOutcome FileJobs::rename(const QString& path, const QString& name)
{
    const QFileInfo file(path);
    const QString base = name.trimmed(), target = inFolder(file, base);
    if (const QString problem = nameProblem(base); !problem.isEmpty())
        return {problem, {}};
    if (target == file.absoluteFilePath())
        return {{}, {target}};
    if (const QString problem = changeProblem(path); !problem.isEmpty())
        return {problem, {}};
    const QFileInfo other(target);
    if (other.exists() || other.isSymLink())
        return {tr("There is a file named %1 already; %2 keeps its name.").arg(other.fileName(), file.fileName()), {}};
    QFile handle(path);
    if (!handle.rename(target))
        return {tr("%1 could not be renamed (%2).").arg(file.fileName(), handle.errorString()), {}};
    return {{}, {target}};
}

/// Returns why the name is forbidden on Windows, macOS or Linux; empty: allowed on all.
QString FileJobs::nameProblem(const QString& name)
{
    static const QRegularExpression forbidden(QStringLiteral("[/\\\\:*?\"<>|]")),
        control(QStringLiteral("[\\x00-\\x1f]"));
    static const QRegularExpression device(QStringLiteral("^(con|prn|aux|nul|com[1-9]|lpt[1-9])(\\..*)?$"),
                                           QRegularExpression::CaseInsensitiveOption);
    if (name.isEmpty())
        return tr("A file needs a name.");
    if (const auto match = forbidden.match(name); match.hasMatch())
        return tr("A file name may not contain %1.").arg(match.captured());
    if (name.contains(control))
        return tr("A file name may not contain control characters.");
    if (name.startsWith(QLatin1Char('.')) || device.match(name).hasMatch())
        return tr("%1 cannot be a file's name.").arg(name);
    return {};
}

FileOutcome FileJobs::duplicate(const QStringList& paths)
{
    FileOutcome outcome;
    for (const QString& path : paths) {
        const QFileInfo file(path);
        QFile handle(path);
        const QString target = copyOf(path);
        if (const QString problem = changeProblem(path); !problem.isEmpty())
            outcome.sentence = problem;
        else if (handle.copy(target))
            outcome.paths << target;
        else
            outcome.sentence = tr("%1 could not be duplicated (%2).").arg(file.fileName(), handle.errorString());
    }
    return outcome;
}

/// Returns the first free path for a copy. The copy of a copy gets the next number instead of a second suffix.
QString FileJobs::copyOf(const QString& path)
{
    const QFileInfo file(path);
    const QString suffix = tr(" copy", "behind the name of a file that was duplicated");
    static const QRegularExpression number(QStringLiteral(" \\d+$"));
    QString base = file.completeBaseName(), plain = base;
    plain.remove(number);
    if (plain.endsWith(suffix))
        base = plain.chopped(suffix.size());
    QString target = inFolder(file, base + suffix);
    for (int i = 2; QFileInfo::exists(target) || QFileInfo(target).isSymLink(); ++i)
        target = inFolder(file, base + suffix + QStringLiteral(" %1").arg(i));
    return target;
}

QString FileJobs::numberedCopyOf(const QString& path)
{
    static const QRegularExpression number(QStringLiteral("-(\\d{3,9})$"));
    const QFileInfo file(path);
    const QString base = file.completeBaseName().remove(number);
    int last = 0;
    for (const QFileInfo& other : file.dir().entryInfoList(QDir::Files | QDir::Hidden)) {
        const QRegularExpressionMatch match = number.match(other.completeBaseName());
        if (match.hasMatch() && other.completeBaseName().startsWith(base) && match.capturedStart() == base.size())
            last = std::max(last, match.capturedView(1).toInt());
    }
    return file.dir().filePath(
        QStringLiteral("%1-%2.%3").arg(base).arg(last + 1, 3, 10, QLatin1Char('0')).arg(file.suffix()));
}

FileOutcome FileJobs::trash(const QStringList& paths)
{
    FileOutcome outcome;
    int moved = 0;
    for (const QString& path : paths) {
        const QFileInfo file(path);
        if (const QString problem = changeProblem(path); !problem.isEmpty())
            outcome.sentence = problem;
        else if (moveToTrash(path))
            ++moved;
        else
            outcome.sentence =
                tr("%1 was not deleted: it could not be moved to the trash, and Fettle deletes nothing permanently.")
                    .arg(file.fileName());
    }
    if (outcome.sentence.isEmpty())
        outcome.sentence = moved == 1 ? tr("%1 is in the trash.").arg(QFileInfo(paths.constFirst()).fileName())
                                      : tr("%Ln files are in the trash.", nullptr, moved);
    return outcome;
}

QString FileJobs::changeProblem(const QString& path)
{
    const QFileInfo file(path), folder(file.absolutePath());
    if (!file.exists() && !file.isSymLink())
        return notThere(path);
    return folder.isWritable() ? QString()
                               : tr("Nothing in %1 can be changed: permission denied.")
                                     .arg(QDir::toNativeSeparators(folder.filePath()));
}

QString FileJobs::notThere(const QString& path)
{
    return ErrorMessages::sentence(core::FileError(core::FileErrorKind::NotFound, path.toStdU16String()));
}
} // namespace ui
