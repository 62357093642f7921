# Included by ../../CMakeLists.txt for Windows: what is installed beside the program, the installer and the zip.

# Qt finds its plugins and its own texts by qt.conf.
file(WRITE ${PROJECT_BINARY_DIR}/qt.conf "[Paths]\nPrefix=.\nPlugins=plugins\nTranslations=translations\n")
install(FILES ${PROJECT_BINARY_DIR}/qt.conf ${PROJECT_BINARY_DIR}/THIRD-PARTY.txt
    DESTINATION .)
set(QT_PLUGINS ${FETTLE_WINDOWS_PREFIX}/plugins)
set(LIBRARIES)
foreach(PLUGIN iconengines/qsvgicon imageformats/qgif imageformats/qico imageformats/qjpeg imageformats/qsvg
        platforms/qoffscreen platforms/qwindows styles/qwindowsvistastyle)
    cmake_path(GET PLUGIN PARENT_PATH FOLDER)
    install(FILES ${QT_PLUGINS}/${PLUGIN}.dll DESTINATION plugins/${FOLDER})
    list(APPEND LIBRARIES ${QT_PLUGINS}/${PLUGIN}.dll)
endforeach()
# The files of translations are the same on every system.
foreach(LANGUAGE de zh_CN)
    install(FILES /usr/share/qt6/translations/qtbase_${LANGUAGE}.qm DESTINATION translations)
endforeach()

# Installs the libraries that the program and the plugins name. CMake looks for names in lower case, which Qt's are not.
# Those of Windows are listed, so that packaging fails on any other.
set(KNOWN)
foreach(MODULE Core Gui Network OpenGL OpenGLWidgets Svg Widgets)
    set(FILE ${FETTLE_WINDOWS_PREFIX}/bin/Qt6${MODULE}.dll)
    install(FILES ${FILE} DESTINATION .)
    list(APPEND LIBRARIES ${FILE})
    string(TOLOWER qt6${MODULE} NAME)
    list(APPEND KNOWN ${NAME})
endforeach()
list(APPEND KNOWN
    advapi32 api-ms-win-core-synch-l1-2-0 api-ms-win-core-winrt-l1-1-0 api-ms-win-core-winrt-string-l1-1-0 authz bcrypt
    comdlg32 d3d11 d3d9 dnsapi dwmapi dwrite dxgi gdi32 imm32 iphlpapi kernel32 mpr msvcrt netapi32 ole32 oleaut32
    opengl32 secur32 shcore shell32 shlwapi user32 userenv uxtheme version winhttp winmm ws2_32 wtsapi32)
list(TRANSFORM KNOWN PREPEND "^")
list(TRANSFORM KNOWN APPEND "[.]")
if(TARGET fettle_simulator)
    list(APPEND LIBRARIES "$<TARGET_FILE:fettle_simulator>")
endif()
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libstdc++-6.dll
    OUTPUT_VARIABLE RUNTIME OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
cmake_path(GET RUNTIME PARENT_PATH RUNTIME)
set(FOLDERS ${FETTLE_WINDOWS_PREFIX}/bin ${RUNTIME} /usr/x86_64-w64-mingw32/lib)
install(CODE "
    set(CMAKE_GET_RUNTIME_DEPENDENCIES_PLATFORM windows+pe)
    set(CMAKE_GET_RUNTIME_DEPENDENCIES_TOOL objdump)
    set(CMAKE_GET_RUNTIME_DEPENDENCIES_COMMAND ${CMAKE_OBJDUMP})
    set(LIBRARIES \"${LIBRARIES}\")
    set(FOLDERS \"${FOLDERS}\")
    set(KNOWN \"${KNOWN}\")
    file(GET_RUNTIME_DEPENDENCIES
        EXECUTABLES \"$<TARGET_FILE:fettle>\"
        LIBRARIES \${LIBRARIES}
        DIRECTORIES \${FOLDERS}
        PRE_EXCLUDE_REGEXES \${KNOWN}
        RESOLVED_DEPENDENCIES_VAR FOUND)
    file(INSTALL \${FOUND} DESTINATION \"\${CMAKE_INSTALL_PREFIX}\" FOLLOW_SYMLINK_CHAIN)")

set(CPACK_GENERATOR NSIS ZIP)
set(CPACK_PACKAGE_FILE_NAME fettle-${PROJECT_VERSION}-windows-x86_64)
set(CPACK_PACKAGE_INSTALL_DIRECTORY Fettle)
set(CPACK_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}) # NSIS.template.in
set(CPACK_NSIS_MUI_ICON ${PROJECT_BINARY_DIR}/app/fettle.ico)
