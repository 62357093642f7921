#pragma once

#include <filesystem>

namespace app
{
/// Undocumented first argument that makes this program an import process: "fettle read-foreign FILE BYTES OBJECTS".
inline constexpr const char* importWord = "read-foreign";
/// Word for OBJECTS that requests a part for each object of the file; any other word requests one part for all.
inline constexpr const char* importAsParts = "parts";

/// Runs the import process: reads the file with Assimp (or glTF with Draco) and writes the result to standard output
/// (import_protocol.h). First restricts itself: memory and time to ImportLimits, no other programs, no network, no
/// writing of files. Opens only files in the folder of `file` and its subfolders. `bytes`: size of the file and of the
/// files it refers to, in decimal. `objects`: see importAsParts. Returns the exit status.
int runImport(const std::filesystem::path& file, const char* bytes, const char* objects);

/// Returns whether files with this extension define a unit of length.
bool assimpHoldsUnit(const std::filesystem::path& file);
} // namespace app
