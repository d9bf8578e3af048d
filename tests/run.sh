#!/usr/bin/env bash
# Installs what is missing, builds and runs every test:
#
#     ./tests/run.sh [CTEST OPTION...]          e.g. ./tests/run.sh -R Texel
#
# Warnings are errors here. Ends with the number of tests passed and failed.
#
#     ./tests/run.sh --update-golden ...        makes golden pictures anew, see update_golden.sh
set -euo pipefail
if [ "${1:-}" = --update-golden ]; then
  exec "$(dirname "$0")/update_golden.sh" "${@:2}"
fi
source "$(dirname "$0")/../examples/setup.sh"

install "${build_packages[@]}" "${render_packages[@]}" "${test_packages[@]}"
build -DWOLD_TESTS=ON -DWOLD_WERROR=ON -- all
say "Testing"
cd "$here"
ctest --preset release --parallel "$(nproc)" "$@"
