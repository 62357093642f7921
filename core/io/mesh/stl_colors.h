#pragma once

#include "core/io/mesh/format.h"

namespace core::io
{
/// The two bytes after each triangle of a binary STL hold its colour, 5 bits a channel, in the way of VisCAM (bit 15:
/// there is one; blue lowest), or, where the header says COLOR=rgba, in that of Magics (bit 15: the header's; red
/// lowest). By vertex: the mean of its triangles; without colour of their own they are Rgb(). Empty if no triangle has
/// any.
std::vector<Rgb> stlColors(std::string_view header, std::span<const std::uint16_t> words, const TriangleMesh& mesh,
                           StopCheck& stopCheck);
} // namespace core::io
