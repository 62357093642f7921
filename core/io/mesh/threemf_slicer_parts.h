#pragma once

#include "core/io/mesh/zip_reader.h"

#include <cstdint>
#include <map>
#include <vector>

namespace core::io
{
/// Parts of a 3MF's objects that are no matter: a slicer cuts them out of the model, or slices differently where they
/// are. The core of the format does not tell them from the model; the slicers' own files in the package do.
struct ThreeMfSlicerParts
{
    /// The triangles from `first` to `last`, counted from 0, of an object.
    struct Triangles
    {
        std::size_t first = 0, last = 0;
        bool isNegative = false; ///< to be cut out; else a modifier or something for supports
    };
    std::map<std::uint32_t, std::vector<Triangles>> triangles; ///< by object: PrusaSlicer, SuperSlicer
    /// Parts that are no matter: true for one that is to be cut out, false for a modifier or a support. By pairs of an
    /// object of the build and of one that it is made of: Bambu Studio, OrcaSlicer. Objects that are in different parts
    /// of the package may have the same number.
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> objects;

    /// Reads them; there are none if the package has no such file. Of a broken file counts what is right, up to where
    /// its XML breaks off. Throws ReadingCancelled.
    static ThreeMfSlicerParts in(const FileBytes& file, ZipReader& package);
};
} // namespace core::io
