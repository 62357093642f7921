# Compiles for Windows 10 and later on Debian, by its MinGW-w64 with threads of POSIX (g++-mingw-w64-x86-64-posix).
#   cmake -S . -B build/windows --toolchain resources/packaging/windows/toolchain.cmake -DFETTLE_WINDOWS_PREFIX=<folder>
# FETTLE_WINDOWS_PREFIX: the folder with include/, lib/ and share/ of the libraries for Windows. Nothing else is looked
# for there, and no library of this system is found.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FETTLE_WINDOWS_PREFIX)
set(CMAKE_FIND_ROOT_PATH ${FETTLE_WINDOWS_PREFIX} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
