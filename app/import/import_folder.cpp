#include "app/import/import_folder.h"

#include "app/import/collada_check.h"
#include "app/import/collada_text.h"

#include "core/util/file_error.h"
#include "core/util/system_path.h"

#include <assimp/MemoryIOWrapper.h>

#include <QByteArray>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

namespace app
{
namespace
{
namespace fs = std::filesystem;

/// largest number of X3D files opened for one scene, because an Inline node may refer to its own file
constexpr int maxOpened = 256;

/// Returns the file names that a URL may mean: the URL itself, without its fragment ("#..."), and percent-decoded.
std::vector<std::string> namesOf(std::string_view url)
{
    std::vector<std::string> names{std::string(url), std::string(url.substr(0, url.find('#')))};
    const QByteArray decoded =
        QByteArray::fromPercentEncoding({names[1].data(), static_cast<qsizetype>(names[1].size())});
    names.push_back(decoded.toStdString());
    return names;
}

/// Returns the X3D file that a URL refers to, with links resolved; nothing if there is none. Files outside of the
/// import's folder are returned, too, so that Open() can report them.
std::optional<fs::path> inlinedFile(const fs::path& folder, std::string_view url)
{
    for (const std::string& name : namesOf(url)) {
        std::error_code problem;
        const fs::path file = folder / core::pathOfUtf8(name);
        if (name.find('\0') != std::string::npos || lowerEnding(file) != ".x3d" || !fs::is_regular_file(file, problem))
            continue;
        if (fs::path path = fs::canonical(file, problem); !problem)
            return path;
    }
    return std::nullopt;
}

std::string bytesOf(const fs::path& path)
{
    std::ifstream stream(core::systemPath(path), std::ios::binary);
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

bool ImportFolder::Exists(const char* file) const
{
    const fs::path path = pathOf(file);
    return isWithin(path) && DefaultIOSystem::Exists(path.string().c_str());
}

Assimp::IOStream* ImportFolder::Open(const char* file, const char* mode)
{
    const bool reads = std::strchr(mode, 'r') && !std::strchr(mode, '+');
    const fs::path path = pathOf(file);
    if (!reads || m_notes.problem || !isWithin(path))
        return nullptr;
    try {
        if (const std::string* const text = replacement(fs::canonical(path)))
            return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text->data()), text->size());
    } catch (...) {
        // not thrown here, because Assimp would replace it by another exception
        m_notes.problem = std::current_exception();
        return nullptr;
    }
    return DefaultIOSystem::Open(file, mode);
}

const std::string* ImportFolder::replacement(const fs::path& path)
{
    const std::string ending = lowerEnding(path);
    const bool isX3d = ending == ".x3d";
    if (!isX3d && ending != ".dae" && ending != ".zae" && ending != ".fbx")
        return nullptr;
    if (isX3d && m_opened == 0)
        m_outermost = path;
    if (isX3d && ++m_opened > maxOpened)
        throw core::io::tooMany("Inline nodes", maxOpened, core::FileError({}, m_outermost));
    const auto [found, isNew] = m_replacements.try_emplace(path);
    if (isNew) {
        if (isX3d) {
            found->second = expanded(path);
        } else if (ending == ".fbx") {
            const std::string bytes = bytesOf(path);
            FbxForAssimp fbx = fbxForAssimp(path, bytes);
            m_notes.isFollowed = m_notes.isFollowed && fbx.isFollowed;
            m_notes.models = std::move(fbx.models);
            m_notes.whyEmpty = std::move(fbx.whyEmpty);
            found->second = std::move(fbx.changed);
        } else if (ending == ".zae") {
            const std::string bytes = bytesOf(path);
            m_notes.unread += requireSoundZae({path, bytes});
        } else {
            const std::string bytes = bytesOf(path);
            m_notes.unread += requireSoundCollada({path, bytes});
            found->second = colladaText(bytes);
        }
    }
    return found->second ? &*found->second : nullptr;
}

std::string ImportFolder::expanded(const fs::path& path)
{
    std::set<fs::path>& inlined = m_inlined[path];
    const auto find = [&](std::string_view url) -> std::optional<std::string> {
        const std::optional<fs::path> file = inlinedFile(path.parent_path(), url);
        if (!file)
            return std::nullopt;
        inlined.insert(*file);
        return aliasOf(*file);
    };
    const std::string bytes = bytesOf(path);
    core::io::X3dExpansion expansion =
        core::io::expandX3d({path, bytes}, {.find = find, .fileNumber = m_replacements.size()});
    m_notes.hidden += expansion.hidden;
    m_notes.unread += expansion.unread;
    refuseCycleOf(path);
    return std::move(expansion.text);
}

/// Throws core::FileError if an X3D file inlines itself, as far as the inlined files are known.
void ImportFolder::refuseCycleOf(const fs::path& path) const
{
    std::set<fs::path> seen;
    std::vector<fs::path> next{path};
    while (!next.empty()) {
        const auto known = m_inlined.find(next.back());
        next.pop_back();
        if (known == m_inlined.end())
            continue;
        if (known->second.contains(path))
            throw core::io::malformed(core::FileFault::TooDeep,
                                      core::io::errorWithToken({}, {path, {}}, "Inline nodes"));
        for (const fs::path& file : known->second)
            if (seen.insert(file).second)
                next.push_back(file);
    }
}

std::string ImportFolder::aliasOf(const fs::path& path)
{
    const auto known = std::ranges::find(m_aliases, path, [](const auto& alias) { return alias.second; });
    if (known != m_aliases.end())
        return known->first;
    std::string alias = "fettle-inlined-" + std::to_string(m_aliases.size()) + ".x3d";
    m_aliases.emplace(alias, path);
    return alias;
}

fs::path ImportFolder::pathOf(const char* file) const
{
    const fs::path path = core::pathOfUtf8(file); // Assimp has names in UTF-8 on every system
    const auto alias = m_aliases.find(path.filename().string());
    return alias == m_aliases.end() ? path : alias->second;
}

bool ImportFolder::isWithin(const fs::path& file) const
{
    std::error_code problem;
    const fs::path path = fs::canonical(file, problem);
    if (problem) {
        if (lowerEnding(file) == ".lwo")
            m_notes.missing.insert(file.filename().string());
        return false;
    }
    m_notes.missing.erase(file.filename().string()); // Assimp tries several folders
    const bool isWithin =
        std::mismatch(m_folder.begin(), m_folder.end(), path.begin(), path.end()).first == m_folder.end();
    if (!isWithin)
        m_notes.outside = file.filename().string();
    return isWithin;
}
} // namespace app
