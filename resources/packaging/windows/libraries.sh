# shellcheck shell=bash
# Sourced by build.sh: builds for Windows the libraries that the program needs, from Debian's source packages.
# Each is built once. Its folder is named after its options, patches, version and compiler, and the libraries that it
# needs. What was begun goes on where it was stopped.

# source_apt COMMAND ARGUMENTS: apt-get or apt-cache with the sources of Debian's archives that this release uses. Their
# lists are fetched once a day; those of the system stay as they are.
source_apt()
{
    local command=$1 codename lists options
    shift
    codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
    lists=$cache/apt-$codename
    options=(-q -o "Dir::Etc::SourceList=$lists/sources.list" -o Dir::Etc::SourceParts=/dev/null
        -o "Dir::State::Lists=$lists/lists" -o "Dir::Cache=$lists/cache" -o APT::Sandbox::User=root)
    if [ -z "$(find "$lists/fetched" -mtime -1 2>/dev/null)" ]; then
        mkdir -p "$lists/lists" "$lists/cache"
        # The release itself first: of equal versions apt takes the first, and not every mirror keeps security updates.
        apt-get indextargets --format '$(CODENAME) deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)' \
            'Created-By: Packages' 'Origin: Debian' 'Component: main' |
            sed -n "s/^$codename[^ ]* //p" | sort -u -k3 >"$lists/sources.list"
        # apt-get succeeds without a network, too, and without a list
        if apt-get "${options[@]}" update >&2 && compgen -G "$lists/lists/*_Sources*" >/dev/null; then
            touch "$lists/fetched"
        fi
    fi
    "$command" "${options[@]}" "$@"
}

# fetch_source SOURCE: unpacks it, with Debian's patches, as sources/SOURCE-VERSION, and sets $version: the newest that
# this release has and that can be fetched.
fetch_source()
{
    local source=$1 folder part=$cache/sources/part versions
    versions=$({ source_apt apt-cache showsrc "$source" | sed -n 's/^Version: //p'
        find "$cache/sources" -maxdepth 1 -name "$source-[0-9]*" -printf '%f\n' | sed "s/^$source-//"; } | sort -ruV)
    for version in $versions; do
        folder=$cache/sources/$source-$version
        [ ! -d "$folder" ] || return 0
        fettle_say "Fetching the source package $source $version"
        rm -rf "$part"
        mkdir -p "$part"
        (cd "$part" && source_apt apt-get source --only-source "$source=$version") >"$cache/fetch.log" 2>&1 || {
            grep '^E:' "$cache/fetch.log" >&2 || true
            continue
        }
        mv "$(find "$part" -mindepth 1 -maxdepth 1 -type d)" "$folder"
        rm -rf "$part"
        return 0
    done
    fettle_fail "the source package $source cannot be fetched (is there a network?). Unpack it yourself as" \
        "$cache/sources/$source-VERSION, and start again. Versions of this release: ${versions:-unknown}"
}

# prepared_source NAME SOURCE VERSION TREE: makes a copy of the source as TREE, with our patches.
prepared_source()
{
    local name=$1 source=$2 version=$3 tree=$4 patch
    [ ! -d "$tree" ] || return 0
    rm -rf "$tree.part"
    cp -al "$cache/sources/$source-$version" "$tree.part" # links; patch writes new files, and so must prepare_NAME
    for patch in "$windows/patches/$source"/*.patch; do
        [ ! -e "$patch" ] || patch -d "$tree.part" -p1 -N <"$patch" >&2 ||
            fettle_fail "$patch does not fit $source $version"
    done
    if declare -F "prepare_$name" >/dev/null; then
        "prepare_$name" "$tree.part"
    fi
    mv "$tree.part" "$tree"
}

# prepare_NAME TREE: what a library needs in its source before it is built.
prepare_minizip() { cp --remove-destination "$windows/minizip/CMakeLists.txt" "$1/contrib/minizip"; }
# The headers of Wintab, for pens. Debian leaves out Qt's copy; Wine has its own.
prepare_qtbase()
{
    local folder=$1/src/3rdparty/wintab wine=/usr/include/wine/wine/windows
    mkdir -p "$folder"
    cp --remove-destination "$windows/qtbase/wintab.h" "$wine/pktdef.h" "$folder"
    cp --remove-destination "$wine/wintab.h" "$folder/wine_wintab.h"
}

# library NAME SOURCE FOLDER NEEDED [CMAKE ARGUMENTS]: builds FOLDER of the source package. NEEDED names the libraries
# that it needs, which were built before.
declare -A key_of
common=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib)
library()
{
    local name=$1 source=$2 folder=$3 needed=$4 version key prefix build log other
    shift 4
    fetch_source "$source"
    key=$({
        echo "$name $source $version $folder ${common[*]} $*"
        for other in $needed; do
            echo "${key_of[$other]}"
        done
        "$compiler" --version
        dpkg-query -W mingw-w64-common libz-mingw-w64-dev libstb-dev libutfcpp-dev libwine-dev
        cat "$windows/toolchain.cmake" "$windows/patches/$source"/*.patch "$windows/$name"/* 2>/dev/null || true
        declare -f "prepare_$name" || true
    } | sha256sum | cut -c1-12)
    key_of[$name]=$key
    prefix=$cache/libraries/$name-$key
    build=$cache/build/$name-$key
    log=$build.log
    if [ ! -e "$prefix/complete" ]; then
        fettle_say "Building $name ($source $version)"
        for other in "$cache/build/$name"-*; do # of other recipes
            [[ $other = "$build"* ]] || rm -rf "$other"
        done
        prepared_source "$name" "$source" "$version" "$build.source"
        rm -rf "$prefix"
        mkdir -p "$build"
        cmake -G Ninja -S "$build.source/$folder" -B "$build" --toolchain "$windows/toolchain.cmake" \
            -DFETTLE_WINDOWS_PREFIX="$libraries" -DCMAKE_INSTALL_PREFIX="$prefix" "${common[@]}" "$@" >"$log" 2>&1 &&
            cmake --build "$build" -j "$(fettle_jobs)" >>"$log" 2>&1 &&
            cmake --install "$build" --strip >>"$log" 2>&1 || {
            tail -n 40 "$log" >&2
            fettle_fail "$name cannot be built; the end of $log stands above"
        }
        touch "$prefix/complete"
        rm -rf "$build" "$build.source"
    fi
    cp -al "$prefix/." "$libraries"
    sources+=("$cache/sources/$source-$version")
}

# build_libraries: all of them, together in $libraries.
build_libraries()
{
    unset CFLAGS CXXFLAGS CPPFLAGS LDFLAGS
    mkdir -p "$cache/build" "$cache/libraries" "$cache/sources"
    rm -rf "$libraries"
    mkdir -p "$libraries/include" "$libraries/share/cmake" "$libraries/lib/cmake"
    # Headers that are the same on every system
    local header qt
    for header in boost eigen3 nlohmann stb utf8.h utf8; do
        [ -e "/usr/include/$header" ] || fettle_fail "/usr/include/$header is missing"
        ln -s "/usr/include/$header" "$libraries/include/$header"
    done
    ln -s /usr/share/eigen3 "$libraries/share/eigen3"
    ln -s /usr/share/cmake/nlohmann_json "$libraries/share/cmake/nlohmann_json"

    library expat expat expat "" -DEXPAT_SHARED_LIBS=OFF -DEXPAT_BUILD_TOOLS=OFF -DEXPAT_BUILD_EXAMPLES=OFF \
        -DEXPAT_BUILD_TESTS=OFF -DEXPAT_BUILD_DOCS=OFF
    library libzip libzip . "" -DBUILD_TOOLS=OFF -DBUILD_REGRESS=OFF -DBUILD_EXAMPLES=OFF -DBUILD_DOC=OFF \
        -DENABLE_BZIP2=OFF -DENABLE_LZMA=OFF -DENABLE_OPENSSL=OFF -DENABLE_GNUTLS=OFF -DENABLE_MBEDTLS=OFF
    library openmesh openmesh . "" -DBUILD_APPS=OFF -DOPENMESH_DOCS=OFF
    library draco draco . ""
    library minizip zlib contrib/minizip ""
    library assimp assimp . "draco minizip" -DBUILD_SHARED_LIBS=OFF -DASSIMP_BUILD_ASSIMP_TOOLS=OFF \
        -DASSIMP_BUILD_TESTS=OFF -DASSIMP_NO_EXPORT=ON -DASSIMP_BUILD_ZLIB=OFF -DASSIMP_WARNINGS_AS_ERRORS=OFF \
        -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON -DUNZIP_FOUND=ON "-DUNZIP_INCLUDE_DIRS=$libraries/include/minizip" \
        "-DUNZIP_LIBRARIES=$libraries/lib/libminizip.a" "-DCMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES=$libraries/include"
    library jsoncpp libjsoncpp . "" -DBUILD_SHARED_LIBS=OFF -DBUILD_OBJECT_LIBS=OFF -DJSONCPP_WITH_TESTS=OFF \
        -DJSONCPP_WITH_POST_BUILD_UNITTEST=OFF -DJSONCPP_WITH_PKGCONFIG_SUPPORT=OFF
    library openxr openxr-sdk-source . jsoncpp -DBUILD_TESTS=OFF -DBUILD_API_LAYERS=OFF
    qt=(-DQT_HOST_PATH=/usr "-DQT_HOST_PATH_CMAKE_DIR=$qt_host_cmake" -DQT_BUILD_EXAMPLES=OFF -DQT_BUILD_TESTS=OFF)
    library qtbase qt6-base . "" "${qt[@]}" -DQT_FEATURE_sql=OFF -DQT_FEATURE_dbus=OFF -DQT_FEATURE_printsupport=OFF \
        -DQT_FEATURE_xml=OFF -DQT_FEATURE_vulkan=OFF -DQT_FEATURE_icu=OFF -DINPUT_opengl=desktop
    library qtsvg qt6-svg . qtbase "${qt[@]}"
}
