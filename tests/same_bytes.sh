#!/usr/bin/env bash
# Whether the files that `wold generate` writes are, byte by byte, those that it writes on other
# systems: those in tests/same_bytes.txt, made on Debian 12 with GCC.
#
#     tests/same_bytes.sh [--update] [--keep FOLDER] [PROGRAM]      build/wold without it
#
# Generates small scenes that need most of the program, and compares for each of them the hashes of all
# its files of a kind in a folder. Task records are left out: they have the time that was taken.
# --update takes what this system writes for right, and --keep leaves the files to look at.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
table=$here/tests/same_bytes.txt

small=(--size 64x36 --quiet --renderer both --set 'grass.levels=[30]' --set grass.variants=1
  --set 'grass.key_frames=[0,0.5,1]' --set terrain.samples=65)
# A name, the scene, the frame, and what else it is generated with.
scenes=(
  "hillside hillside 2"
  "blades ../tests/data/small_mountain 2 --grass blades"
  "snow first_snow 24"
  "storm ground_blizzard 2"
  "clouds clouds 2"
  "season autumn_to_winter 90"
  "fur fur 1"
  "flakes figures/snow_tornado 1"
  "points figures/points 2"
  "boulders hillside 2 --set terrain.boulders=200"
)

# hashes_of NAME FOLDER: for each folder and kind of file, as a line of the table.
hashes_of() {
  local kind
  cd "$2"
  find . -type f ! -path './tasks/*' | sed -E 's|^\./||; s|([^/]*/)?.*(\.[^.]*)$|\1*\2|' |
    LC_ALL=C sort | uniq -c | while read -r count kind; do
    echo "$1 $kind $count $(hash_of_kind "$kind")"
  done
}

# hash_of_kind FOLDER*.KIND: of the names and the content of those files of the current folder.
hash_of_kind() {
  local depth=()
  [[ $1 == */* ]] || depth=(-maxdepth 1)
  find "./${1%\**}" "${depth[@]}" -type f -name "*${1##*\*}" ! -path './tasks/*' -print0 |
    LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum | cut -c1-16
}

# generate NAME SCENE FRAME OPTION...
generate() {
  "$program" generate "$here/examples/$2.toml" --frames "$3" "${small[@]}" "${@:4}" \
    --out "$made/$1" >&2
}

update=false program=$here/build/wold made=
while [ $# -gt 0 ]; do
  case $1 in
  --update) update=true ;;
  --keep) made=$2 && shift ;;
  *) program=$(realpath "$1") ;;
  esac
  shift
done
[ -n "$made" ] || {
  made=$(mktemp -d)
  trap 'rm -rf "$made"' EXIT
}
mkdir -p "$made"
for line in "${scenes[@]}"; do
  read -ra scene <<<"$line"
  generate "${scene[@]}"
  (hashes_of "${scene[0]}" "$made/${scene[0]}")
done >"$made/same_bytes.txt"
if $update; then
  cp "$made/same_bytes.txt" "$table"
elif ! diff "$table" "$made/same_bytes.txt" >&2; then
  echo "error: these files (<: expected, >: made here) have other bytes than on other systems;" \
    "where they were meant to change: tests/same_bytes.sh --update" >&2
  exit 1
fi
