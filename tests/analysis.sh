#!/usr/bin/env bash
# Looks for what tests alone do not show; before a release, all of it:
#
#     tests/analysis.sh asan [CTEST OPTION...]        tests with address and undefined-behaviour
#                                                     sanitizers
#     tests/analysis.sh asan-units [PART PARTS]       those of all libraries that start neither a
#                                                     renderer nor wold; of every PARTS libraries
#                                                     one, from that of number PART (0 is the
#                                                     first) on, as .ci/run does
#     tests/analysis.sh units                         all of all libraries, and the table of hostile
#                                                     files, in few processes, as .ci/run does
#     tests/analysis.sh but-units [REGEX]             what that leaves: the program, golden pictures;
#                                                     without the tests whose names match
#     tests/analysis.sh tsan [CTEST OPTION...]        with the thread sanitizer
#     tests/analysis.sh coverage [CTEST OPTION...]    which lines of gen/ tests run: 90 % at least
#     tests/analysis.sh layers                        the libraries as shared ones, each linked to
#                                                     what CMake says alone
#     tests/analysis.sh cppcheck
#     tests/analysis.sh python                        ruff and mypy, with pyproject.toml's settings
#     tests/analysis.sh spelling                      codespell, with pyproject.toml's settings
#     tests/analysis.sh tidy [FILE PATTERN...]        clang-tidy, with the checks of .clang-tidy
#
# All but layers, units, but-units and cppcheck take a folder build-* of their own. asan, tsan,
# coverage and tidy take more time than .ci/run has.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

# test_with PRESET [CTEST OPTION...]: builds all and tests.
test_with() {
  local preset=$1
  install "${build_packages[@]}" "${render_packages[@]}" "${test_packages[@]}"
  say "Building with $preset"
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" >&2
  say "Testing with $preset"
  ctest --preset "$preset" --parallel "$(nproc)" "${@:2}"
}

# Patterns of tests that asan-units leaves out, with siblings that run the same code: those that start
# a renderer or wold, and those that take longest.
units_left_out=(
  BlenderRender.* BlenderAddOn.* BlenderDifferences.* BlenderStranger.* Includes.* OwnScene.*
  Picture.* RealPovray.*
  LargeTerrain.* SiteOfFrame.* SnowfallModel.* Growth.Covers* Assemble.* GroundDetails.Agree*
  GroundDetails.ShowPatches* GroundReflectance.GrassStands* LitGround.HasAHotSpot*
  Rebuild.BigTujunga* Rebuild.FrontRange* CloudBoxes.HaveTheLayers* CloudLayerView.Glows*
  CloudySkies.Shine* CloudySkies.HaveBases* Exposure.Changes* TracedSky.* LandView.Sees*
  DiffuseLight.OfDeepSlabs* DiffuseLight.FallsAlong* Light.OfAHeapByItsDepths*
  MeanTransmittance.IsThatOfPlaces* BentBlades.AreNeither* ShotsInPlace.ShareTheLights*
  FlakeLook.NearFlakesTurn* Gusts.HaveDavenportsCoherenceAcross* CanopyMotion.GustsTravel*
  CanopyMotion.Honami* AirFlow.HasTheIntensity* WavingGrass.MovesFrom* WavingGrass.StandsStill*
  Maps.HaveSnow* Maps.AreThose* Maps.HaveTheNorth* SeasonSnow.LiesOrHasLeft* Passes.GrassHides*
  SnowyGround.Is* SnowyGround.LiesSmooth* SnowyGround.DeepSnow* SnowyGround.ThePapers*
  Samples.OneSteady* SurroundingsTest.AreThose* LandShadowTest.APlane* LandShadowTest.Follows*
  TimeVaryingTexel.SameBytes*)

# Those with a test program each, but for the command line: its tests start the program often.
libraries=(core scene weather snowpack phenology light terrain grass cloud snow wind landscape place
  sky meadow ground expectation passes shutter maps film povray blender mitsuba usd preview report
  compare render work console)

# The tests of tests/hostile, of the command line.
hostile=Table/Hostile.

# run_units FOLDER FILTER LIBRARY...: runs the libraries' test programs, each as often as there are
# processors, with a part of its tests: a process of its own for each test takes longer to start than
# most tests take. Says what fails; exit code 123 if any does.
run_units() {
  local folder=$1 filter=$2 at_once library process
  at_once=$(nproc)
  for library in "${@:3}"; do
    for ((process = 0; process < at_once; ++process)); do
      echo "GTEST_SHARD_INDEX=$process timeout 1200 $folder/test_$library"
    done
  done | xargs -P "$at_once" -L 1 env GTEST_BRIEF=1 "GTEST_FILTER=$filter" \
    "GTEST_TOTAL_SHARDS=$at_once" "UBSAN_OPTIONS=halt_on_error=1 print_stacktrace=1" \
    "LSAN_OPTIONS=suppressions=$here/tests/lsan.suppressions"
}

# test_units_with_asan PART PARTS: with what the readers of strangers' files are fuzzed from.
test_units_with_asan() {
  local corpora=(scene df3 weather_table daily_weather elevation pictures vdb arguments records)
  local chosen=() number
  if (($1 < 0 || $1 >= $2 || $1 >= ${#libraries[@]})); then
    echo "error: PART is $1: from 0 to PARTS - 1 is expected, and less than ${#libraries[@]}" >&2
    exit 2
  fi
  for ((number = $1; number < ${#libraries[@]}; number += $2)); do
    chosen+=("${libraries[number]}")
  done
  install "${build_packages[@]}" "${test_packages[@]}"
  say "Building libraries with asan"
  cmake --preset asan -DWOLD_JOIN_TESTS=ON >/dev/null
  cmake --build --preset asan --target "${chosen[@]/#/test_}" "${corpora[@]/#/fuzz_}" >&2
  say "Testing libraries with asan"
  run_units build-asan "-$(IFS=: && echo "${units_left_out[*]}")" "${chosen[@]}"
  ctest --preset asan --parallel "$(nproc)" --tests-regex '^Corpus'
}

# In the build that tests/run.sh makes.
test_units() {
  install "${build_packages[@]}" "${render_packages[@]}" "${test_packages[@]}"
  build -DWOLD_TESTS=ON -DWOLD_WERROR=ON -DWOLD_JOIN_TESTS=ON -- all
  say "Testing libraries"
  run_units build '*' "${libraries[@]}"
  run_units build "$hostile*" cli
}

test_but_units() {
  local labels
  labels=$(IFS='|' && echo "${libraries[*]}")
  tests/run.sh --label-exclude "^($labels)\$" --exclude-regex "^$hostile${1:+|$1}"
}

# On one processor TBB has one thread, and nothing would be found.
check_threads() {
  [ "$(nproc)" -gt 1 ] || {
    echo "error: the thread sanitizer needs two processors" >&2
    exit 4
  }
  test_with tsan "$@"
}

coverage() {
  install gcovr
  find build-coverage -name '*.gcda' -delete 2>/dev/null || true
  test_with coverage "$@"
  gcovr --root . --filter gen/ --object-directory build-coverage --exclude-throw-branches \
    --sort-uncovered --fail-under-line 90
}

check_with_cppcheck() {
  install "${build_packages[@]}" "${test_packages[@]}" cppcheck
  cmake --preset release >/dev/null
  cppcheck --project=build/compile_commands.json --file-filter='gen/*' --std=c++20 --quiet \
    --enable=warning,performance,portability --suppressions-list=tests/cppcheck.suppressions \
    --error-exitcode=1 -j "$(nproc)"
}

# Other versions of ruff format differently, hence the fixed ones. --clear: another Python may be
# here than the last time.
check_python() {
  local programs=build-python/bin
  install python3 python3-venv
  python3 -m venv --clear build-python
  "$programs/pip" install -q --disable-pip-version-check 'ruff==0.17.*' 'mypy==2.*'
  "$programs/ruff" check templates tests examples
  "$programs/ruff" format --check templates tests examples
  "$programs/mypy"
}

# Other versions know other words, hence the fixed one.
check_spelling() {
  install python3 python3-venv
  python3 -m venv --clear build-spelling
  build-spelling/bin/pip install -q --disable-pip-version-check 'codespell==2.4.*' 'tomli==2.*'
  git ls-files -z | xargs -0 build-spelling/bin/codespell
}

# The objects are those of the build that tests/run.sh makes.
check_layers() {
  install "${build_packages[@]}" "${test_packages[@]}"
  cmake --preset release >/dev/null
  cmake --build --preset release --target shared_layers >&2
}

# With commands that have no precompiled headers and no options of GCC's own. The settings are read
# once before: of a file that it cannot read, clang-tidy says so and falls back to its own.
check_with_tidy() {
  install "${build_packages[@]}" "${test_packages[@]}" clang clang-tidy
  cmake -S . -B build-clang -G Ninja -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
  clang-tidy --config="$(<.clang-tidy)" --list-checks >/dev/null
  run-clang-tidy -quiet -p build-clang -j "$(nproc)" "${@:-/gen/.*\\.cpp}"
}

cd "$here"
case ${1:-} in
  asan) test_with "$@" ;;
  tsan) check_threads "${@:2}" ;;
  asan-units) test_units_with_asan "${2:-0}" "${3:-1}" ;;
  units) test_units ;;
  but-units) test_but_units "${2:-}" ;;
  coverage) coverage "${@:2}" ;;
  layers) check_layers ;;
  cppcheck) check_with_cppcheck ;;
  python) check_python ;;
  spelling) check_spelling ;;
  tidy) check_with_tidy "${@:2}" ;;
  *)
    sed -n '2,/^set/s/^# \?//p' "$0" >&2
    exit 2
    ;;
esac
