#pragma once

#include "core/io/mesh/format.h"

#include <functional>
#include <optional>
#include <string>

namespace core::io
{
/// An X3D file rewritten with only those nodes that simple readers handle correctly.
struct X3dExpansion
{
    std::string text;       ///< a complete X3D file in UTF-8
    std::size_t hidden = 0; ///< number of nodes with surfaces left out because they are not visible
    std::size_t unread = 0; ///< number of surface nodes left out, and of Inline nodes whose files are missing
};

/// The context of an X3D file: the other files of its scene.
struct X3dSurroundings
{
    /// Returns the name under which a reader finds the file of an Inline's url; nothing if the file is not available. A
    /// missing function: every url is used as the name.
    std::function<std::optional<std::string>(std::string_view url)> find = {};
    /// Number of this file, different for each file of the scene. It is the prefix of all node names, because Assimp
    /// searches for names in the whole scene.
    std::size_t fileNumber = 0;
};

/// Rewrites an X3D file with only those nodes that simple readers handle correctly. Groups and transforms are written
/// out for each use (USE), and keep their names. A Switch is replaced by its visible child, a LOD by its finest level.
/// Shapes keep their materials; faces become an IndexedFaceSet with the orientation given by ccw. Lengths are in
/// metres, angles in radians; inlined files keep their own units. Shapes that are used again are referenced, not
/// copied. An Inline refers to the first of its files that is available. Throws FileError, also if nodes contain
/// themselves or if there are more than 2^18 nodes.
X3dExpansion expandX3d(const FileBytes& file, const X3dSurroundings& around = {});
/// Returns the name (DEF) that a group had before expandX3d() wrote it with this name; empty if it had none.
std::string_view x3dNameIn(std::string_view written);
} // namespace core::io
