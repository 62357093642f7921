// Sources: Khronos, glTF 2.0 specification, section 2.8 (URIs); RFC 3986 (percent signs), RFC 4648 (base64).
#include "core/io/mesh/gltf_buffers.h"

#include "core/util/system_code.h"
#include "core/util/system_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fstream>

namespace core::io
{
namespace
{
constexpr std::string_view scheme = "data:", packed = ";base64,";

std::string fromBase64(const FileBytes& file, std::string_view text)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    constexpr std::uint8_t none = 64;
    std::array<std::uint8_t, 256> values;
    values.fill(none);
    for (std::size_t i = 0; i < digits.size(); ++i)
        values[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
    while (text.ends_with('='))
        text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    StopCheck stopCheck(file.stop);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        stopCheck();
        const std::uint8_t value = values[static_cast<unsigned char>(c)];
        if (value == none)
            throw malformed(FileFault::Base64, errorWithToken({}, file, "base64"));
        bits = bits << 6 | value;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 255);
        }
    }
    return bytes;
}

/// Decodes percent signs. Returns nothing if a percent sign is not followed by two hexadecimal digits.
std::optional<std::string> withoutPercents(std::string_view uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        std::uint8_t byte = 0;
        const std::string_view hex = uri.substr(i + 1, 2);
        const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), byte, 16);
        if (hex.size() != 2 || error != std::errc() || end != hex.data() + hex.size())
            return std::nullopt;
        text += static_cast<char>(byte);
        i += 2;
    }
    return text;
}

/// Returns whether the uri begins with a scheme or a drive: http:, file:, C:
bool hasScheme(std::string_view uri)
{
    const std::size_t end = uri.find_first_of(":/");
    return end != std::string_view::npos && uri[end] == ':';
}

bool isWithin(const std::filesystem::path& folder, const std::filesystem::path& path)
{
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

std::filesystem::path pathBeside(const FileBytes& file, std::string_view uri)
{
    const FileError outside = errorWithToken(FileErrorKind::OutsideFolder, file, uri);
    const auto text = withoutPercents(uri);
    if (file.isStandalone || !text || text->empty() || hasScheme(uri) ||
        text->find_first_of(std::string_view("\\\0", 2)) != std::string::npos)
        throw outside;
    const std::filesystem::path relative(std::u8string(text->begin(), text->end()));
    if (relative.has_root_path() || *relative.lexically_normal().begin() == "..")
        throw outside;
    std::error_code problem;
    const std::filesystem::path folder =
        std::filesystem::canonical(std::filesystem::absolute(file.path).parent_path(), problem);
    const std::filesystem::path path = std::filesystem::canonical(folder / relative, problem);
    if (problem)
        throw FileError(FileErrorKind::NotFound, file.path.parent_path() / relative);
    if (!isWithin(folder, path))
        throw outside;
    return path;
}

std::string readBeside(const FileBytes& file, const std::filesystem::path& path, std::uint64_t size)
{
    if (!std::filesystem::is_regular_file(path))
        throw FileError(FileErrorKind::NotAFile, path);
    clearStreamCode();
    std::ifstream stream(systemPath(path), std::ios::binary);
    if (!stream)
        throw FileError(FileErrorKind::NotReadable, path, streamCode());
    constexpr std::uint64_t atOnce = 1 << 22;
    std::string bytes;
    while (bytes.size() < size && stream) {
        if (file.stop.stop_requested())
            throw ReadingCancelled();
        const std::size_t before = bytes.size();
        bytes.resize(before + std::min(atOnce, size - before));
        stream.read(bytes.data() + before, static_cast<std::streamsize>(bytes.size() - before));
        bytes.resize(before + static_cast<std::size_t>(stream.gcount()));
    }
    if (bytes.size() < size)
        throw withCounts({FileErrorKind::CutOff, path}, size, bytes.size());
    return bytes;
}
} // namespace

std::string gltfBuffer(const FileBytes& file, std::string_view uri, std::uint64_t bytes)
{
    if (!uri.starts_with(scheme))
        return readBeside(file, pathBeside(file, uri), bytes);
    const std::size_t at = uri.substr(0, 256).find(packed);
    if (at == std::string_view::npos)
        throw malformed(FileFault::Base64, errorWithToken({}, file, uri));
    std::string data = fromBase64(file, uri.substr(at + packed.size()));
    if (data.size() < bytes)
        throw withCounts({FileErrorKind::CutOff, file.path}, bytes, data.size());
    return data;
}
} // namespace core::io
