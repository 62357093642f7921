#pragma once

#include "core/io/external_reader.h"

#include <string>

namespace app
{
/// Reads the formats that Assimp reads and we do not, and glTF that Draco packed. Each file is read by a process of its
/// own, `program` with importWord, so that whatever a file does to Assimp or Draco it does not do to us; what it
/// answers is checked as a file would be. `program` is fettle.
core::ExternalReader sandboxedImporter(const std::string& program);
/// Registers sandboxedImporter() of this program with core.
void installSandboxedImporter();
} // namespace app
