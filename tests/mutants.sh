#!/usr/bin/env bash
# Whether the tests would see a fault: puts small ones into a copy of what is here, one at a time,
# builds it and runs the tests of the room, the folder of gen/, that has the fault:
#
#     tests/mutants.sh [ROOM|ROOM.NAME]...       e.g. tests/mutants.sh light snow.flakes_never_sway
#     tests/mutants.sh --every K [ROOM|ROOM.NAME]...   one of each K, over all of their rooms
#     tests/mutants.sh --list [ROOM|ROOM.NAME]...
#
# tests/mutants/ROOM.toml has the faults; the test MutantPlaces holds that each has its place in the
# code. Prints a table of what was caught, by which test, and what survived; exit code 1 when less
# than 95 % are caught, or when a fault could not be tried: its place is no longer in the code, or
# it does not compile. Takes three hours for all; MUTANT_JOBS says how many files are compiled at
# once, 2 when it says nothing. The copy is a work tree of git in a folder for temporary files; it
# is brought to what is here at each start, whatever a run that was ended left in it, and its build
# is kept for the next one.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

copy=${TMPDIR:-/tmp}/wold-mutants-$(id -u)

# What is committed, and on top of it what is changed in tracked files.
state_here() {
  local changed
  changed=$(git -C "$here" stash create)
  echo "${changed:-HEAD}"
}

# A copy that another clone has made, or whose folder is gone, is made anew.
is_copy_of_this() {
  [ "$(git -C "$copy/tree" rev-parse --path-format=absolute --git-common-dir 2>/dev/null)" = \
    "$(git -C "$here" rev-parse --path-format=absolute --git-common-dir)" ]
}

refresh_copy() {
  local state
  state=$(git -C "$here" rev-parse "$(state_here)")
  if ! is_copy_of_this; then
    rm -rf "$copy"
    mkdir -p "$copy"
    git -C "$here" worktree prune
    git -C "$here" worktree add --quiet --force --detach "$copy/tree" "$state"
  fi
  git -C "$copy/tree" checkout --quiet --force --detach "$state"
  git -C "$copy/tree" clean --quiet -fdx
}

# Without debugging information and little optimised, which is the quickest to build.
configure_copy() {
  cmake -S "$copy/tree" -B "$copy/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1 \
    -DWOLD_TESTS=ON >/dev/null
}

install "${build_packages[@]}" "${test_packages[@]}" git
try=(python3 -B "$here/tests/mutants/run.py" --copy "$copy" --jobs "${MUTANT_JOBS:-2}" "$@")
"${try[@]}" --list >/dev/null # are they known?
if [[ " $* " != *" --list "* ]]; then
  say "Copying to $copy"
  refresh_copy
  configure_copy
fi
exec "${try[@]}"
