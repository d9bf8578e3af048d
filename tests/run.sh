#!/usr/bin/env bash
# Installs what is missing, builds and runs every test:
#
#     ./tests/run.sh [CTEST OPTION...]          e.g. ./tests/run.sh -R Texel
#
# Warnings are errors here. Ends with the number of tests passed and failed.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

install "${build_packages[@]}" "${render_packages[@]}" libgtest-dev libgmock-dev libbenchmark-dev \
  libxml2-utils locales slurmctld slurmd slurm-client munge python3 procps
build -DWOLD_TESTS=ON -DWOLD_WERROR=ON -- all
say "Testing"
cd "$here"
ctest --preset release --parallel "$(nproc)" "$@"
