#include "core/io/mesh/zip_reader.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace core::io
{
namespace
{
constexpr std::uint64_t maxTimes = 100, alwaysTaken = std::uint64_t(16) << 20, maxUnpacked = std::uint64_t(4) << 30;

std::uint64_t limitFor(std::size_t fileSize)
{
    return std::clamp(maxTimes * fileSize, alwaysTaken, maxUnpacked);
}

/// Returns the path in lower case with forward slashes, no leading slash, and decoded percent signs.
std::string plainName(std::string_view name)
{
    std::string plain;
    for (std::size_t i = 0; i < name.size(); ++i) {
        std::uint8_t byte = 0;
        const std::string_view hex = name.substr(i + 1, name[i] == '%' ? 2 : 0);
        const bool isByte =
            hex.size() == 2 && std::from_chars(hex.data(), hex.data() + 2, byte, 16).ptr == hex.data() + 2;
        const char c = isByte ? static_cast<char>(byte) : name[i] == '\\' ? '/' : name[i];
        plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        i += isByte ? 2 : 0;
    }
    return plain.starts_with('/') ? plain.substr(1) : plain;
}

FileError cutOff(const FileBytes& file)
{
    return errorAtByte(FileErrorKind::CutOff, file, file.bytes.data() + file.bytes.size());
}

FileError unpacksTooLarge(const FileBytes& file)
{
    return withCounts({FileErrorKind::UnpacksTooLarge, file.path}, limitFor(file.bytes.size()));
}

zip* opened(const FileBytes& file)
{
    zip_source_t* const source = zip_source_buffer_create(file.bytes.data(), file.bytes.size(), 0, nullptr);
    if (!source)
        throw std::bad_alloc();
    zip* const archive = zip_open_from_source(source, ZIP_RDONLY, nullptr);
    if (!archive) {
        zip_source_free(source);
        throw cutOff(file); // the zip directory is at the file's end, so the file was cut off
    }
    return archive;
}
} // namespace

ZipReader::ZipReader(const FileBytes& file)
    : m_file(file)
    , m_zip(opened(file), &zip_discard)
    , m_left(limitFor(file.bytes.size()))
{}

ZipReader::~ZipReader() = default;

std::size_t ZipReader::count() const
{
    return static_cast<std::size_t>(std::max<zip_int64_t>(zip_get_num_entries(m_zip.get(), 0), 0));
}

std::vector<std::string> ZipReader::names() const
{
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count(); ++i)
        if (const char* const name = zip_get_name(m_zip.get(), i, ZIP_FL_ENC_GUESS))
            all.emplace_back(name);
    return all;
}

bool ZipReader::has(const std::string& part) const
{
    return zip_name_locate(m_zip.get(), part.c_str(), ZIP_FL_NOCASE) >= 0;
}

std::optional<std::string> ZipReader::find(const std::string& part) const
{
    if (has(part))
        return part;
    const std::string wanted = plainName(part);
    for (const std::string& name : names())
        if (plainName(name) == wanted)
            return name;
    return std::nullopt;
}

void ZipReader::read(const std::string& part, const Take& take)
{
    const auto refused = [&](FileFault fault) { return malformed(fault, errorWithToken({}, m_file, part)); };
    const zip_int64_t index = zip_name_locate(m_zip.get(), part.c_str(), ZIP_FL_NOCASE);
    zip_stat_t stat;
    constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
    if (index < 0)
        throw refused(FileFault::NotInPackage);
    if (zip_stat_index(m_zip.get(), static_cast<zip_uint64_t>(index), 0, &stat) != 0 ||
        (stat.valid & needed) != needed || (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE) ||
        stat.encryption_method != ZIP_EM_NONE)
        throw refused(FileFault::PackedOtherwise);
    if (stat.size > m_left)
        throw unpacksTooLarge(m_file);
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> packed(
        zip_fopen_index(m_zip.get(), static_cast<zip_uint64_t>(index), 0), &zip_fclose);
    if (!packed)
        throw refused(FileFault::PackedOtherwise);
    std::array<char, 1 << 16> piece;
    for (;;) {
        if (m_file.stop.stop_requested())
            throw ReadingCancelled();
        const zip_int64_t got = zip_fread(packed.get(), piece.data(), piece.size());
        if (got < 0)
            throw cutOff(m_file);
        if (static_cast<std::uint64_t>(got) > m_left)
            throw unpacksTooLarge(m_file);
        m_left -= static_cast<std::uint64_t>(got);
        take({piece.data(), static_cast<std::size_t>(got)});
        if (got == 0)
            return;
    }
}
} // namespace core::io
