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
    QList<FileEntry> entries; ///< its folders, and the files whose endings are models'; in no order
    QString problem;          ///< one sentence: it could not be read
};

/// What became of a change on disk.
struct FileOutcome
{
    QString sentence;  ///< for the person; may be empty if all went well
    QStringList paths; ///< what there is now: the new name, the copies
};

/// What the files panel does on disk, in words for people. Nothing is overwritten, and nothing deleted but into the
/// trash. May take long: not for the gui thread.
class FileJobs
{
    Q_DECLARE_TR_FUNCTIONS(ui::FileJobs)

public:
    static FolderContent list(const QString& folder, const std::stop_token& stop);
    /// As it is now.
    static FileEntry entryOf(const QString& path);
    /// `name` is without the ending, which stays.
    static FileOutcome rename(const QString& path, const QString& name);
    /// Beside the files: "lion copy.stl", "lion copy 2.stl".
    static FileOutcome duplicate(const QStringList& paths);
    static FileOutcome trash(const QStringList& paths);
    /// "vase.glb" and "vase-002.glb" give "vase-003.glb" where that is the first number after all that are there,
    /// whatever the endings.
    static QString numberedCopyOf(const QString& path);

private:
    static QString nameProblem(const QString& name);
    static QString copyOf(const QString& path);
    static QString changeProblem(const QString& path);
    static QString notThere(const QString& path);
};
} // namespace ui
