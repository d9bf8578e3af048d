#!/usr/bin/env bash
# Whether examples/engine/one_frame makes the same files as the program, and refuses what is wrong:
#
#     tests/engine.sh ONE_FRAME WOLD
set -euo pipefail
one_frame=$1
wold=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/scene.toml" <<'SCENE'
[terrain]
size = 12.0
hill_height = 1.0
relief = 0.1
[grass]
levels = [30]
variants = 1
[camera]
eye = [6.0, 1.0]
target = [6.0, 8.0]
[render]
renderer = "both"
size = [96, 54]
[ageing]
frames = [0.0, 0.4]
SCENE
cd "$folder"
"$one_frame" scene.toml 2 by_engine >files
"$wold" generate scene.toml --frames 2 --out by_program --quiet
[ -s files ]
while read -r file; do cmp "$file" "by_program/${file#by_engine/}"; done <files
diff <(cd by_engine && find blender povray texels -type f | sort) \
  <(cd by_program && find blender povray texels -type f | sort)

if "$one_frame" scene.toml 3 by_engine 2>message; then exit 1; fi
grep -qF "found frame 3, expected 1 to 2" message
