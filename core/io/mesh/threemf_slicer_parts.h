#pragma once

#include "core/io/mesh/zip_reader.h"

#include <cstdint>
#include <map>
#include <vector>

namespace core::io
{
/// Parts of a 3MF's objects that are not solid. A slicer subtracts them from the model, or slices differently where
/// they are. The core format does not distinguish them from the model; files of the slicers in the package do.
struct ThreeMfSlicerParts
{
    struct Part
    {
        bool isNegative = false; ///< true: to be subtracted; false: a modifier or a support
        std::string name;        ///< as in the file; empty: none
    };
    /// A range of an object's triangles, from `first` to `last` inclusive, counted from 0.
    struct Triangles
    {
        std::size_t first = 0, last = 0;
        Part part = {};
    };
    /// Ranges of triangles by object id (PrusaSlicer, SuperSlicer).
    std::map<std::uint32_t, std::vector<Triangles>> triangles;
    /// Parts by an object of the build and one of its components, since objects in different parts of the package may
    /// have the same id (Bambu Studio, OrcaSlicer).
    std::map<std::pair<std::uint32_t, std::uint32_t>, Part> objects;

    /// Reads the slicers' files; empty if the package has none. A damaged file is used up to the damage. Throws
    /// ReadingCancelled.
    static ThreeMfSlicerParts in(const FileBytes& file, ZipReader& package);
};
} // namespace core::io
