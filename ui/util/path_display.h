#pragma once

#include <QCollator>
#include <QList>
#include <QString>

#include <filesystem>

namespace ui
{
/// Returns a file name or path for display. Bytes that are not UTF-8 appear as U+FFFD.
QString displayName(const std::filesystem::path& path);

/// Returns a collator that sorts names as users expect: a2 before a10, ignoring case, by the user's language. Thread:
/// only one may use the object.
QCollator nameCollator();

/// Sorts by file name; equal names by the whole path.
void sortByName(QList<std::filesystem::path>& files);

/// Returns the paths of the model files in a folder, at least one, sorted by name. Excludes subfolders, hidden files,
/// and folders or devices with the name of a model. Names that are not UTF-8 work. Throws core::FileError: NotFound,
/// FolderNotReadable, NoModel. Thread: any.
QList<std::filesystem::path> modelsIn(const std::filesystem::path& folder);
} // namespace ui
