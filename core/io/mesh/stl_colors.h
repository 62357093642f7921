#pragma once

#include "core/io/mesh/format.h"

namespace core::io
{
/// Reads the colours of a binary STL from the two bytes after each triangle, with 5 bits a channel. The VisCAM
/// convention: bit 15 means that there is a colour, blue is lowest. The Magics convention applies if the header has
/// COLOR=rgba: bit 15 means the header's colour, as do all words if all are 0; red is lowest. Returns for each vertex
/// the mean of its triangles' colours; a triangle without colour counts as Rgb(). Returns an empty list if no triangle
/// has a colour.
std::vector<Rgb> stlColors(std::string_view header, std::span<const std::uint16_t> words, const TriangleMesh& mesh,
                           StopCheck& stopCheck);
} // namespace core::io
