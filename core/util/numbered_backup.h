#pragma once

#include <filesystem>

namespace core
{
/// What a file holds before it is written anew stays beside it: "vase.glb" as "vase.glb~1", the version before that as
/// "vase.glb~2", and so on. Until commit() these are what they were; without it they stay so, though the program ends.
class NumberedBackup
{
public:
    /// Of a file that is about to be replaced by AtomicFile; one that is not there is not kept. Throws FileError.
    NumberedBackup(const std::filesystem::path& file, int versions);
    ~NumberedBackup();
    NumberedBackup(const NumberedBackup&) = delete;
    NumberedBackup& operator=(const NumberedBackup&) = delete;

    /// The file was written. The oldest version goes. Throws FileError.
    void commit();

    static std::filesystem::path nameOf(const std::filesystem::path& file, int version); ///< 1: the latest

private:
    std::filesystem::path m_file;
    std::filesystem::path m_pending; ///< empty: there is nothing to keep
    int m_versions;
};
} // namespace core
