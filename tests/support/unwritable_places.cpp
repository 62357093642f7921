#include "tests/support/unwritable_places.h"

#include <fstream>
#include <linux/capability.h>
#include <sched.h>
#include <string>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace places
{
namespace
{
/// Gives this process its own mount namespace. Without root rights this needs a new user namespace, in which user and
/// group are mapped to themselves.
bool ownMounts()
{
    const std::string user = std::to_string(::geteuid()), group = std::to_string(::getegid());
    if (::unshare(CLONE_NEWNS) == 0)
        return true;
    if (::unshare(CLONE_NEWNS | CLONE_NEWUSER) != 0)
        return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << user + ' ' + user + " 1";
    std::ofstream("/proc/self/gid_map") << group + ' ' + group + " 1";
    return true;
}
} // namespace

void obeyPermissions()
{
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct data[_LINUX_CAPABILITY_U32S_3] = {};
    if (::syscall(SYS_capget, &header, data) != 0)
        return;
    for (const unsigned right : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH}) {
        ::prctl(PR_CAPBSET_DROP, right); // started programs do not regain the capability
        data[0].effective &= ~(1U << right);
        data[0].permitted &= ~(1U << right);
        data[0].inheritable &= ~(1U << right);
    }
    ::syscall(SYS_capset, &header, data);
}

SmallDisk::SmallDisk(std::filesystem::path folder, unsigned kibibytes) : m_folder(std::move(folder))
{
    std::filesystem::create_directories(m_folder);
    static const bool mayMount = ownMounts();
    m_isThere = mayMount && ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                ::mount("none", m_folder.c_str(), "tmpfs", 0, ("size=" + std::to_string(kibibytes) + 'k').c_str()) == 0;
}

SmallDisk::~SmallDisk()
{
    if (m_isThere)
        ::umount2(m_folder.c_str(), MNT_DETACH);
}

void SmallDisk::fill() const
{
    std::ofstream filler(m_folder / "filler", std::ios::binary);
    for (const std::string page(4096, 'x');
         filler.write(page.data(), static_cast<std::streamsize>(page.size())).flush();) {
    }
}
} // namespace places
