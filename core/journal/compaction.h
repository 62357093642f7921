#pragma once

#include <filesystem>
#include <stop_token>

namespace core
{
/// Makes a base of what is before that segment, which must be complete, and removes the segments and bases before it.
/// The folder holds the same document at each moment. False if it was stopped, or failed: then nothing has changed.
/// Reads and writes on disk alone; takes the memory of another mesh.
bool compactJournal(const std::filesystem::path& folder, unsigned segment, const std::stop_token& stop = {});
} // namespace core
