#!/usr/bin/env bash
# Makes the golden pictures anew:
#
#     ./tests/run.sh --update-golden [--yes] [SCENE...]          e.g. --update-golden 'snow_*' fur
#
# Renders those of all scenes, or of the named ones, shows what looks different beside what was
# there, and replaces it when told to: by an answer, or by --yes. Pictures within the limits of the
# tests stay as they are.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

golden=$here/tests/golden
made=$here/build/golden

# filter SCENE...: the tests that render them.
filter() {
  local scene
  for scene in "$@"; do
    printf '*/Examples.*/%s:' "$scene"
    # shellcheck disable=SC2053 # a pattern
    [[ hillside != $scene ]] || printf 'GoldenHillside.*:'
  done
}

# render FILTER: leaves each picture that differs, and no other, in $made/got.
render() {
  rm -rf "$made"
  mkdir -p "$made/got" "$made/want"
  "$here/build/test_cli" --gtest_filter="$1" &>"$made/log.txt" || true
  if [ "$(grep -c ': Failure' "$made/log.txt")" -ne "$(grep -c 'does not look like' "$made/log.txt")" ] ||
    ! grep -q 'OK \]\|FAILED' "$made/log.txt"; then
    echo "error: not every picture could be made, see $made/log.txt" >&2
    exit 3
  fi
}

# show: copies what there is to be replaced, and compares.
show() {
  (cd "$made/got" && find . -name '*.png') | while read -r picture; do
    mkdir -p "$(dirname "$made/want/$picture")"
    [ ! -e "$golden/$picture" ] || cp "$golden/$picture" "$made/want/$picture"
  done
  "$here/build/wold" compare "$made/got" "$made/want" --report "$made/changes" >/dev/null || true
}

# agreed: whether to replace.
agreed() {
  local answer=
  [ -t 0 ] && read -r -p "Replace these pictures in tests/golden? [y/N] " answer
  [[ $answer == [yY]* ]]
}

yes=false
[ "${1:-}" != --yes ] || { yes=true && shift; }
[ $# -gt 0 ] || set -- '*'

install "${build_packages[@]}" "${render_packages[@]}" "${test_packages[@]}"
build -DWOLD_TESTS=ON -- wold test_cli
say "Rendering"
render "$(filter "$@")"
if [ -z "$(find "$made/got" -name '*.png')" ]; then
  say "Every picture looks as it did"
  exit
fi
say "Pictures that look different"
show
if ! $yes && ! agreed; then
  say "Nothing was replaced"
  exit 1
fi
cp -r "$made/got/." "$golden"
say "Replaced $(find "$made/got" -name '*.png' | wc -l) pictures in tests/golden"
