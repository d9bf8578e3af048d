# shellcheck shell=bash disable=SC2034
# Sourced by examples/run.sh and tests/run.sh: installs what is missing and builds. Bare Debian 12 or
# 13 with git is enough; safe to run again, and quick then.

here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# What the program is built with, and the renderers.
build_packages=(g++ cmake ninja-build libopenvdb-dev libopenimageio-dev libtbb-dev libglm-dev
  libfmt-dev libcli11-dev nlohmann-json3-dev libtomlplusplus-dev libboost-dev
  libboost-iostreams-dev libgdal-dev libzip-dev libxxhash-dev fonts-dejavu-core)
render_packages=(blender povray ffmpeg)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev libxml2-utils locales slurmctld slurmd
  slurm-client munge python3 procps strace chromium chromium-driver man-db zsh fish)

say() { printf '\n== %s\n' "$*" >&2; }

# install PACKAGE...: those that are not there yet, as root or through sudo.
install() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "error: please install, as root: apt-get install ${missing[*]}" >&2
      exit 4
    }
    root=(sudo)
  fi
  say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  "${root[@]}" apt-get update -q >&2
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${missing[@]}" >&2
}

# build [CMAKE OPTION...] -- TARGET...: configures and builds into build/.
build() {
  local options=()
  while [ "${1:---}" != -- ]; do
    options+=("$1")
    shift
  done
  shift
  say "Building"
  (cd "$here" && cmake --preset release "${options[@]}" >/dev/null && cmake --build --preset release --target "$@") >&2
}
