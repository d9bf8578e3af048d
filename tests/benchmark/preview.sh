#!/usr/bin/env bash
# Seconds that `wold preview` takes for scenes: by the clock and, all threads together, of the
# processors. The median of three runs each.
#
#     tests/benchmark/preview.sh [SCENE...]       default: all of examples/ and examples/figures/
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
wold=$here/build/wold
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

[ $# -gt 0 ] || set -- "$here"/examples/*.toml "$here"/examples/figures/*.toml
echo '| scene | seconds | of processors |'
echo '|---|---|---|'
for scene in "$@"; do
  for run in 1 2 3; do
    /usr/bin/time -a -f '%e %U %S' -o "$work/times" \
      "$wold" preview "$scene" --quiet --out "$work/$run.png" >"$work/log"
  done
  sort -n "$work/times" |
    awk -v scene="$(basename "$scene" .toml)" \
      'NR == 2 {printf "| %s | %.1f | %.1f |\n", scene, $1, $2 + $3}'
  rm "$work/times"
done
