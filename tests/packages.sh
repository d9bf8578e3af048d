#!/usr/bin/env bash
# Whether packages work for people who have nothing else of Wold:
#
#     tests/packages.sh [deb|tarball|container [SYSTEM...]]    as root; default: all, bookworm trixie
#
# In a fresh root folder of each Debian, which sees nothing of this machine, the package of
# packaging/build.sh is installed or unpacked, and a plain user makes a scene and its pictures. These
# are held against those of this build; then the package is removed, and nothing of it may be left.
# A .deb for another Debian than that of this machine is built there, from what is committed, which
# takes ten minutes. The tarball is the same everywhere, and reads an elevation model by the files of
# its own libraries. The container makes examples/hillside.toml without a network. Prints a table.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"
# shellcheck source=support/roots.sh
source "$here/tests/support/roots.sh"
# shellcheck disable=SC2034  # VERSION_CODENAME
this_system=$(source /etc/os-release && echo "$VERSION_CODENAME")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
user=walker
home=/home/$user
base_libraries='/lib(c|m|dl|rt|pthread|resolv|stdc\+\+|gcc_s)\.so' # of glibc and GCC
# Small, and the renderers' full way all the same.
size=(--frames "2,3" --size 240x136 --quiet)
# A newer Blender draws other random numbers, and there are four samples per pixel: found RMSE 0.010,
# FLIP 0.025, and after a blur of 8x8 pixels 0.0006.
other_blender=(--rmse 0.02 --share 0.2 --hard 0.5 --flip 0.04 --ssim 0.94)

row() { printf '| %s ' "$@" && echo '|'; }

fail() {
  echo "error: $*" >&2
  exit 1
}

in_bare() { "$here/tests/in_root.sh" --bare "$cache/$1" "${@:2}"; }

# as_user ROOT COMMAND...: in the user's own folder, who may write there and nowhere else.
as_user() {
  in_bare "$1" runuser -u "$user" -- env -C "$home" HOME="$home" PATH=/usr/local/bin:/usr/bin:/bin \
    "${@:2}"
}

install_with_recommended() {
  in_bare "$1" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q "${@:2}" \
    >>"$work/$1.log" 2>&1 || {
    tail -20 "$work/$1.log" >&2
    fail "cannot install ${*:2} in $1"
  }
}

# make_user_root SYSTEM ROOT: with a plain user in it.
make_user_root() {
  make_fresh_root "$1" "$2"
  in_bare "$2" useradd --create-home "$user"
  in_bare "$2" apt-get update -q >"$work/$2.log" 2>&1
}

# drop_root ROOT
drop_root() { rm -rf "${cache:?}/$1"; }

# wanted_pictures: of the starter scene, by this build and this machine's renderers; once.
wanted_pictures() {
  [ ! -d "$work/wanted" ] || return 0
  say "Making the pictures by this build"
  (cd "$work" && "$here/build/wold" new a >/dev/null 2>&1 &&
    "$here/build/wold" render a.toml "${size[@]}" --out wanted >/dev/null)
}

# require_picture FILE: a picture in which something is to be seen.
require_picture() {
  [ -f "$1" ] || fail "found no picture $1"
  "$here/build/wold" inspect --json "$1" >"$work/facts.json" || fail "$1 is damaged"
  grep -q '"blank": false' "$work/facts.json" || fail "$1 is blank"
  grep -q '"width": 240' "$work/facts.json" || fail "$1 is not 240 pixels wide"
}

# flip_of GOT WANT OPTION...: how far apart they are, or an error when that is too far.
flip_of() {
  "$here/build/wold" compare "$@" >"$work/differences.json" || {
    cat "$work/differences.json" >&2
    fail "$1 is not what this build makes"
  }
  sed -n 's/.*"flip": \([0-9.e-]*\).*/\1/p' "$work/differences.json" | tail -1
}

# limits_for SYSTEM RENDERER: of `wold compare`; this machine's renderers give the same pictures.
limits_for() {
  [ "$1" = "$this_system" ] || [ "$2" = povray ] || echo "${other_blender[*]}"
}

# compare_with_build SYSTEM WHAT OUT: what is given to renderers, byte for byte, and the pictures.
compare_with_build() {
  local renderer picture limits
  wanted_pictures
  diff -rq "$3/texels" "$work/wanted/texels" >&2 || fail "other texels"
  for renderer in povray blender; do
    diff -rq "$3/$renderer" "$work/wanted/$renderer" >&2 || fail "other data for $renderer"
    picture=frames/$renderer/0002.png
    require_picture "$3/$picture"
    read -ra limits < <(limits_for "$1" "$renderer") || true
    row "$1" "$2" "picture by $renderer" \
      "FLIP $(flip_of "$3/$picture" "$work/wanted/$picture" "${limits[@]}")"
  done
}

# make_first_scene SYSTEM WHAT ROOT WOLD: what a newcomer does.
make_first_scene() {
  local begin=$SECONDS film
  as_user "$3" "$4" new a >/dev/null 2>&1
  as_user "$3" "$4" render a.toml "${size[@]}" >/dev/null
  row "$1" "$2" "wold new, wold render" "$((SECONDS - begin)) s"
  compare_with_build "$1" "$2" "$cache/$3$home/out/a"
  as_user "$3" "$4" film out/a --frames 2-3 --quiet >/dev/null
  for film in film_blender.{mp4,webp} film_povray.{mp4,webp}; do
    [ -s "$cache/$3$home/out/a/$film" ] || fail "found no $film"
  done
  row "$1" "$2" "wold film" "4 films"
  row "$1" "$2" "wold --version" "$(as_user "$3" "$4" --version | tr -s ' ' | paste -sd ';')"
}

# --- .deb

# require_hint_of_examples ROOT: what the manual says before examples are copied.
require_hint_of_examples() {
  local said
  said=$(as_user "$1" wold check examples/hillside.toml 2>&1) && fail "found examples in a home"
  [[ $said =~ 'came with wold is '.*/usr/share/wold/examples/hillside.toml ]] ||
    fail "wold does not say where its examples are: $said"
}

# deb_for SYSTEM: its file.
deb_for() {
  if [ "$1" = "$this_system" ]; then
    "$here/packaging/build.sh" deb
    return
  fi
  make_root "$1"
  install_in "$1" git ca-certificates
  rm -rf "$cache/$1/root/wold"
  git clone -q "$here" "$cache/$1/root/wold"
  echo "$cache/$1$(in_root "$1" env -C /root/wold packaging/build.sh deb)"
}

# require_installed_files ROOT: what `man`, the shells, editors and people look for.
require_installed_files() {
  local file
  for file in man/man1/wold.1.gz man/man1/wold-render.1.gz bash-completion/completions/wold \
    zsh/vendor-completions/_wold fish/vendor_completions.d/wold.fish wold/examples/hillside.toml \
    wold/scene.schema.json doc/wold/copyright doc/wold/README.md; do
    in_bare "$1" test -s "/usr/share/$file" || fail "found no /usr/share/$file"
  done
}

# require_nothing_left ROOT LIST: of the package's files, or named so, outside the user's folder.
require_nothing_left() {
  local path left
  while read -r path; do
    # Folders that other packages have, too, stay.
    [ ! -e "$cache/$1$path" ] || in_bare "$1" dpkg-query -S "$path" >/dev/null 2>&1 ||
      fail "found $path after removal"
  done <"$2"
  left=$(in_bare "$1" find / -xdev -iname '*wold*' -not -path "$home/*" -not -path '/srv/*')
  [ -z "$left" ] || fail "found after removal: $left"
  ! in_bare "$1" dpkg-query -W wold 2>/dev/null || fail "dpkg knows wold still"
}

check_deb() {
  local place=$1.deb deb begin
  deb=$(deb_for "$1")
  make_user_root "$1" "$place"
  cp "$deb" "$cache/$place/srv"
  begin=$SECONDS
  install_with_recommended "$place" "/srv/${deb##*/}"
  row "$1" .deb "apt install ./${deb##*/}, $(stat -c %s "$deb") bytes" "$((SECONDS - begin)) s"
  require_installed_files "$place"
  require_hint_of_examples "$place"
  make_first_scene "$1" .deb "$place" wold
  in_bare "$place" dpkg-query -L wold >"$work/files"
  in_bare "$place" apt-get purge -y -q wold >>"$work/$place.log" 2>&1
  require_nothing_left "$place" "$work/files"
  row "$1" .deb "apt purge wold" "$(wc -l <"$work/files") paths gone"
  drop_root "$place"
}

# --- tarball

# require_own_libraries ROOT FOLDER: that none is missing, and none of the system's but its base.
require_own_libraries() {
  local foreign
  as_user "$1" ldd "$2/bin/wold" >"$work/libraries"
  foreign=$(grep -vE "=> $2/|linux-vdso|/ld-linux|$base_libraries" "$work/libraries") || true
  [ -z "$foreign" ] || fail "libraries from elsewhere: $foreign"
}

# write_slope FOLDER: a slope of an elevation model in degrees, which takes PROJ's proj.db to read.
write_slope() {
  mkdir "$1"
  {
    printf 'ncols 40\nnrows 40\nxllcorner 11.0\nyllcorner 47.0\ncellsize 0.0001\n'
    seq 1600 | awk '{printf "%.2f%s", 900 + 0.7 * ($1 % 40) + $1 / 40, $1 % 40 ? " " : "\n"}'
  } >"$1/dem.asc"
  cat >"$1/slope.toml" <<'EOT'
terrain = { size = 60, samples = 65, elevation = "dem.asc", system = "EPSG:4326" }
grass = { blades = 60, variants = 2, levels = [62] }
ageing = { frames = [0.3] }
EOT
}

# check_slope SYSTEM ROOT WOLD: that it has the bytes of this build.
check_slope() {
  local slope=$work/slope.$1 generate=(generate slope/slope.toml --quiet --renderer povray)
  mkdir "$slope"
  write_slope "$slope/slope"
  cp -r "$slope/slope" "$cache/$2$home"
  as_user "$2" "$3" "${generate[@]}" --out out/slope >/dev/null 2>&1
  (cd "$slope" && "$here/build/wold" "${generate[@]}" --out out >/dev/null 2>&1)
  diff -rq "$cache/$2$home/out/slope/povray" "$slope/out/povray" >&2 ||
    fail "another slope than this build's"
  row "$1" tarball "a slope in EPSG:4326" "the same bytes"
}

check_tarball() {
  local place=$1.tarball folder=$home/moved
  make_user_root "$1" "$place"
  cp "$tarball" "$cache/$place/srv"
  as_user "$place" sh -c "tar -xf /srv/${tarball##*/} && mv wold-* $folder"
  require_own_libraries "$place" "$folder"
  row "$1" tarball "$(stat -c %s "$tarball") bytes; libraries of its own" \
    "$(grep -c "=> $folder/" "$work/libraries")"
  check_slope "$1" "$place" "$folder/bin/wold"
  # Only now: they bring libraries along, and the system's proj.db.
  install_with_recommended "$place" blender povray
  make_first_scene "$1" tarball "$place" "$folder/bin/wold"
  drop_root "$place"
}

# --- container

# hillside_in_container: in what is shared with the container, which has no network.
hillside_in_container() {
  local container
  container=$(buildah from localhost/wold)
  unshare --net buildah run --volume "$work/shared:/work" "$container" -- \
    wold render /usr/share/wold/examples/hillside.toml "${size[@]}" >/dev/null
  buildah rm "$container" >/dev/null
}

check_container() {
  local begin=$SECONDS
  # Also where this runs in a container itself.
  export STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot
  "$here/packaging/build.sh" container >/dev/null
  row "$this_system" container "packaging/build.sh container" "$((SECONDS - begin)) s"
  begin=$SECONDS
  mkdir "$work/shared"
  hillside_in_container
  row "$this_system" container "hillside without a network" "$((SECONDS - begin)) s"
  rm -rf "$work/wanted"
  "$here/build/wold" render "$here/examples/hillside.toml" "${size[@]}" --out "$work/wanted" \
    >/dev/null
  compare_with_build "$this_system" container "$work/shared/out/hillside"
  buildah rmi --force "$(buildah images --quiet localhost/wold | head -1)" >/dev/null
}

[ "$(id -u)" -eq 0 ] || fail "root folders of other systems can be made by root only"
install "${build_packages[@]}" "${render_packages[@]}" debootstrap
kind=${1:-all}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- bookworm trixie
build -- wold
row system package what result
row --- --- --- ---
case $kind in all | tarball)
  tarball=$("$here/packaging/build.sh" tarball)
  for system in "$@"; do check_tarball "$system"; done
  ;;
esac
case $kind in all | deb) for system in "$@"; do check_deb "$system"; done ;; esac
case $kind in all | container) check_container ;; esac
