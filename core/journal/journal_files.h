#pragma once

#include "core/journal/journal_record.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace core
{
// The files in a journal's folder:
//   lock          locked by the process that has the document open
//   start         a StartRecord: the model as it was opened
//   base-<n>      optional: the mesh at the beginning of segment n, in parts, followed by a BaseRecord
//   segment-<n>   records; their numbers continue from segment to segment
// Recovery reads the newest complete base, or else the start, and then the following segments. A base is written
// completely or not at all. A segment may be cut off at its end by a crash; later records are in the next segment.

std::filesystem::path startFile(const std::filesystem::path& folder);
std::filesystem::path baseFile(const std::filesystem::path& folder, unsigned segment);
std::filesystem::path segmentFile(const std::filesystem::path& folder, unsigned segment);

struct JournalFiles
{
    std::map<unsigned, std::uintmax_t> bases, segments; ///< sizes in bytes, by the file's number
};
/// Returns the bases and segments in the folder; empty if the folder cannot be read.
JournalFiles filesIn(const std::filesystem::path& folder);

/// Returns the content of the file; empty if it cannot be read.
std::string contentOf(const std::filesystem::path& file);
} // namespace core
