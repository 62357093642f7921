#pragma once

#include "core/io/mesh/format.h"

namespace app
{
/// Throws core::FileError, with the line, for content of a COLLADA file at which Assimp 5.2 ends its process, reads
/// beyond values, fills all memory, or silently drops or moves faces: accessors that exceed their values, primitives
/// without their counts or with too few indices, words or negative numbers among these, nodes that contain themselves,
/// skews, and units that are not above 0. Leaves broken XML to Assimp.
void requireSoundCollada(const core::io::FileBytes& file);
/// Checks each COLLADA file in a ZAE package as requireSoundCollada() does. Throws core::FileError for a damaged
/// package, too.
void requireSoundZae(const core::io::FileBytes& package);

/// Throws core::FileError, with the line, if the file is not well-formed XML.
void requireXml(const core::io::FileBytes& file);
} // namespace app
