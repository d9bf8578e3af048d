#!/usr/bin/env bash
# Texels against what one has without them, true blades as instanced meshes: the same view, the same
# machine, the same run. For each renderer and route: time, that of the processors, memory, and the
# noise that is left, as the root mean square error against the same route with 64 samples per pixel.
#
#     tests/benchmark/against_blades.sh [SCENE] [WOLD OPTIONS...]
#
# Default: tests/data/small_mountain.toml. SIZE=WxH sets the pictures' size, BLENDER another Blender,
# or a Python that has the package bpy.
#
# The pictures stay in build/against_blades.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
wold=$here/build/wold
scene=${1:-$here/tests/data/small_mountain.toml}
[ $# -eq 0 ] || shift
out=$here/build/against_blades
IFS=x read -r -a size <<<"${SIZE:-240x135}"
blender=${BLENDER:-blender}
script=$here/templates/blender/wold_render.py
case $(basename "$blender") in
  python*) blender_command=("$blender" "$script") ;;
  *) blender_command=("$blender" -b --python-exit-code 1 -P "$script") ;;
esac
mkdir -p "$out"

# measured COMMAND...: "seconds processor_seconds megabytes" of a command whose output is not wanted.
measured() {
  /usr/bin/time -f '%e %U %S %M' -o "$out/time" "$@" >"$out/log" 2>&1
  awk '{printf "%.1f %.1f %.0f\n", $1, $2 + $3, $4 / 1024}' "$out/time"
}
# picture RENDERER ROUTE SAMPLES FILE: renders with that many samples per pixel.
picture() {
  local depth
  depth=$(awk -v n="$3" 'BEGIN {print int(sqrt(n))}')
  if [ "$1" = blender ]; then
    measured "${blender_command[@]}" -- "$out/$2/blender" 1 \
      --size "${size[0]}x${size[1]}" --samples "$3" --out "$4"
  else
    (cd "$out/$2/povray" && measured povray data/frame_0001.ini "+W${size[0]}" "+H${size[1]}" \
      +AM1 "$([ "$depth" -gt 1 ] && echo +A0.0 || echo -A)" "+R$depth" "+O$4")
  fi
}
rmse() { "$wold" compare "$1" "$2" 2>/dev/null | sed -n 's/^ *"rmse": \(.*\),$/\1/p' | tail -1; }

echo '| renderer | drawn as | samples | time | processor | memory | error |'
echo '|---|---|---|---|---|---|---|'
for route in texels blades; do
  "$wold" generate "$scene" --quiet --frames 1 --size "${size[0]}x${size[1]}" \
    --out "$out/$route" --grass "$route" --renderer both "$@"
done
for renderer in blender povray; do
  for route in texels blades; do
    best=$out/${renderer}_${route}_64.png
    picture "$renderer" "$route" 64 "$best" >/dev/null
    for samples in 1 4 16; do
      file=$out/${renderer}_${route}_$samples.png
      read -r seconds busy megabytes < <(picture "$renderer" "$route" "$samples" "$file")
      echo "| $renderer | $route | $samples | $seconds s | $busy s | $megabytes MB | $(printf %.4f "$(rmse "$file" "$best")") |"
    done
  done
done
