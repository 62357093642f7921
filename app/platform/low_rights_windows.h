#pragma once

#include <windows.h>

namespace app
{
/// Takes away the rights of a token that reading a file does not need: its privileges, and writing to whatever belongs
/// to the user. The system lets a token of low integrity write only to places made for that, such as AppData\LocalLow.
/// Returns whether the integrity was lowered. Precondition: the token was opened with TOKEN_ADJUST_DEFAULT,
/// TOKEN_ADJUST_PRIVILEGES and TOKEN_QUERY.
bool lowerRights(HANDLE token);
} // namespace app
