#pragma once

#include "core/io/mesh/format.h"

namespace app
{
/// Throws core::FileError, with the line, for content of a COLLADA file at which Assimp 5.2 ends its process, reads
/// beyond values, fills all memory, or silently drops or moves faces: accessors that exceed their values, primitives
/// without their counts or with too few indices, words or negative numbers among these, nodes that contain themselves,
/// skews, units that are not above 0, and instances from other files. Leaves broken XML to Assimp. Returns the number
/// of instances of what the file does not have, which Assimp skips.
std::size_t requireSoundCollada(const core::io::FileBytes& file);
/// Checks each COLLADA file in a ZAE package as requireSoundCollada() does, and returns the sum. Throws core::FileError
/// for a damaged package, too.
std::size_t requireSoundZae(const core::io::FileBytes& package);

/// Throws core::FileError, with the line, if the file is not well-formed XML.
void requireXml(const core::io::FileBytes& file);
} // namespace app
