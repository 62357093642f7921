#pragma once

#include "ui/files/file_entry.h"

#include <QCoreApplication>
#include <QList>
#include <QStringList>

#include <stop_token>

namespace ui
{
struct FolderContent
{
    QString folder;
    QList<FileEntry> entries; ///< folders, and files with the suffix of a model format; unsorted
    QString problem;          ///< why the folder could not be read, one sentence; empty: none
};

/// The result of a change on disk.
struct FileOutcome
{
    QString sentence;  ///< message for the user; may be empty if all went well
    QStringList paths; ///< paths that exist now: the new name, or the copies
};

/// Disk operations of the files panel, with messages for the user. They overwrite nothing, and they delete only by
/// moving to the trash. Cost: may take long; not for the gui thread.
class FileJobs
{
    Q_DECLARE_TR_FUNCTIONS(ui::FileJobs)

public:
    static FolderContent list(const QString& folder, const std::stop_token& stop);
    /// Returns the entry with its present size and date.
    static FileEntry entryOf(const QString& path);
    /// Renames a file. `name`: without the suffix, which stays.
    static FileOutcome rename(const QString& path, const QString& name);
    /// Copies each file into its folder, named "lion copy.stl", "lion copy 2.stl" and so on.
    static FileOutcome duplicate(const QStringList& paths);
    static FileOutcome trash(const QStringList& paths);
    /// Returns a numbered path beside the file: "vase.glb" and "vase-002.glb" give "vase-003.glb". The number is above
    /// those of all files with this base name, whatever their suffixes.
    static QString numberedCopyOf(const QString& path);

private:
    static QString nameProblem(const QString& name);
    static QString copyOf(const QString& path);
    static QString changeProblem(const QString& path);
    static QString notThere(const QString& path);
};
} // namespace ui
