// Source: Microsoft Learn, "Mandatory Integrity Control", "AdjustTokenPrivileges function".
#include "app/platform/low_rights_windows.h"

#include <cstddef>
#include <vector>

namespace app
{
namespace
{
/// Removes all privileges except the one that every process has, to pass through folders.
void removePrivileges(HANDLE token)
{
    DWORD size = 0;
    GetTokenInformation(token, TokenPrivileges, nullptr, 0, &size);
    std::vector<std::byte> bytes(size);
    LUID passFolders{};
    if (size == 0 || !GetTokenInformation(token, TokenPrivileges, bytes.data(), size, &size) ||
        !LookupPrivilegeValueW(nullptr, SE_CHANGE_NOTIFY_NAME, &passFolders))
        return;
    auto* const privileges = reinterpret_cast<TOKEN_PRIVILEGES*>(bytes.data());
    for (DWORD i = 0; i < privileges->PrivilegeCount; ++i) {
        LUID_AND_ATTRIBUTES& privilege = privileges->Privileges[i];
        const bool isKept =
            privilege.Luid.LowPart == passFolders.LowPart && privilege.Luid.HighPart == passFolders.HighPart;
        privilege.Attributes = isKept ? SE_PRIVILEGE_ENABLED : SE_PRIVILEGE_REMOVED;
    }
    AdjustTokenPrivileges(token, FALSE, privileges, 0, nullptr, nullptr);
}
} // namespace

bool lowerRights(HANDLE token)
{
    removePrivileges(token);
    SID_IDENTIFIER_AUTHORITY authority = SECURITY_MANDATORY_LABEL_AUTHORITY;
    PSID low = nullptr;
    if (!AllocateAndInitializeSid(&authority, 1, SECURITY_MANDATORY_LOW_RID, 0, 0, 0, 0, 0, 0, 0, &low))
        return false;
    TOKEN_MANDATORY_LABEL label{{low, SE_GROUP_INTEGRITY}};
    const bool isLowered =
        SetTokenInformation(token, TokenIntegrityLevel, &label, static_cast<DWORD>(sizeof label + GetLengthSid(low)));
    FreeSid(low);
    return isLowered;
}
} // namespace app
