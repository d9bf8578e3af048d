#!/usr/bin/env bash
# The tests that need Mitsuba 3, a Python package that nothing else needs:
#
#     tests/mitsuba.sh
#
# Needs what tests/run.sh builds; takes half a minute. Fails when a test is skipped.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

folder=$here/build-mitsuba

install python3 python3-venv
python3 -m venv "$folder"
"$folder/bin/pip" install -q --disable-pip-version-check 'mitsuba==3.9.*' numpy
say "Mitsuba"
WOLD_MITSUBA=$folder/bin/python "$here/build/test_mitsuba" --gtest_filter='MitsubaLight.*' |
  tee "$folder/log.txt"
! grep -q SKIPPED "$folder/log.txt"
