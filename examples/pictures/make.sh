#!/usr/bin/env bash
# Makes the pictures of README and of the manual anew, here:
#
#     examples/pictures/make.sh [NAME...]     default: all of them; e.g. hillside sunset
#
# Both renderers make each frame; all take about an hour on two cores.
set -euo pipefail
source "$(dirname "$0")/../setup.sh"

# tiled COLUMNS OUT PICTURE...: one picture, row by row.
tiled() {
  cat "${@:3}" | ffmpeg -v error -y -f image2pipe -c:v png -i - \
    -vf "tile=${1}x$((($# - 2) / $1))" -frames:v 1 -q:v 2 "$2"
}

# make NAME SCENE SIZE beside|above FRAME...: frames below each other, Blender beside POV-Ray, or
# beside each other, Blender above POV-Ray. Of an example, or of the file SCENE.
make() {
  local name=$1 arrangement=$4 out=$here/build/pictures/$1 frames=() blender=() povray=() pairs=() frame
  local scene=$2
  [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" $name "* ]] || return 0
  say "$name"
  frames=("${@:5}")
  [ -e "$scene" ] || scene=$here/examples/$scene.toml
  "$here/build/wold" render "$scene" --quiet --out "$out" --renderer both --size "$3" \
    --frames "$(IFS=, && echo "${frames[*]}")" >/dev/null
  for frame in "${frames[@]}"; do
    blender+=("$(printf '%s/frames/blender/%04d.png' "$out" "$frame")")
    povray+=("$(printf '%s/frames/povray/%04d.png' "$out" "$frame")")
    pairs+=("${blender[-1]}" "${povray[-1]}")
  done
  if [ "$arrangement" = beside ]; then
    tiled 2 "$here/examples/pictures/$name.jpg" "${pairs[@]}"
  else
    tiled ${#frames[@]} "$here/examples/pictures/$name.jpg" "${blender[@]}" "${povray[@]}"
  fi
}

# film NAME SCENE SIZE: all frames of a scene that lasts seconds, POV-Ray's, as a film of 24 a second.
film() {
  local name=$1 out=$here/build/pictures/$1
  [ ${#wanted[@]} -eq 0 ] || [[ " ${wanted[*]} " == *" $name "* ]] || return 0
  say "$name"
  "$here/build/wold" render "$here/examples/$2.toml" --quiet --out "$out" --renderer povray \
    --size "$3" >/dev/null
  ffmpeg -v error -y -framerate 24 -i "$out/frames/povray/%04d.png" -c:v libwebp_anim -loop 0 \
    -quality 75 -compression_level 6 "$here/examples/pictures/$name.webp"
}

# scene_of NAME MODEL: the file of a new scene of a real place.
scene_of() {
  local folder=$here/build/pictures
  mkdir -p "$folder"
  rm -f "$folder/$1.toml"
  (cd "$folder" && "$here/build/wold" new "$1" --terrain "$2" >/dev/null)
  echo "$folder/$1.toml"
}

wanted=("$@")
install "${build_packages[@]}" "${render_packages[@]}"
build -- wold
make hillside hillside 480x270 beside 1 2 3
make hills hill_path 480x270 above 1 2 3
make valley "$(scene_of valley "$here/tests/data/terrain/bigtujunga_srtm30.tif")" 480x270 above 1 2 3
make alpine_meadow alpine_meadow 720x405 above 1 3
make range snowy_range 720x405 above 1
make snow first_snow 640x360 beside 5 18 48
make storm ground_blizzard 480x270 beside 1 13
make clouds cumulus 720x405 beside 2
make sunset clouds 480x200 above 36 62 84
make season mountain 360x202 above 1 2 3 5
film windy_meadow windy_meadow 240x135
