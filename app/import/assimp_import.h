#pragma once

#include <filesystem>

namespace app
{
/// The word that makes the program such a process: "fettle read-foreign FILE BYTES", which nobody is told of.
inline constexpr const char* importWord = "read-foreign";

/// Reads the file with Assimp, or glTF with Draco, and answers on standard output (import_protocol.h). Before that it
/// takes from itself what it does not need: memory and time beyond ImportLimits, other programs, the network, files to
/// write. Nothing outside of the file's folder is opened. `bytes`: the size of the file and of what it names, in
/// decimal. The exit status.
int runImport(const char* file, const char* bytes);

/// Whether files with that ending are measured in a unit of their own.
bool assimpHoldsUnit(const std::filesystem::path& file);
} // namespace app
