#!/usr/bin/env bash
# Writes which software of others a package of Fettle contains or uses, under which licences, and where its source is.
#   third_party.sh VERSION OUT FILE...            the files of Debian packages that are inside; a folder is an unpacked
#                                                 source package that was built
#   third_party.sh --linked VERSION OUT FILE...   the libraries that these programs of ours name
# The texts are those of /usr/share/doc/PACKAGE/copyright, and the common licences that these refer to. Libraries of
# which only headers are used are compiled into the program, so they are always listed.
set -euo pipefail
fail() { printf 'third_party.sh: %s\n' "$*" >&2; exit 3; }

linked=
if [ "$1" = --linked ]; then
    linked=1
    shift
fi
version=$1
out=$2
shift 2
headers=(/usr/include/eigen3/Eigen/Core /usr/include/boost/version.hpp /usr/include/nlohmann/json.hpp
    /usr/include/openxr/openxr.h)

# needed PROGRAM: the files of the libraries that it names itself.
needed()
{
    local names
    names=$(readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
    LC_ALL=C ldd "$1" | awk -v names="$names" '
        BEGIN {n = split(names, name, "\n"); for (i = 1; i <= n; ++i) wanted[name[i]]}
        $2 == "=>" && ($1 in wanted) {print $3}'
}

files=("$@")
about="Fettle contains or was built from the software below."
if [ "$linked" ]; then
    mapfile -t files < <(for program; do needed "$program"; done | sort -u)
    about="Fettle uses the libraries below, which are installed beside it, or contains code from their headers."
fi
files+=("${headers[@]}")
table= built=
declare -A package_of brings text_of
for i in "${!files[@]}"; do
    folder=${files[i]}
    [ -d "$folder" ] || continue
    unset "files[i]"
    for file in copyright changelog; do
        [ -r "$folder/debian/$file" ] || fail "$folder/debian/$file: there is no such file, so the licence is not known"
    done
    read -r source source_version < <(sed -n '1s/^\([^ ]*\) (\([^)]*\)).*/\1 \2/p' "$folder/debian/changelog")
    table+="$source $source_version $source"$'\n'
    text_of[$source]=$folder/debian/copyright
    brings[$source]=" built from its source"
    built=1
done
mapfile -t files < <(printf '%s\n' "${files[@]}" | LC_ALL=C sort -u)

# A package lists its files by /lib or by /usr/lib, which are the same folder.
for file in "${files[@]}"; do
    [ -e "$file" ] || fail "$file: there is no such file"
done
mapfile -t real < <(realpath -- "${files[@]}")
binaries=()
while read -r package file; do
    package_of[$file]=${package%%[,:]*}
done < <(dpkg-query -S "${real[@]}" "${real[@]#/usr}" 2>/dev/null | sed 's/, [^ ]*//g; s/: / /')
for i in "${!files[@]}"; do
    file=${files[i]}
    package=${package_of[${real[i]}]:-${package_of[${real[i]#/usr}]:-}}
    [ "$package" ] || fail "$file: no Debian package brings it, so its licence is not known"
    [ -r "/usr/share/doc/$package/copyright" ] ||
        fail "/usr/share/doc/$package/copyright: it is missing, so the licence of $file is not known"
    [[ "${brings[$package]-} " = *" ${file##*/} "* ]] || brings[$package]+=" ${file##*/}"
    binaries+=("$package")
    text_of[$package]=$(realpath "/usr/share/doc/$package/copyright")
done

# source, its version, package; by source
table+=$(dpkg-query -W -f='${source:Package} ${source:Version} ${Package}\n' "${binaries[@]}")
table=$(LC_ALL=C sort -u <<<"$table")
texts=()
rule=$(printf '=%.0s' {1..80})
{
    printf 'Third-party software in Fettle %s\n%s\n\n%s\n' "$version" "$rule" "$about"
    printf 'Each heading is a source package of Debian and its version. Its source, as it was built:\n\n'
    printf '    https://snapshot.debian.org/package/NAME/VERSION/\n    apt-get source NAME=VERSION\n\n'
    if [ "$built" ]; then
        printf 'What is built from its source has the changes of resources/packaging/windows in the source of Fettle.\n'
    fi
    printf 'Under it are the packages and files, then what Debian says of its copyright and licences.\n'
    printf 'Libraries under the LGPL are files of their own: they may be replaced by other builds of them.\n\n'
    awk '{print "    " $1 " " $2}' <<<"$table" | uniq
    last=
    while read -r source source_version package; do
        text=${text_of[$package]}
        if [ "$source $source_version" != "$last" ]; then
            last="$source $source_version"
            printf '\n%s\n%s\n%s\n' "$rule" "$last" "$rule"
            said=()
        fi
        printf '\n%s:%s\n' "$package" "${brings[$package]}"
        is_new=1
        for other in ${said[@]+"${said[@]}"}; do
            if cmp -s "$other" "$text"; then
                is_new=
            fi
        done
        if [ "$is_new" ]; then
            said+=("$text")
            texts+=("$text")
            printf '\n'
            cat "$text"
        fi
    done <<<"$table"
    while read -r licence; do
        [ -r "$licence" ] || continue
        printf '\n%s\nCommon licence: %s\n%s\n\n' "$rule" "${licence##*/}" "$rule"
        cat "$licence"
    done < <(grep -hoE '/usr/share/common-licenses/[A-Za-z0-9.+-]*[A-Za-z0-9]' "${texts[@]}" | LC_ALL=C sort -u)
} >"$out.part"
chmod 644 "$out.part" # whatever the umask is
mv "$out.part" "$out"
