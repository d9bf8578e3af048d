#!/usr/bin/env bash
# Feeds Wold's readers with libFuzzer under address and undefined-behaviour sanitizers, each for so
# many seconds:
#
#     tests/fuzz/run.sh [SECONDS [TARGET...]]          e.g. tests/fuzz/run.sh 300 scene df3
#
# Stops at the first input that crashes, hangs or takes too much memory, and says where it is. Put
# such inputs, mended, into tests/fuzz/corpus/TARGET.
set -euo pipefail
source "$(dirname "$0")/../../examples/setup.sh"

seconds=${1:-300}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(scene df3 weather_table daily_weather elevation
  records pictures vdb arguments)

install "${build_packages[@]}" clang libgtest-dev libgmock-dev libbenchmark-dev
folder=$here/build-fuzz
export LSAN_OPTIONS=suppressions=$here/tests/lsan.suppressions:print_suppressions=0
cmake -S "$here" --preset fuzz
cmake --build "$folder" --target "${targets[@]/#/fuzz_}"
for target in "${targets[@]}"; do
  say "Feeding $target for $seconds s"
  mkdir -p "$folder/corpus/$target"
  options=(-max_total_time="$seconds" -timeout=10 -rss_limit_mb=3000 -print_final_stats=1
    -artifact_prefix="$folder/$target-")
  [ "$target" != scene ] || options+=(-dict="$here/tests/fuzz/scene.dict")
  # OpenVDB keeps what it had read of a damaged file: in a process of its own now and then.
  [ "$target" != vdb ] || options+=(-fork=1)
  "$folder/fuzz_$target" "${options[@]}" "$folder/corpus/$target" "$here/tests/fuzz/corpus/$target"
done
