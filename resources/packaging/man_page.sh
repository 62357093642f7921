#!/usr/bin/env bash
# Makes the manual page of fettle from pages of the reference, compressed as Debian has it.
#   man_page.sh VERSION OUT.gz PAGE...
# A table becomes a list: its first column is the term, the other columns explain it, by their heads from the third on.
set -euo pipefail
version=$1
out=$2
shift 2
awk -v version="$version" '
function inline(text)
{
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    while (match(text, /\[[^]]*\]\([^)]*\)/)) { # a link: its words
        words = substr(text, RSTART + 1, RLENGTH - 1)
        sub(/\].*/, "", words)
        text = substr(text, 1, RSTART - 1) words substr(text, RSTART + RLENGTH)
    }
    while (sub(/`/, "\\fB", text))
        sub(/`/, "\\fR", text)
    return text
}
function line(text) # a dot or a quote at the beginning would be a command
{
    text = inline(text)
    return text ~ /^[.'\'']/ ? "\\&" text : text
}
function row(text,   count, cell, i)
{
    gsub(/\\\|/, "\001", text)
    count = split(text, cell, /[ ]*\|[ ]*/)
    for (i = 2; i < count; ++i)
        gsub(/\001/, "|", cell[i])
    if (!inTable) { # the heads
        for (i = 2; i < count; ++i)
            head[i] = toupper(substr(cell[i], 1, 1)) substr(cell[i], 2)
        return
    }
    print ".TP\n" line(cell[2])
    print line(toupper(substr(cell[3], 1, 1)) substr(cell[3], 2)) (cell[3] ~ /[.]$/ ? "" : ".")
    for (i = 4; i < count; ++i)
        if (cell[i] != "")
            print line(head[i] ": " cell[i] ".")
}
BEGIN {
    print ".TH FETTLE 1 \"\" \"fettle " version "\" \"User Commands\""
    print ".SH NAME\nfettle \\- sculpt closed 3D models and check, repair, convert and print them"
    print ".SH SYNOPSIS\n.B fettle\n[\\fIOPTION\\fR] [\\fIFILE\\fR]\n.br"
    print ".B fettle\n\\fICOMMAND\\fR [\\fIOPTION\\fR...] [\\fIFILE\\fR...]"
    print ".SH DESCRIPTION"
}
FNR == 1 {isLead = NR > 1; next} # what comes before the first heading of a later page
/^## / {isLead = 0}
isLead {next}
/^```/ {inExample = !inExample; print inExample ? ".PP\n.RS 4\n.nf" : ".fi\n.RE"; next}
inExample {print line($0); next}
/^\|[-|]+$/ {next}
/^\|/ {row($0); inTable = 1; next}
{inTable = 0}
/^##+ / {sub(/^#+ /, ""); print ".SH " toupper($0); next}
/^- / {print ".IP \\(bu 2\n" line(substr($0, 3)); inList = 1; next}
/^  / && inList {print line(substr($0, 3)); next}
/^$/ {print ".PP"; inList = 0; next}
{print line($0)}
END {
    print ".SH SEE ALSO"
    print "The pages of the reference, in the folder \\fIreference\\fR of the documentation of this package: strokes,"
    print "presets, lessons, classes, and the fields of JSON and CSV."
}' "$@" | gzip -9n >"$out"
