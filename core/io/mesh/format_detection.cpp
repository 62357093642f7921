// Detects the format of a file from its content, regardless of its extension.

#include "core/io/mesh/format.h"

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>

namespace core::io
{
namespace
{
struct Magic
{
    std::string_view start, name;
};

constexpr std::array magics{
    Magic{"ply\n", "ply"},
    Magic{"ply\r", "ply"},
    Magic{"ply ", "ply"},
    Magic{"ply\t", "ply"},
    Magic{"glTF", "glb"},
    Magic{"PK\3\4", "zip"},
    Magic{"version https://git-lfs", "git lfs pointer"},
    Magic{"\x89PNG", "png"},
    Magic{"\xff\xd8\xff", "jpg"},
    Magic{"GIF8", "gif"},
    Magic{"%PDF", "pdf"},
    Magic{"\x1f\x8b", "gz"},
    Magic{"\177ELF", "program"},
    Magic{"Kaydara FBX", "fbx"},
    Magic{"<?xml", "xml"},
    Magic{"BLENDER", "blend"},
    Magic{"<!DOCTYPE", "html"},
    Magic{"<html", "html"},
};

/// Returns whether the text has no control characters except line ends and blanks. One character in `strayOneIn` may be
/// any, because names are sometimes padded with NULs.
bool isText(std::string_view start, std::size_t strayOneIn = 64)
{
    const std::string_view text = withoutPadding(start);
    const auto strays = std::ranges::count_if(text, [](char c) {
        return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v';
    });
    return !text.empty() && static_cast<std::size_t>(strays) <= text.size() / strayOneIn;
}

/// Returns whether the bytes are UTF-16 in either byte order: they have a byte order mark, or every other byte at the
/// beginning is 0.
bool isUtf16(std::string_view start)
{
    constexpr std::size_t looked = 32;
    const std::string_view first = start.substr(0, looked);
    const bool isMarked = first.starts_with("\xff\xfe") || first.starts_with("\xfe\xff");
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = isMarked ? 2 : 0; i < first.size(); ++i)
        zeros[i % 2] += first[i] == 0 ? 1 : 0;
    const std::size_t pairs = (first.size() - (isMarked ? 2 : 0)) / 2, most = std::max(zeros[0], zeros[1]);
    return std::min(zeros[0], zeros[1]) == 0 && pairs > 0 &&
           (isMarked ? 2 * most >= pairs : pairs > 7 && most == pairs);
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

/// Returns the text from its first line that is neither empty nor a comment.
std::string_view withoutComments(std::string_view text, std::initializer_list<std::string_view> marks = {"#"})
{
    text = withoutBlanks(withoutMark(text));
    while (std::ranges::any_of(marks, [&text](std::string_view mark) { return text.starts_with(mark); })) {
        const std::size_t end = text.find_first_of("\r\n");
        text = end == std::string_view::npos ? std::string_view() : withoutBlanks(text.substr(end));
    }
    return text;
}

std::string_view firstWord(std::string_view text)
{
    return text.substr(0, text.find_first_of(" \t\r\n"));
}

bool isObj(std::string_view start)
{
    constexpr std::array words{"v ", "vn ", "vt ", "f ", "g ", "o ", "s ", "mtllib ", "usemtl ", "v\t"};
    const std::string_view text = withoutComments(start);
    return std::any_of(words.begin(), words.end(), [text](std::string_view w) { return text.starts_with(w); });
}

/// Returns whether the keyword is OFF with any prefix of ST, C, N, 4 and n.
bool isOff(std::string_view start)
{
    const std::string_view keyword = firstWord(withoutComments(start));
    return keyword.ends_with("OFF") && keyword.find_first_not_of("STCN4nOF") == std::string_view::npos;
}
} // namespace

std::string_view withoutMark(std::string_view text)
{
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string_view withoutPadding(std::string_view text)
{
    for (std::size_t size = text.size(); size != 0; --size) {
        const char last = text[size - 1];
        if (last == '\0' || last == '\x1a')
            text = text.substr(0, size - 1);
        else if (last != ' ' && last != '\t' && last != '\r' && last != '\n')
            break;
    }
    return text;
}

std::size_t utf8Length(std::string_view text)
{
    const auto byteAt = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byteAt(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    if (length > text.size())
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byteAt(i) & 0xc0) != 0x80)
            return 0;
    const bool isTooLong = length > 2 && ((first == 0xe0 && byteAt(1) < 0xa0) || (first == 0xf0 && byteAt(1) < 0x90));
    const bool isSurrogate = first == 0xed && byteAt(1) >= 0xa0;
    const bool isTooLarge = first == 0xf4 && byteAt(1) >= 0x90;
    return isTooLong || isSurrogate || isTooLarge ? 0 : length;
}

bool isBinaryOff(std::string_view start)
{
    const std::string_view text = withoutComments(start);
    const std::string_view rest = text.substr(firstWord(text).size());
    return isOff(start) && firstWord(rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size()))) == "BINARY";
}

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

/// Returns whether the file is a text STL. The word "solid" alone is no proof, because some programs write it into
/// binary headers.
bool isTextStl(std::string_view start)
{
    const std::string_view text = withoutComments(start, {"#", ";", "//"});
    if (!startsWithWord(text, "solid"))
        return false;
    constexpr std::string_view keyword = "facet";
    constexpr std::size_t strayOneIn = 16; // the name may be padded
    for (std::size_t at = keyword.size(); at < text.size(); ++at)
        if (startsWithWord(text.substr(at), keyword))
            return isText(text, strayOneIn);
    return isText(text);
}

std::string_view detectFormat(std::string_view start, std::uint64_t fileSize)
{
    if (isBinaryStl(start, fileSize))
        return "stl";
    if (isUtf16(start))
        return "utf-16";
    for (const Magic& magic : magics)
        if (withoutMark(start).starts_with(magic.start))
            return magic.name;
    if (isTextStl(start))
        return "stl";
    if (isBinaryOff(start))
        return "off";
    if (isText(start))
        return isObj(start) ? "obj" : isOff(start) ? "off" : "text";
    return {};
}
} // namespace core::io
