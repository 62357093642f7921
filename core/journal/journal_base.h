#pragma once

#include "core/journal/journal_record.h"

#include <filesystem>

namespace core
{
class Mesh;

/// Writes a mesh in parts, and the document as it was when the record of that number was the last. All or nothing, and
/// durable. It goes to disk part by part, so that who syncs a small file meanwhile waits for one part at most. Throws
/// FileError.
void writeBase(const std::filesystem::path& file, const Mesh& mesh, const BaseRecord& base, std::uint64_t number);
} // namespace core
