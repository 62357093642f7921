#pragma once

#include "core/io/mesh/format.h"

namespace core::io
{
/// The body of an OFF file whose keyword BINARY follows: it begins at `body`. Whole numbers and floats of 32 bits; per
/// vertex a point, a normal and a colour where the keyword says so. Programs differ in the byte order (the format's is
/// big-endian), in whether a number of colour components follows each face (the format's does), and in whether a colour
/// has four components (the format's) or three. The first of these that fits all of the file is taken.
struct BinaryOff
{
    const FileBytes& file;
    const char* body = nullptr;
    bool hasNormals = false, hasColors = false, hasTexture = false;

    ReadResult read() const;
};
} // namespace core::io
