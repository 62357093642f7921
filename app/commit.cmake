# Writes a header with the commit of SOURCE, empty if that is no clone, to FILE, if it has changed.
cmake_minimum_required(VERSION 3.25)
find_package(Git QUIET)
if(GIT_FOUND)
    execute_process(
        COMMAND ${GIT_EXECUTABLE} --git-dir=${SOURCE}/.git rev-parse --short=8 HEAD
        OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(CONFIGURE OUTPUT ${FILE} CONTENT "#define FETTLE_COMMIT \"@COMMIT@\"\n" @ONLY)
