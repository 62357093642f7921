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
/// File access for Assimp: lets it read the files in one folder and its subfolders, and write none. Symbolic links are
/// resolved first. Some files are modified on reading: X3D is expanded, COLLADA becomes UTF-8 with correct counts, and
/// FBX gets rotations that Assimp applies correctly.
class ImportFolder : public Assimp::DefaultIOSystem
{
public:
    /// Facts about the reading that Assimp does not report.
    struct Notes
    {
        std::string outside;        ///< name of a requested file that is outside of the folder; empty: none
        std::exception_ptr problem; ///< the exception of a file that could not be provided
        std::size_t hidden = 0;     ///< number of X3D nodes with surfaces that are not visible
        /// Number of X3D surface nodes left out, of Inline nodes whose files are missing, and of COLLADA instances of
        /// what is missing.
        std::size_t unread = 0;
        std::set<std::string> missing; ///< names of LightWave objects that a scene refers to, but that do not exist
        /// false: an FBX file was passed on unmodified, because its records could not be parsed
        bool isFollowed = true;
        std::vector<FbxModel> models;            ///< models of the FBX file
        std::optional<core::FileError> whyEmpty; ///< why an FBX file shows nothing, as far as its models tell
    };

    ImportFolder(std::filesystem::path folder, Notes& notes) : m_folder(std::move(folder)), m_notes(notes) {}

    bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;

private:
    /// Returns the expanded text of an X3D file. Throws core::FileError.
    std::string expanded(const std::filesystem::path& path);
    void refuseCycleOf(const std::filesystem::path& path) const;
    /// Returns an alias without blanks for an X3D file: Assimp does not accept names with blanks.
    std::string aliasOf(const std::filesystem::path& path);
    /// Returns the path of a file that Assimp requests, perhaps by its alias.
    std::filesystem::path pathOf(const char* file) const;
    bool isWithin(const std::filesystem::path& file) const;
    /// Returns the modified content of the file; null: the file is read unmodified. Throws core::FileError.
    const std::string* replacement(const std::filesystem::path& path);

    std::filesystem::path m_folder;
    Notes& m_notes;
    /// modified content by path; empty: unmodified
    std::map<std::filesystem::path, std::optional<std::string>> m_replacements;
    std::map<std::filesystem::path, std::set<std::filesystem::path>> m_inlined; ///< files named by each X3D file
    std::map<std::string, std::filesystem::path> m_aliases;
    std::filesystem::path m_outermost; ///< the first X3D file opened
    int m_opened = 0;                  ///< number of times that X3D files were opened
};

/// Returns the file name extension in lower case, with its dot.
std::string lowerEnding(const std::filesystem::path& path);
} // namespace app
