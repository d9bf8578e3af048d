#!/usr/bin/env bash
# Time and memory of tests/data/small_mountain.toml by the number of its cells: what generating
# takes, how many parts of them are drawn, and what each renderer takes for one frame of 960x540.
#
#     tests/benchmark/cells.sh [CELLS PER SIDE...]       default: 10 40 80 160 320 1000
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
wold=$here/build/wold
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# measured COMMAND...: "seconds megabytes" of a command whose output is not wanted.
measured() {
  /usr/bin/time -f '%e %M' -o "$work/time" "$@" >"$work/log" 2>&1
  awk '{printf "%.1f %.0f", $1, $2 / 1024}' "$work/time"
}
times() { awk -v side="$1" -v factor="$2" 'BEGIN {print side * factor}'; }

echo '| cells | parts drawn | generate | memory | Blender | memory | POV-Ray | memory |'
echo '|---|---|---|---|---|---|---|---|'
[ $# -gt 0 ] || set -- 10 40 80 160 320 1000
for cells in "$@"; do
  out=$work/$cells
  size=$(times "$cells" 0.6)
  read -r generate_s generate_mb < <(measured "$wold" generate \
    "$here/tests/data/small_mountain.toml" --quiet --frames 2 --size 960x540 --out "$out" --set "terrain.size=$size" \
    --set "terrain.hill_height=$(times "$size" 0.2083)" \
    --set "camera.eye=[$(times "$size" 0.5), 0.5]" \
    --set "camera.target=[$(times "$size" 0.51), $(times "$size" 0.333)]"; echo)
  drawn=$(head -1 "$out/povray/data/frame_0002/cells.txt" | tr -d ,)
  read -r blender_s blender_mb < <(measured blender -b --python-exit-code 1 \
    -P "$here/templates/blender/wold_render.py" -- "$out/blender" 2 --out "$out/2.png"; echo)
  read -r povray_s povray_mb < <(cd "$out/povray" && measured povray data/frame_0002.ini; echo)
  echo "| $((cells * cells)) | $drawn | $generate_s s | $generate_mb MB |" \
    "$blender_s s | $blender_mb MB | $povray_s s | $povray_mb MB |"
  rm -rf "$out"
done
