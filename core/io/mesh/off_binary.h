#pragma once

#include "core/io/mesh/format.h"

namespace core::io
{
/// The body of an OFF file with the keyword BINARY; `body` points to its first byte. It consists of 32-bit integers and
/// floats: for each vertex a point, and a normal and a colour if the keyword says so. The standard has big-endian
/// numbers, a number of colour components after each face, and four components of a vertex's colour. Other programs
/// write little-endian numbers, omit the number of components, or write three of them. The first combination that reads
/// the whole file is used; if none does, the first that leaves only bytes at the end.
struct BinaryOff
{
    const FileBytes& file;
    const char* body = nullptr;
    bool hasNormals = false, hasColors = false, hasTexture = false;

    ReadResult read() const;
};
} // namespace core::io
