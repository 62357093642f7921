#pragma once

#include <filesystem>

namespace app
{
/// The word that makes the program such a process: "fettle read-foreign FILE", which nobody is told of.
inline constexpr const char* importWord = "read-foreign";

/// Reads the file with Assimp, and answers on standard output (import_protocol.h). Before that it takes from itself
/// what it does not need: memory and time beyond ImportLimits, other programs, the network, files to write. Nothing
/// outside of the file's folder is opened. The exit status.
int runImport(const char* file);

/// Whether files with that ending are measured in a unit of their own.
bool assimpHoldsUnit(const std::filesystem::path& file);
} // namespace app
