#pragma once

#include <QCollator>
#include <QList>
#include <QString>

#include <filesystem>

namespace ui
{
/// A name or path of the disk for people to read. A name may be no UTF-8; what cannot be shown of it has U+FFFD in its
/// place.
QString displayName(const std::filesystem::path& path);

/// Sorts names as people expect: a2 before a10, ignoring case, by the user's language. One thread.
QCollator nameCollator();

/// By their names alone; of equal ones by the whole path.
void sortByName(QList<std::filesystem::path>& files);

/// The model files of a folder, at least one, by name, with the folder before their names. Those in folders further
/// down, hidden ones, and what only is named like a model (a folder, a device) are left out. A name that is no UTF-8 is
/// reached by its path all the same. Throws core::FileError: NotFound, FolderNotReadable, NoModel. Any thread.
QList<std::filesystem::path> modelsIn(const std::filesystem::path& folder);
} // namespace ui
