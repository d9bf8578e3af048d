#!/usr/bin/env bash
# What USD's own library and Blender find in the stages of `--renderer usd`:
#
#     tests/usd.sh                          the library; takes half a minute
#     tests/usd.sh blender [PROGRAM...]     Blender; default: bpy 4.5 LTS and 5.2 LTS
#
# The library, a Python package that nothing else needs, validates stages of small films and
# compares them with Blender's files of the same films (usd/stage_check.py). Blender imports the
# hillside's blades and renders them, and its picture is held against that of the scene files: exit
# code 1 when it is farther away than FLIP 0.05. Needs what tests/run.sh builds.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"
# shellcheck source=support/roots.sh
source "$here/tests/support/roots.sh"

wold=$here/build/wold
most_flip=0.05

# Two frames seen from two places, on a slope.
small_film() {
  cat <<'EOF'
name = "small"
seed = 3
terrain = { size = 6, samples = 49 }
grass = { blades = 40, variants = 2, levels = [30], key_frames = [0.0, 1.0] }
ageing = { frames = [0.1, 0.8] }
camera = { eye = [3, 0.5], target = [3, 4] }
render = { renderer = ["blender", "usd"], size = [64, 36], samples = 1 }
EOF
}

check_stages() {
  local grass
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  install python3 python3-venv
  python3 -m venv "$here/build-usd"
  "$here/build-usd/bin/pip" install -q --disable-pip-version-check 'usd-core==26.*'
  small_film >"$folder/small.toml"
  say "USD"
  for grass in blades texels; do
    "$wold" generate "$folder/small.toml" --quiet --grass $grass --out "$folder/$grass" >/dev/null
    "$here/build-usd/bin/python" "$here/tests/usd/stage_check.py" "$folder/$grass"
  done
}

# compare PROGRAM: a row of FLIP of the stage's picture to that of the scene files.
compare() {
  local picture=$out/usd.png flip
  rm -rf "$out/frames" "$picture"
  "$wold" render "$here/examples/hillside.toml" "${options[@]}" --renderer blender --blender "$1" \
    --out "$out" >&2
  "$1" "$here/tests/usd/blender_picture.py" "$out/usd/frame.0002.usda" "$picture" >&2
  read -r flip _ < <("$here/build/picture_difference" "$picture" "$out/frames/blender/0002.png")
  echo "| $1 | $flip |"
  awk -v flip="$flip" -v most="$most_flip" 'BEGIN {exit !(flip <= most)}'
}

check_blenders() {
  local far=0 program
  out=$here/build/usd_in_blender
  options=(--frames 2 --size 240x135 --samples 64 --grass blades --quiet)
  [ $# -gt 0 ] || set -- "$(bpy_program 4.5)" "$(bpy_program 5.2)"
  "$wold" generate "$here/examples/hillside.toml" "${options[@]}" --renderer usd --out "$out" >&2
  echo '| renderer | FLIP |'
  echo '|---|---|'
  for program in "$@"; do compare "$program" || far=1; done
  [ $far = 0 ] || {
    echo "error: found a picture farther away than FLIP $most_flip; look at $out" >&2
    exit 1
  }
}

if [ "${1:-}" = blender ]; then check_blenders "${@:2}"; else check_stages; fi
