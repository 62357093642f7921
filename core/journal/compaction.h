#pragma once

#include <filesystem>
#include <stop_token>

namespace core
{
/// Replaces everything before this segment by a new base, and removes the older segments and bases. Precondition: the
/// preceding segments are complete. Returns false if it was stopped or failed; the journal is then unchanged. The
/// folder contains the same document at every moment. Uses the files only, not the open document; takes the memory of a
/// second mesh.
bool compactJournal(const std::filesystem::path& folder, unsigned segment, const std::stop_token& stop = {});
} // namespace core
