#pragma once

#include <filesystem>

/// Places that cannot be written, for a test's process and the programs that it starts. Linux.
namespace places
{
/// From here on permissions of files bind this process, though it be root's. Before there are threads.
void obeyPermissions();

/// A folder on a disk of its own that holds so much, empty, seen by this process only; gone with the object.
class SmallDisk
{
public:
    /// Before there are threads: the first one makes the process's mounts its own, which takes root's rights or user
    /// namespaces.
    explicit SmallDisk(std::filesystem::path folder, unsigned kibibytes = 64);
    ~SmallDisk();
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    const std::filesystem::path& folder() const { return m_folder; }
    /// Not where the system forbids to mount: tests skip then.
    bool isThere() const { return m_isThere; }
    /// With a file named "filler", until nothing more goes in; it may be removed.
    void fill() const;

private:
    std::filesystem::path m_folder;
    bool m_isThere = false;
};
} // namespace places
