#pragma once

#include "core/io/mesh/format.h"

#include <functional>
#include <string>

namespace core::io
{
/// An X3D scene of the simplest nodes.
struct X3dExpansion
{
    std::string text;       ///< a whole X3D file, UTF-8
    std::size_t unread = 0; ///< the nodes left out that stand for surfaces, files that are not there among them
};

/// Returns whether a file can be had that an Inline names.
using X3dHasFile = std::function<bool(std::string_view url)>;

/// Writes an X3D file anew, with no more than simple readers get right: groups and transforms with what is in them, as
/// often as the scene uses them (USE), of a Switch what it shows, of a LOD the finest; shapes with their materials, and
/// their faces as IndexedFaceSet, wound as ccw says; lengths in metres. Shapes that come again are named, not copied.
/// An Inline names the first of its files that can be had; without `hasFile` the first. Throws FileError, also where
/// nodes hold themselves, or are more than 2^18.
X3dExpansion expandX3d(const FileBytes& file, const X3dHasFile& hasFile = {});
} // namespace core::io
