#pragma once

#include "core/io/mesh/format.h"

#include <string>
#include <vector>

namespace core::io
{
enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

constexpr std::size_t sizeOf(PlyType type)
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<int>(type)];
}

constexpr bool isWhole(PlyType type)
{
    return type != PlyType::Float && type != PlyType::Double;
}

struct PlyProperty
{
    std::string_view name; ///< view into the file
    PlyType type = PlyType::Float;
    std::optional<PlyType> countType; ///< type of the length, if the property is a list

    bool isList() const { return countType.has_value(); }
};

struct PlyElement
{
    std::string_view name;
    std::uint64_t count = 0; ///< declared number of elements; not yet checked against the file's size
    std::vector<PlyProperty> properties;
    const char* line = nullptr; ///< line that declares the element

    /// Returns the smallest size of one element in bytes.
    std::uint64_t minSize(PlyEncoding encoding) const;
};

struct PlyHeader
{
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    const char* body = nullptr;

    const PlyElement* find(std::string_view name) const;
};

/// Parses the header. Each element name occurs once. Throws FileError.
PlyHeader readPlyHeader(const FileBytes& file);
} // namespace core::io
