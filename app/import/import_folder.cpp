#include "app/import/import_folder.h"

#include "app/import/collada_text.h"
#include "app/import/fbx_models.h"

#include "core/util/file_error.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace app
{
namespace
{
namespace fs = std::filesystem;

/// The times that X3D files are opened for one scene: an Inline may name its own file.
constexpr int maxOpened = 256;

std::string bytesOf(const fs::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}
} // namespace

std::string lowerEnding(const fs::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

Assimp::IOStream* ImportFolder::Open(const char* file, const char* mode)
{
    const bool reads = std::strchr(mode, 'r') && !std::strchr(mode, '+');
    if (!reads || m_notes.problem || !isWithin(file))
        return nullptr;
    try {
        if (const std::string* const text = replacement(fs::canonical(file)))
            return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text->data()), text->size());
    } catch (const core::FileError&) {
        m_notes.problem = std::current_exception(); // Assimp would make another one of it
        return nullptr;
    }
    return DefaultIOSystem::Open(file, mode);
}

const std::string* ImportFolder::replacement(const fs::path& path)
{
    const std::string ending = lowerEnding(path);
    const bool isX3d = ending == ".x3d";
    if (!isX3d && ending != ".dae" && ending != ".fbx")
        return nullptr;
    if (isX3d && ++m_opened > maxOpened) {
        core::FileError error = core::io::errorWithToken({}, {path, {}}, "Inline nodes");
        throw core::io::malformed(core::FileFault::TooDeep, std::move(error));
    }
    const auto [found, isNew] = m_replacements.try_emplace(path);
    if (isNew) {
        const std::string bytes = bytesOf(path);
        if (isX3d) {
            const core::io::X3dSurroundings around{
                .hasFile = [&path](std::string_view url) { return canInline(path.parent_path() / url); },
                .fileNumber = m_replacements.size()};
            core::io::X3dExpansion expansion = core::io::expandX3d({path, bytes}, around);
            m_notes.unread += expansion.unread;
            found->second = std::move(expansion.text);
        } else if (ending == ".fbx") {
            FbxForAssimp fbx = fbxForAssimp(path, bytes);
            m_notes.isFollowed = m_notes.isFollowed && fbx.isFollowed;
            found->second = std::move(fbx.changed);
        } else {
            found->second = colladaText(bytes);
        }
    }
    return found->second ? &*found->second : nullptr;
}

/// Returns whether Assimp is to ask for the file. Files outside of the folder count, so that Open() can report them.
bool ImportFolder::canInline(const fs::path& file)
{
    std::error_code problem;
    return lowerEnding(file) == ".x3d" && fs::is_regular_file(file, problem);
}

bool ImportFolder::isWithin(const char* file) const
{
    std::error_code problem;
    const fs::path path = fs::canonical(file, problem);
    if (problem)
        return false;
    const bool isWithin =
        std::mismatch(m_folder.begin(), m_folder.end(), path.begin(), path.end()).first == m_folder.end();
    if (!isWithin)
        m_notes.outside = fs::path(file).filename().string();
    return isWithin;
}
} // namespace app
