#include "app/import/sandboxed_importer.h"

#include "app/import/assimp_import.h"
#include "app/import/import_protocol.h"
#include "app/platform/child_process.h"

#include "core/util/file_error.h"

#include <algorithm>
#include <array>

namespace app
{
namespace
{
using core::FileError;
using core::FileErrorKind;
using core::TriangleMesh;

/// Of those that Assimp 5.2 reads: what holds surfaces, and whose ending means nothing else to most people (no raw,
/// scn, xml, mesh).
constexpr std::array<std::string_view, 40> endings{
    "fbx", "dae",  "3ds",  "x3d", "x3db", "amf", "blend",   "lwo", "lws", "lxo",     "dxf", "ifc", "ac",   "ac3d",
    "acc", "ase",  "b3d",  "cob", "hmp",  "iqm", "irrmesh", "md2", "md3", "md5mesh", "mdc", "mdl", "ms3d", "ndo",
    "nff", "enff", "ogex", "pmx", "q3o",  "q3s", "sib",     "smd", "x",   "xgl",     "zae", "zgl"};

FileError errorOf(FileErrorKind kind, const std::filesystem::path& path, std::uint64_t expected = 0)
{
    FileError error(kind, path);
    error.expected = expected;
    return error;
}

/// The answer's bytes in order, as long as there are enough.
class Answer
{
public:
    explicit Answer(std::string_view bytes) : m_rest(bytes) {}

    bool take(void* to, std::size_t size)
    {
        if (size > m_rest.size())
            return false;
        std::copy_n(m_rest.data(), size,
                    static_cast<char*>(to)); // std::memcpy() may not be given a null pointer, not even for nothing
        m_rest.remove_prefix(size);
        return true;
    }
    template <class Element> bool take(std::vector<Element>& to, std::uint64_t count)
    {
        if (count > m_rest.size() / sizeof(Element))
            return false;
        to.resize(count);
        return take(static_cast<void*>(to.data()), count * sizeof(Element));
    }
    bool atEnd() const { return m_rest.empty(); }

private:
    std::string_view m_rest;
};

bool isSound(const TriangleMesh& mesh)
{
    for (const core::Triangle& t : mesh.triangles)
        for (const core::Slot corner : t)
            if (corner >= mesh.points.size())
                return false;
    return mesh.colors.empty() || mesh.colors.size() == mesh.points.size();
}

[[noreturn]] void refuse(ForeignHead head, const std::filesystem::path& path, const ForeignLimits& limits)
{
    if (head.outcome == ForeignHead::Outcome::OutOfMemory)
        throw errorOf(FileErrorKind::ReaderOutOfMemory, path, limits.memory);
    const bool isOutside = head.outcome == ForeignHead::Outcome::Outside;
    FileError error = errorOf(isOutside ? FileErrorKind::OutsideFolder : FileErrorKind::ReaderRefused, path);
    constexpr std::size_t longest = 40;
    for (const char* c = head.words; *c && error.token.size() < longest; ++c)
        error.token += *c < ' ' || *c > '~' ? '?' : *c;
    throw error;
}

core::ReadResult resultOf(std::string_view bytes, const std::filesystem::path& path, const ForeignLimits& limits)
{
    Answer answer(bytes);
    ForeignHead head;
    if (!answer.take(&head, sizeof head) || head.magic != ForeignHead::magicNumber)
        throw errorOf(FileErrorKind::ReaderDied, path);
    head.words[sizeof head.words - 1] = 0;
    if (head.outcome != ForeignHead::Outcome::Read)
        refuse(head, path, limits);
    core::ReadResult result;
    std::uint32_t end = 0;
    const bool isWhole = answer.take(result.mesh.points, head.points) && answer.take(result.mesh.colors, head.colors) &&
                         answer.take(result.mesh.triangles, head.triangles) && answer.take(&end, sizeof end) &&
                         end == foreignEnd && answer.atEnd();
    if (!isWhole || !isSound(result.mesh))
        throw errorOf(FileErrorKind::ReaderDied, path);
    for (const core::Vec3f& point : result.mesh.points)
        if (!point.allFinite())
            throw errorOf(FileErrorKind::NotANumber, path);
    result.remarks = {.objects = head.objects,
                      .materials = head.materials != 0,
                      .textures = head.textures != 0,
                      .poses = head.poses != 0};
    return result;
}

core::ReadResult read(const std::string& program, const std::filesystem::path& path, const std::stop_token& stop)
{
    const ForeignLimits limits(std::filesystem::file_size(path));
    ChildOrder order{{program, foreignWord, std::filesystem::absolute(path).string()}};
    order.time = std::chrono::seconds(2 * limits.seconds);
    order.maxBytes = sizeof(ForeignHead) + sizeof foreignEnd +
                     limits.points * (sizeof(core::Vec3f) + sizeof(core::Rgb)) +
                     limits.triangles * sizeof(core::Triangle);
    order.stop = stop;
    const ChildAnswer answer = runChild(order);
    switch (answer.end) {
    case ChildAnswer::End::Stopped:
        throw core::ReadingCancelled();
    case ChildAnswer::End::TooSlow:
        throw errorOf(FileErrorKind::ReaderTooSlow, path, limits.seconds);
    case ChildAnswer::End::Died:
    case ChildAnswer::End::NotStarted:
        throw errorOf(FileErrorKind::ReaderDied, path);
    case ChildAnswer::End::Exited:
        break;
    }
    return resultOf(answer.bytes, path, limits);
}
} // namespace

core::ExternalReader foreignReaderBy(std::string program)
{
    return {{endings.begin(), endings.end()},
            [program = std::move(program)](const std::filesystem::path& path, const std::stop_token& stop) {
                return read(program, path, stop);
            }};
}

void installForeignReader()
{
    core::setExternalReader(foreignReaderBy(ownProgram()));
}
} // namespace app
