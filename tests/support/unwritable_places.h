#pragma once

#include <filesystem>

/// Unwritable folders for the process of a test and the programs that it starts. Linux only.
namespace places
{
/// Makes file permissions apply to this process even if it runs as root. Precondition: the process has one thread.
void obeyPermissions();

/// An empty folder on a file system of `kibibytes` that only this process sees. The destructor removes it.
class SmallDisk
{
public:
    /// Precondition: the process has one thread. The first SmallDisk gives the process its own mounts, which needs root
    /// rights or user namespaces.
    explicit SmallDisk(std::filesystem::path folder, unsigned kibibytes = 64);
    ~SmallDisk();
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    const std::filesystem::path& folder() const { return m_folder; }
    /// Returns false if the system forbids mounts: tests then skip.
    bool isThere() const { return m_isThere; }
    /// Fills the disk with a file named "filler", which a test may remove.
    void fill() const;

private:
    std::filesystem::path m_folder;
    bool m_isThere = false;
};
} // namespace places
