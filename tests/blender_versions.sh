#!/usr/bin/env bash
# Whether versions of Blender show the same: renders tests/benchmark/phenomena.toml with Debian's
# Blender and with each PROGRAM, Blender or a Python with the package bpy, and compares. 4.5 and 5.2
# are the long-term versions of bpy of the package index.
#
#     tests/blender_versions.sh [PROGRAM...]     default: 4.5 5.2
#
# Prints a table; exit code 1 when a picture is farther from Debian's than FLIP 0.02, or 2/255 after
# a blur of 8x8 pixels. The pictures stay in build/blender_versions.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"
# shellcheck source=support/roots.sh
source "$here/tests/support/roots.sh"

scene=$here/tests/benchmark/phenomena.toml
out=$here/build/blender_versions
most_flip=0.02
most_blur=2 # of 255

# render NAME PROGRAM: the frames by a renderer, of the same data for all; seconds on stdout.
render() {
  local begin=$SECONDS
  cp -a "$out/data" "$out/$1"
  "$here/build/wold" render "$scene" --quiet --renderer blender --blender "$2" --out "$out/$1" >&2
  echo $((SECONDS - begin))
}

is_near() {
  awk -v flip="$1" -v blur="$2" -v most_flip="$most_flip" -v most_blur="$most_blur" \
    'BEGIN {exit !(flip <= most_flip && blur <= most_blur)}'
}

# compare NAME PROGRAM SECONDS: a row per frame; whether all are near enough.
compare() {
  local picture flip blur far=0
  for picture in "$out"/debian/frames/blender/*.png; do
    read -r flip blur < <("$here/build/picture_difference" \
      "$out/$1/frames/blender/${picture##*/}" "$picture")
    echo "| $2 | ${picture##*/} | $flip | $blur | $3 s |"
    is_near "$flip" "$blur" || far=1
  done
  return $far
}

install "${build_packages[@]}" "${render_packages[@]}" "${test_packages[@]}"
[ $# -gt 0 ] || set -- 4.5 5.2
build -DWOLD_TESTS=ON -DWOLD_WERROR=ON -- wold picture_difference
rm -rf "$out"
"$here/build/wold" generate "$scene" --quiet --renderer blender --out "$out/data"
render debian blender >/dev/null
echo '| renderer | frame | FLIP | blur, of 255 | seconds for all |'
echo '|---|---|---|---|---|'
number=0 far=0
for program in "$@"; do
  case $program in 4.5 | 5.2) program=$(bpy_program "$program") ;; esac
  number=$((number + 1))
  seconds=$(render "$number" "$program")
  compare "$number" "$program" "$seconds" || far=1
done
[ $far = 0 ] || {
  echo "error: found a picture farther from Debian's Blender than FLIP $most_flip or blur" \
    "$most_blur/255; look at $out" >&2
  exit 1
}
