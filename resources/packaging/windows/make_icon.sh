#!/bin/sh
# Makes a Windows icon, in the sizes that Windows shows, of a drawing.
#   make_icon.sh DRAWING.svg ICON.ico
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for size in 16 20 24 32 40 48 64 256; do
    rsvg-convert -w "$size" -h "$size" "$1" -o "$folder/$size.png"
done
icotool -c -o "$2" "$folder"/16.png "$folder"/20.png "$folder"/24.png "$folder"/32.png "$folder"/40.png \
    "$folder"/48.png "$folder"/64.png --raw="$folder"/256.png
