#pragma once

#include "core/io/mesh/format.h"

#include <functional>
#include <optional>
#include <string>

namespace core::io
{
/// An X3D file expanded: only the nodes that simple readers get right.
struct X3dExpansion
{
    std::string text;       ///< a whole X3D file, UTF-8
    std::size_t unread = 0; ///< the nodes left out that stand for surfaces, and the Inlines whose files are missing
};

/// The files around an X3D file that make one scene with it.
struct X3dSurroundings
{
    /// Returns the name by which a reader finds the file that an Inline's url stands for; empty if it cannot be had.
    /// Missing: every url is such a name.
    std::function<std::optional<std::string>(std::string_view url)> find = {};
    /// Number of the file, different for each file of the scene: the names of its nodes begin with it, because Assimp
    /// looks for them in the whole scene.
    std::size_t fileNumber = 0;
};

/// Expands an X3D file into the nodes that simple readers get right. Groups and transforms are written with their
/// content as often as the scene uses them (USE). A Switch becomes the child that it shows, a LOD its finest level.
/// Shapes keep their materials; their faces become an IndexedFaceSet, wound as ccw says. Lengths are in metres, angles
/// in radians; what an Inline names is of its own file's units. Shapes that are used again are named, not copied. An
/// Inline names the first of its files that can be had. Throws FileError, also where nodes hold themselves, or where
/// there are more than 2^18.
X3dExpansion expandX3d(const FileBytes& file, const X3dSurroundings& around = {});
} // namespace core::io
