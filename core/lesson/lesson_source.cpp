// The sources of a lesson's files. In a folder, symbolic links are followed as long as they stay inside it. In a zip,
// only the files that the lesson references are unpacked.
#include "core/lesson/lesson_source.h"

#include "core/io/mesh/zip_reader.h"
#include "core/util/system_code.h"
#include "core/util/system_path.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace core
{
namespace
{
using Kind = LessonError::Kind;

/// Returns at most `max` + 1 bytes of the file.
std::string bytesOf(const std::filesystem::path& path, std::size_t max)
{
    FileError unreadable(FileErrorKind::NotReadable, path);
    clearStreamCode();
    std::ifstream stream(systemPath(path), std::ios::binary);
    std::string bytes;
    std::array<char, 1 << 16> piece;
    while (stream.good() && bytes.size() <= max) {
        stream.read(piece.data(), static_cast<std::streamsize>(std::min(piece.size(), max + 1 - bytes.size())));
        bytes.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > max)
            return bytes;
    }
    unreadable.systemError = streamCode();
    if (!stream.eof())
        throw unreadable;
    return bytes;
}

bool isWithin(const std::filesystem::path& folder, const std::filesystem::path& path)
{
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

std::optional<std::string> readBelow(const std::filesystem::path& lesson, const std::string& name, std::size_t max)
{
    std::error_code problem;
    const std::filesystem::path folder = std::filesystem::canonical(lesson, problem);
    const std::filesystem::path path = std::filesystem::canonical(folder / pathOfUtf8(name), problem);
    if (problem)
        return std::nullopt;
    if (!isWithin(folder, path)) {
        LessonError error(Kind::BadName, lesson);
        error.key = name;
        throw error;
    }
    if (!std::filesystem::is_regular_file(path, problem))
        throw FileError(FileErrorKind::NotAFile, lesson / pathOfUtf8(name));
    return bytesOf(path, max);
}

/// A zip in memory, and the folder in the zip that contains the lesson.
struct Packed
{
    Packed(const std::filesystem::path& lesson, std::string all) : path(lesson), bytes(std::move(all)), package(file)
    {
        if (package.count() > LessonLimits::maxPackedFiles) {
            LessonError error(Kind::TooMany, path);
            error.max = LessonLimits::maxPackedFiles;
            throw error;
        }
        for (const std::string& name : package.names()) {
            if (name != lessonJsonName && !name.ends_with(std::string("/") + lessonJsonName))
                continue;
            const std::string at = name.substr(0, name.size() - sizeof lessonJsonName + 1);
            if (!folder || at.size() < folder->size())
                folder = at;
        }
        if (!folder)
            throw LessonError(Kind::NoLesson, path);
    }

    std::optional<std::string> read(const std::string& name, std::size_t max)
    {
        const std::string part = *folder + name;
        if (!package.has(part))
            return std::nullopt;
        std::string content;
        package.read(part, [&](std::string_view piece) {
            if (content.size() <= max)
                content.append(piece.substr(0, max + 1 - content.size()));
        });
        return content;
    }

    std::filesystem::path path;
    std::string bytes;
    io::FileBytes file{path, bytes};
    io::ZipReader package;
    std::optional<std::string> folder; ///< the lesson's folder in the zip, with a final "/"; "": the top level
};
} // namespace

bool isLessonName(std::string_view name)
{
    const auto isOdd = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f ||
               std::string_view("\\:*?\"<>|").find(c) != std::string_view::npos;
    };
    if (name.empty() || name.size() > LessonLimits::maxNameBytes || std::ranges::any_of(name, isOdd))
        return false;
    for (std::string_view rest = name;;) {
        const std::size_t end = std::min(rest.find('/'), rest.size());
        const std::string_view step = rest.substr(0, end);
        if (step.empty() || step == "." || step == "..")
            return false;
        if (end == rest.size())
            return true;
        rest.remove_prefix(end + 1);
    }
}

LessonFiles lessonFolder(const std::filesystem::path& path)
{
    if (!std::filesystem::exists(path / lessonJsonName))
        throw LessonError(Kind::NoLesson, path);
    return {path, [path](const std::string& name, std::size_t max) { return readBelow(path, name, max); }};
}

LessonFiles lessonZip(const std::filesystem::path& path)
{
    std::string bytes = bytesOf(path, LessonLimits::maxBytes);
    if (bytes.empty())
        throw FileError(FileErrorKind::Empty, path);
    if (bytes.size() > LessonLimits::maxBytes) {
        LessonError error(Kind::TooLarge, path);
        error.max = LessonLimits::maxBytes;
        throw error;
    }
    if (!bytes.starts_with("PK"))
        throw LessonError(Kind::NoLesson, path);
    const auto packed = std::make_shared<Packed>(path, std::move(bytes));
    return {path, [packed](const std::string& name, std::size_t max) { return packed->read(name, max); }};
}
} // namespace core
