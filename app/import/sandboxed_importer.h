#pragma once

#include "core/io/external_reader.h"

#include <string>

namespace app
{
/// Returns a reader for the formats that only Assimp reads, and for glTF with Draco compression. Each file is read in a
/// process of its own, so that a malicious file can harm only that process; its output is checked like a file.
/// `program`: path of fettle, which is run with importWord.
core::ExternalReader sandboxedImporter(const std::string& program);
/// Registers sandboxedImporter() of this program with core.
void installSandboxedImporter();
} // namespace app
