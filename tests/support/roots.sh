# shellcheck shell=bash disable=SC2154  # `here` is set by examples/setup.sh
# Sourced by tests/systems.sh, tests/packages.sh and tests/blender_versions.sh, after examples/setup.sh:
# other Debian systems as folders, and Blender as a Python package. Both are kept for the next time.

cache=${XDG_CACHE_HOME:-$HOME/.cache}/wold/systems

# What the package bpy needs: an environment, and libraries that it does not bring along.
bpy_packages=(python3-venv libegl1 libgl1 libice6 libsm6 libxext6 libxfixes3 libxi6 libxkbcommon0
  libxrender1 libxxf86vm1)
declare -A python_of_bpy=([4.5]=3.11 [5.2]=3.13)
declare -A system_of_python=([3.11]=bookworm [3.13]=trixie)

in_root() { "$here/tests/in_root.sh" "$cache/$1" "${@:2}"; }

# The registries are reached as from this machine: names, certificates, proxies, pip's settings.
copy_settings() {
  local root=$1 file
  for file in /etc/resolv.conf /etc/pip.conf /etc/ssl/certs/ca-certificates.crt \
    /usr/local/share/ca-certificates; do
    [ ! -e "$file" ] || cp -rL --parents "$file" "$root"
  done
  apt-config dump | grep -E '^Acquire::(https?|Check-)' >"$root/etc/apt/apt.conf.d/90machine" || true
}

# make_root SYSTEM [NAME]: that Debian as debootstrap lays it down, and no services in it.
make_root() {
  local root=$cache/${2:-$1}
  [ ! -d "$root" ] || return 0
  [ "$(id -u)" -eq 0 ] || {
    echo "error: a root folder of Debian $1 can be made by root only" >&2
    exit 4
  }
  install debootstrap
  say "Making a root folder of Debian $1"
  mkdir -p "$cache"
  rm -rf "$root.new"
  debootstrap --variant=minbase "$1" "$root.new" >&2
  copy_settings "$root.new"
  printf '#!/bin/sh\nexit 101\n' >"$root.new/usr/sbin/policy-rc.d"
  chmod +x "$root.new/usr/sbin/policy-rc.d"
  mv "$root.new" "$root"
}

# make_fresh_root SYSTEM NAME: a new one, in which nothing has been installed.
make_fresh_root() {
  make_root "$1" "$1.bare"
  rm -rf "${cache:?}/$2"
  cp -a "$cache/$1.bare" "$cache/$2"
}

# install_in SYSTEM PACKAGE...
install_in() {
  in_root "$1" apt-get update -q >&2
  in_root "$1" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${@:2}" >&2
}

# python_here VERSION: this machine's Python 3.x, when it has one.
python_here() {
  local python
  for python in "python$1" "${PYENV_ROOT:-$HOME/.pyenv}/versions/$1".*/bin/python; do
    ! "$python" -c 'import ensurepip, venv' 2>/dev/null || {
      echo "$python"
      return
    }
  done
  return 1
}

# has_bpy PYTHON...: whether that command is a Python with the package.
has_bpy() { "$@" -c 'import bpy' >/dev/null 2>&1; }

# set_up_bpy VERSION PYTHON FOLDER [PREFIX...]: the package in an environment of its own, by
# commands that begin with PREFIX.
set_up_bpy() {
  say "Installing bpy $1 with $2"
  "${@:4}" "$2" -m venv "$3" >&2
  "${@:4}" "$3/bin/pip" install -q "bpy==$1.*" >&2
}

# bpy_in SYSTEM VERSION: the Python in a system's root that has the package, installed when missing.
bpy_in() {
  local folder=/opt/bpy-$2
  has_bpy in_root "$1" "$folder/bin/python" || {
    install_in "$1" "${bpy_packages[@]}"
    set_up_bpy "$2" python3 "$folder" in_root "$1"
  }
  echo "$folder/bin/python"
}

# bpy_here VERSION PYTHON: the same on this machine.
bpy_here() {
  local folder=$cache/bpy-$1
  has_bpy "$folder/bin/python" || set_up_bpy "$1" "$2" "$folder"
  echo "$folder/bin/python"
}

# bpy_program VERSION: a program that is a Python with that version, of this machine or in the root of
# a Debian with the Python it needs.
bpy_program() {
  local needed=${python_of_bpy[$1]} program=$cache/bpy-$1-in-root python system
  install "${bpy_packages[@]}"
  if python=$(python_here "$needed"); then
    bpy_here "$1" "$python"
    return
  fi
  system=${system_of_python[$needed]}
  make_root "$system"
  python=$(bpy_in "$system" "$1")
  printf '#!/bin/sh\nexec "%s" "%s" "%s" "$@"\n' "$here/tests/in_root.sh" "$cache/$system" \
    "$python" >"$program"
  chmod +x "$program"
  echo "$program"
}
