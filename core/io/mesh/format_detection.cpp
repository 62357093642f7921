// What a file's content looks like, whatever its ending says.

#include "core/io/mesh/format.h"

#include <algorithm>
#include <array>
#include <bit>

namespace core::io
{
namespace
{
struct Magic
{
    std::string_view start, name;
};

constexpr std::array magics{
    Magic{"ply\n", "ply"},     Magic{"ply\r", "ply"},        Magic{"glTF", "glb"},        Magic{"PK\3\4", "zip"},
    Magic{"\x89PNG", "png"},   Magic{"\xff\xd8\xff", "jpg"}, Magic{"GIF8", "gif"},        Magic{"%PDF", "pdf"},
    Magic{"\x1f\x8b", "gz"},   Magic{"\177ELF", "program"},  Magic{"Kaydara FBX", "fbx"}, Magic{"<?xml", "xml"},
    Magic{"BLENDER", "blend"}, Magic{"<!DOCTYPE", "html"},   Magic{"<html", "html"},
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

/// From the first line on that is neither empty nor a comment.
std::string_view withoutComments(std::string_view text)
{
    text = withoutBlanks(text);
    while (text.starts_with('#')) {
        const std::size_t end = text.find_first_of("\r\n");
        text = end == std::string_view::npos ? std::string_view() : withoutBlanks(text.substr(end));
    }
    return text;
}

bool isObj(std::string_view start)
{
    constexpr std::array words{"v ", "vn ", "vt ", "f ", "g ", "o ", "s ", "mtllib ", "usemtl ", "v\t"};
    const std::string_view text = withoutComments(start);
    return std::any_of(words.begin(), words.end(), [text](std::string_view w) { return text.starts_with(w); });
}

/// OFF, with ST, C, N, 4 and n before it or not.
bool isOff(std::string_view start)
{
    const std::string_view text = withoutComments(start);
    const std::string_view keyword = text.substr(0, text.find_first_of(" \t\r\n"));
    return keyword.ends_with("OFF") && keyword.find_first_not_of("STCN4nOF") == std::string_view::npos;
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

std::string_view detectFormat(std::string_view start, std::uint64_t fileSize)
{
    if (isBinaryStl(start, fileSize))
        return "stl";
    for (const Magic& magic : magics)
        if (start.starts_with(magic.start))
            return magic.name;
    if (isTextStl(start))
        return "stl";
    if (isText(start))
        return isObj(start) ? "obj" : isOff(start) ? "off" : "text";
    return {};
}
} // namespace core::io
