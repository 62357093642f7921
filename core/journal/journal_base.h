#pragma once

#include "core/journal/journal_record.h"

#include <filesystem>

namespace core
{
class Mesh;

/// Writes a base: the mesh in parts, then the document as it was after the record with that number. The file appears
/// complete and durable, or not at all. Each part is synced separately, so that another thread's sync of a small file
/// waits for one part at most. Throws FileError.
void writeBase(const std::filesystem::path& file, const Mesh& mesh, const BaseRecord& base, std::uint64_t number);
} // namespace core
