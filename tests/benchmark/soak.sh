#!/usr/bin/env bash
# Kills wold or its renderer with SIGKILL at random moments of a short film, runs the same command
# again, and so on; each film that gets done, and the last one, is compared byte for byte with that
# of an undisturbed run. Exit code 1 when a file is wrong, missing or left over.
#
#     tests/benchmark/soak.sh [KILLS [SEED [RENDERER]]]       default: 200 1 povray
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
wold=$here/build/wold
kills=${1:-200}
RANDOM=${2:-1}
work=$(mktemp -d /tmp/wold_soak_XXXXXX)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >film.toml <<SCENE
name = "film"
terrain = { size = 6, samples = 33 }
grass = { blades = 40, variants = 1, levels = [30], key_frames = [0.0, 1.0] }
ageing = { frames = [0.0, 0.3, 0.6, 1.0] }
camera = { eye = [3, 0.5], target = [3, 4] }
render = { renderer = "${3:-povray}", size = [32, 18], samples = 1 }
SCENE

now_ms() { date +%s%3N; }
# start OUT: begins a run in the background; its number is $run. Messages stay out of the way.
start() {
  "$wold" render film.toml --quiet --out "$1" >/dev/null 2>>messages &
  run=$!
}
hashes() {
  (cd "$1" && find . -type f ! -path './logs/*' ! -path './tasks/*' ! -name manifest.json \
    -exec sha256sum {} + | sort -k 2)
}
renderer() { cat /proc/"$run"/task/*/children 2>/dev/null | awk '{print $1; exit}'; }
# Not when it has ended and only waits to be asked how.
is_running() { [ "$(awk '/^State/ {print $2}' /proc/"$run"/status)" != Z ]; }
pause() { sleep "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))"; }
# Compares a film that is done; everything that differs, or should not be there, counts.
check() {
  wrong=$((wrong + $(diff <(hashes undisturbed) <(hashes out) | grep -c '^[<>]' || true)))
  left=$((left + $(find out \( -name '.*' -o -path out/snow -o -name lock \) | wc -l)))
  films=$((films + 1))
  rm -rf out
}

begin=$(now_ms)
start undisturbed
wait "$run" || { cat messages >&2; exit 3; }
whole=$(($(now_ms) - begin))
of_wold=0 of_renderers=0 runs=0 films=0 wrong=0 left=0 failed=0
begin=$(now_ms)
while [ $((of_wold + of_renderers)) -lt "$kills" ]; do
  start out
  runs=$((runs + 1))
  victim=$run
  if [ $((RANDOM % 3)) = 0 ]; then
    until victim=$(renderer) && [ -n "$victim" ] || ! is_running; do sleep 0.01; done
    pause $((RANDOM % (whole / 5)))
  else
    pause $(((RANDOM * 32768 + RANDOM) % whole))
  fi
  [ -z "$victim" ] || kill -KILL "$victim" 2>/dev/null || true
  code=0
  wait "$run" 2>/dev/null || code=$?
  case $code in
    0) check ;;
    137) of_wold=$((of_wold + 1)) ;;
    3) of_renderers=$((of_renderers + 1)) ;;
    *) failed=$((failed + 1)) ;;
  esac
done
start out
wait "$run"
check

echo '| kills | of wold | of the renderer | runs | films done | wrong or missing files | leftovers | other failures | time |'
echo '|---|---|---|---|---|---|---|---|---|'
echo "| $((of_wold + of_renderers)) | $of_wold | $of_renderers | $((runs + 1)) | $films | $wrong | $left | $failed |" \
  "$((($(now_ms) - begin) / 1000)) s |"
[ $((wrong + left + failed)) = 0 ] || { tail messages >&2; exit 1; }
