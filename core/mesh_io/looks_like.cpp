// What a file's content looks like, whatever its ending says.

#include "format.h"

#include <algorithm>
#include <array>
#include <bit>

namespace core::mesh_io
{
namespace
{
struct Magic
{
    std::string_view start, name;
};

using namespace std::string_view_literals;
constexpr std::array magics{
    Magic{"ply\n"sv, "ply"},
    Magic{"ply\r"sv, "ply"},
    Magic{"glTF"sv, "glb"},
    Magic{"PK\3\4"sv, "zip"},
    Magic{"\x89PNG"sv, "png"},
    Magic{"\xff\xd8\xff"sv, "jpg"},
    Magic{"GIF8"sv, "gif"},
    Magic{"%PDF"sv, "pdf"},
    Magic{"\x1f\x8b"sv, "gz"},
    Magic{"OFF\n"sv, "off"},
    Magic{"OFF\r"sv, "off"},
    Magic{"COFF"sv, "off"},
    Magic{"\x7f"
          "ELF"sv,
          "program"},
    Magic{"Kaydara FBX"sv, "fbx"},
    Magic{"<?xml"sv, "xml"},
    Magic{"BLENDER"sv, "blend"},
    Magic{"<!DOCTYPE"sv, "html"},
    Magic{"<html"sv, "html"},
};

bool isText(std::string_view start)
{
    return std::none_of(start.begin(), start.end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v';
    });
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool startsWithWord(std::string_view text, std::string_view word)
{
    return text.size() >= word.size() &&
           std::equal(word.begin(), word.end(), text.begin(), [](char w, char c) { return w == lower(c); });
}

std::string_view withoutBlanks(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

/// The first line that is neither empty nor a comment is one of OBJ's.
bool isObj(std::string_view start)
{
    constexpr std::array words{"v "sv, "vn "sv, "vt "sv,     "f "sv,      "g "sv,
                               "o "sv, "s "sv,  "mtllib "sv, "usemtl "sv, "v\t"sv};
    for (std::string_view rest = withoutBlanks(start); !rest.empty();) {
        if (rest.front() != '#')
            return std::any_of(words.begin(), words.end(), [rest](std::string_view w) { return rest.starts_with(w); });
        const std::size_t end = rest.find_first_of("\r\n");
        rest = end == std::string_view::npos ? std::string_view() : withoutBlanks(rest.substr(end));
    }
    return false;
}
} // namespace

std::uint64_t announcedStlTriangles(std::string_view start)
{
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        count |= std::uint64_t(static_cast<unsigned char>(start[stlHeaderSize - 4 + i])) << (8 * i);
    return count;
}

bool isBinaryStl(std::string_view start, std::uint64_t fileSize)
{
    return fileSize >= stlHeaderSize && start.size() >= stlHeaderSize &&
           fileSize == stlHeaderSize + stlTriangleSize * announcedStlTriangles(start);
}

/// "solid" alone is no proof: some write it into binary headers.
bool isTextStl(std::string_view start)
{
    const std::string_view text = withoutBlanks(start);
    return startsWithWord(text, "solid") && isText(text);
}

std::string_view looksLike(std::string_view start, std::uint64_t fileSize)
{
    if (isBinaryStl(start, fileSize))
        return "stl";
    for (const Magic& magic : magics)
        if (start.starts_with(magic.start))
            return magic.name;
    if (isTextStl(start))
        return "stl";
    if (isText(start))
        return isObj(start) ? "obj" : "text";
    return {};
}
} // namespace core::mesh_io
