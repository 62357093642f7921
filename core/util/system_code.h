#pragma once

#include <system_error>

namespace core
{
/// A system code is what the operating system gives as the reason of a failure: errno, or on Windows the value of
/// GetLastError(). Messages show its text (qt_error_string()).

/// Returns the system code of an error of any category; 0 if it is not set.
int systemCodeOf(const std::error_code& problem);

/// Returns whether a system code has this meaning.
bool isSystemCode(int systemCode, std::errc meaning);

/// Forgets earlier failures of standard streams on this thread, for streamCode().
void clearStreamCode();

/// Returns the system code of the last failure of a standard stream (std::ifstream, std::fwrite()) on this thread; 0 if
/// none has failed since clearStreamCode().
int streamCode();
} // namespace core
