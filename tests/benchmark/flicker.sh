#!/usr/bin/env bash
# Whether a meadow that withers flickers: examples/flight.toml from a camera that stands still.
#
#     tests/benchmark/flicker.sh [OPTIONS OF wold render...]
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$here/build/wold" render "$here/examples/flight.toml" --quiet --size 480x270 --out "$work" \
  --set 'camera.eye_end=[]' --set 'camera.target_end=[]' "$@" >/dev/null
"$here/build/flicker" "$work"/frames/*/*.png
