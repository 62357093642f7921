#pragma once

#include "core/geometry.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core::mesh_io
{
/// "fettle palette c86e50 8a5a3c", for a comment of its own among a file's first lines.
std::string paletteWords(std::span<const Rgb> palette);
/// Of such a comment in the start of a file, or a text of a GLB's JSON; empty if there is none, or it is not as we write it.
std::vector<Rgb> paletteIn(std::string_view start);
} // namespace core::mesh_io
