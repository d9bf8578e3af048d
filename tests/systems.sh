#!/usr/bin/env bash
# Whether Wold builds and shows the same on every Debian that people have, with every renderer there:
#
#     tests/systems.sh [SYSTEM...]       as root; default: bookworm trixie sid
#
# In a clean root of each system, a fresh clone of what is committed runs examples/run.sh, the tests
# that look at pictures, and the one that compares bytes with Debian 12's. Then each renderer of the
# system makes the same scenes: Blender, POV-Ray, on bookworm the package bpy 4.5, on trixie bpy 5.2, on
# sid POV-Ray 3.8. Prints one table; pictures are compared with those of bookworm's Blender 3.4 and
# POV-Ray 3.7, by mean FLIP and, in 255ths, after a blur of 8x8 pixels. Takes hours. Roots, logs and
# pictures stay in ~/.cache/wold/systems.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"
# shellcheck source=support/roots.sh
source "$here/tests/support/roots.sh"

# What is rendered: a name, the scene, the frame, and what else the picture needs.
scenes=(
  "hillside hillside 2"
  "mountain ../tests/data/small_mountain 2"
  "cumulus cumulus 1"
  "first_snow first_snow 24"
  "fog autumn_to_winter 90"
  "blades hillside 2 --grass blades"
  "points figures/points 2"
)
declare -A bpy_of_system=([bookworm]=4.5 [trixie]=5.2)
picture_tests='^(BlenderRender|BlenderAddOn|GoldenHillside|OnePicture)\.|/(Renderers|OneLook)\.|^SameBytes$'
clone=/root/wold # in each root
made=/root/made

row() { printf '| %s ' "$@" && echo '|'; }

in_clone() { in_root "$1" env -C "$clone" "${@:2}"; }

# version_of SYSTEM PACKAGE: without what Debian adds to it.
version_of() {
  in_root "$1" dpkg-query -W "$2" | sed -E 's/.*\t([0-9]+:)?//; s/[-+~].*//'
}

# built_with SYSTEM: compiler and libraries whose versions matter.
built_with() {
  local package versions=()
  for package in g++ cmake libopenvdb-dev libopenimageio-dev libfmt-dev libgdal-dev; do
    versions+=("$package $(version_of "$1" "$package")")
  done
  echo "${versions[*]}"
}

make_clone() {
  local system_root=$cache/$1
  rm -rf "${system_root:?}$clone" "${system_root:?}$made"
  git clone -q "$here" "$system_root$clone"
  in_root "$1" mkdir -p "$made"
}

# attempt LOG COMMAND...: its exit code and seconds.
attempt() {
  local begin=$SECONDS code=0
  "${@:2}" >"$1" 2>&1 </dev/null || code=$?
  echo "$code $((SECONDS - begin))"
}

# run_main_job SYSTEM: how many pictures examples/run.sh makes, or why it does not.
run_main_job() {
  local log=$cache/$1.main_job.log code seconds pictures
  read -r code seconds < <(attempt "$log" in_clone "$1" ./examples/run.sh)
  pictures=$(find "$cache/$1$clone/out" -path '*/frames/*' -name '*.png' 2>/dev/null | wc -l)
  row "$1" "built with $(built_with "$1")" "examples/run.sh: $pictures pictures, exit code $code" \
    - - "$seconds" -
  [ "$code" = 0 ] || row "$1" - "$(tail -1 "$log")" - - - -
}

run_picture_tests() {
  local log=$cache/$1.tests.log seconds
  read -r _ seconds < <(attempt "$log" in_clone "$1" ./tests/run.sh -R "$picture_tests")
  row "$1" - "tests/run.sh: $(grep -m1 '% tests passed' "$log" || tail -1 "$log")" - - "$seconds" -
}

# POV-Ray 3.8 is in experimental alone, and 3.7 must leave for it: it is unpacked beside.
add_povray_beta() {
  [ ! -d "$cache/$1/opt/povray-3.8" ] || return 0
  sed 's/ sid / experimental /' "$cache/$1/etc/apt/sources.list" \
    >"$cache/$1/etc/apt/sources.list.d/experimental.list"
  in_root "$1" apt-get update -q >&2
  in_root "$1" env -C /var/tmp apt-get download -q povray/experimental >&2
  in_root "$1" bash -c 'dpkg -x /var/tmp/povray_*.deb /opt/povray-3.8'
}

# renderers_of SYSTEM: kinds and programs, a line each; Debian's own first.
renderers_of() {
  echo "blender blender"
  echo "povray povray"
  [ -z "${bpy_of_system[$1]:-}" ] || echo "blender $(bpy_in "$1" "${bpy_of_system[$1]}")"
  [ "$1" != sid ] || echo "povray /opt/povray-3.8/usr/bin/povray"
}

# of_wold SYSTEM COMMAND OUT SCENE FRAME OPTION...: data or a picture of a scene.
of_wold() {
  in_clone "$1" build/wold "$2" "examples/$4.toml" --quiet --frames "$5" --size 240x136 \
    --samples 64 --out "$made/$3" "${@:6}"
}

# picture_of SYSTEM OUT KIND
picture_of() { find "$cache/$1$made/$2/frames/$3" -name '*.png' 2>/dev/null | head -1; }

# cost_of SYSTEM OUT KIND: seconds and megabytes that the renderer took.
cost_of() {
  sed -E 's/.*"seconds":([0-9.]+),"memory_bytes":([0-9.]+).*/\1 \2/' \
    "$cache/$1$made/$2/tasks/$3"_*.json | awk '{printf "%.1f %.0f\n", $1, $2 / 1e6}'
}

# apart GOT WANT: FLIP and blur; "-" where one of the pictures is missing.
apart() {
  if [ -f "$1" ] && [ -f "$2" ]; then "$here/build/picture_difference" "$1" "$2"; else echo -; fi
}

# render_scene SYSTEM OUT KIND PROGRAM NAME SCENE FRAME OPTION...: a row for a picture.
render_scene() {
  local log=$cache/$1.$2.log code got seconds megabytes
  cp -a "$cache/$1$made/$5" "$cache/$1$made/$2"
  read -r code _ < <(attempt "$log" of_wold "$1" render "$2" "${@:6}" --renderer "$3" "--$3" "$4")
  [ "$code" = 0 ] || {
    row "$1" "$4" "$5: exit code $code, $(tail -1 "$log")" - - - -
    return
  }
  got=$(picture_of "$1" "$2" "$3")
  read -r seconds megabytes < <(cost_of "$1" "$2" "$3")
  row "$1" "$4" "$5" "$(apart "$got" "$(picture_of bookworm "$5.1" blender)")" \
    "$(apart "$got" "$(picture_of bookworm "$5.2" povray)")" "$seconds" "$megabytes"
}

# keep_pictures SYSTEM NAME: and of all else that was made for a scene nothing.
keep_pictures() {
  find "$cache/$1$made" -mindepth 2 -maxdepth 2 -path "*/$2*/*" ! -name frames -exec rm -rf {} +
}

# compare_scene SYSTEM NAME SCENE FRAME OPTION...: by every renderer, from data made once.
compare_scene() {
  local kind program number=0 log=$cache/$1.$2.log code seconds
  read -r code seconds < <(attempt "$log" of_wold "$1" generate "${@:2}" --renderer both)
  row "$1" - "$2: generated, exit code $code" - - "$seconds" -
  [ "$code" = 0 ] || return 0
  while read -r kind program; do
    number=$((number + 1))
    render_scene "$1" "$2.$number" "$kind" "$program" "${@:2}"
  done < <(renderers_of "$1")
  keep_pictures "$1" "$2"
}

compare_renderers() {
  local line scene
  for line in "${scenes[@]}"; do
    read -ra scene <<<"$line"
    compare_scene "$1" "${scene[@]}"
  done
}

check_system() {
  make_root "$1"
  make_clone "$1"
  run_main_job "$1"
  run_picture_tests "$1"
  [ "$1" != sid ] || add_povray_beta "$1"
  compare_renderers "$1"
}

install "${build_packages[@]}" "${test_packages[@]}" git
build -DWOLD_TESTS=ON -DWOLD_WERROR=ON -- picture_difference
row system renderer what 'FLIP, blur against Blender 3.4' 'against POV-Ray 3.7' seconds MB
row --- --- --- --- --- --- ---
[ $# -gt 0 ] || set -- bookworm trixie sid
for system in "$@"; do check_system "$system"; done
