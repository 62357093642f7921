#pragma once

#include "app/import/fbx_models.h"

#include "core/io/mesh/x3d_expansion.h"

#include <assimp/DefaultIOSystem.h>

#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace app
{
/// Lets Assimp read in one folder, links followed, and write nowhere. It is given X3D files expanded, COLLADA files in
/// UTF-8, with counts as they are, and FBX files with rotations that it turns right.
class ImportFolder : public Assimp::DefaultIOSystem
{
public:
    /// Tells of the reading what no reader does.
    struct Notes
    {
        std::string outside;          ///< the name of a file that was asked for elsewhere
        std::exception_ptr problem;   ///< exception over a file that could not be given
        std::size_t unread = 0;       ///< nodes left out that stand for surfaces
        bool isFollowed = true;       ///< false: an FBX file was given as it is, because it could not be followed
        std::vector<FbxModel> models; ///< of an FBX file
    };

    ImportFolder(std::filesystem::path folder, Notes& notes) : m_folder(std::move(folder)), m_notes(notes) {}

    bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;

private:
    /// Returns what Assimp is given of an X3D file. Throws core::FileError.
    std::string expanded(const std::filesystem::path& path);
    void refuseCycleOf(const std::filesystem::path& path) const;
    /// Returns the name that Assimp is given of an X3D file: it knows none with blanks.
    std::string aliasOf(const std::filesystem::path& path);
    /// Returns the path of a file that Assimp asks for, perhaps by its alias.
    std::filesystem::path pathOf(const char* file) const;
    bool isWithin(const std::filesystem::path& file) const;
    /// Returns what is given instead of the file; null: the file itself. Throws core::FileError.
    const std::string* replacement(const std::filesystem::path& path);

    std::filesystem::path m_folder;
    Notes& m_notes;
    std::map<std::filesystem::path, std::optional<std::string>> m_replacements; ///< empty: the file itself
    std::map<std::filesystem::path, std::set<std::filesystem::path>> m_inlined; ///< of X3D files, what they name
    std::map<std::string, std::filesystem::path> m_aliases;
    std::filesystem::path m_outermost; ///< the X3D file that came first
    int m_opened = 0;                  ///< X3D files, each as often as it was asked for
};

/// Returns the ending in lower case, with its dot.
std::string lowerEnding(const std::filesystem::path& path);
} // namespace app
