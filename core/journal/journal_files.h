#pragma once

#include "core/journal/journal_record.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace core
{
// A journal's folder holds
//   lock          of the process whose document it is
//   start         the model as it was opened: a StartRecord
//   base-<n>      perhaps: parts of the mesh as it was at the beginning of segment n, closed by a BaseRecord
//   segment-<n>   records, numbered on from segment to segment
// Recovery takes the newest base that is whole, or the start, and the segments from there on. Bases come whole or not
// at all; a segment may be torn at its end: what was done since then is in the next.

std::filesystem::path startFile(const std::filesystem::path& folder);
std::filesystem::path baseFile(const std::filesystem::path& folder, unsigned segment);
std::filesystem::path segmentFile(const std::filesystem::path& folder, unsigned segment);

struct JournalFiles
{
    std::map<unsigned, std::uintmax_t> bases, segments; ///< sizes in bytes, by number
};
/// What is there. Nothing of a folder that cannot be read.
JournalFiles filesIn(const std::filesystem::path& folder);

/// The whole file; nothing if it cannot be read.
std::string contentOf(const std::filesystem::path& file);
} // namespace core
