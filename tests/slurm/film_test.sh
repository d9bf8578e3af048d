#!/usr/bin/env bash
# A film of two shots on a real Slurm of two nodes, of which one is lost on the way: the same bytes as
# on this machine alone. film_test.sh WOLD; exit code 77: something is not installed.
set -euo pipefail
wold=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/cluster.sh"
export PATH=$PATH:/usr/sbin:/sbin
for program in munged slurmctld slurmd sbatch povray python3; do
  command -v $program >/dev/null || { echo "skipped: $program is not installed"; exit 77; }
done

folder=$(mktemp -d /tmp/wold_slurm_XXXXXX)
trap 'cluster_down; rm -rf "$folder"' EXIT
cd "$folder"
cat >film.toml <<'SCENE'
name = "film"
terrain = { size = 6, samples = 49 }
grass = { blades = 40, variants = 2, levels = [62, 30], key_frames = [0.0, 0.5, 1.0] }
camera = { eye = [3, 0.5], target = [3, 4] }
render = { renderer = "povray", size = [64, 36], samples = 1 }
film = { frames_per_second = 3 }
[[shots]]
seconds = 1
weathering = [0.0, 0.4]
eye_end = [4, 1, 2]
[[shots]]
seconds = 1
start = 100
weathering = [0.6, 1.0]
eye = [2, 1]
SCENE

# Pictures take two seconds longer and say where they are made, so that a node can be lost in the
# middle, and the fifth fails once.
cat >slow_wold <<SCRIPT
#!/bin/sh
if [ "\$3" = povray ]; then
  touch "$folder/renders_on_\$SLURMD_NODENAME"
  sleep 2
  [ "\$4" != 5 ] || ! mkdir "$folder/failed_once" 2>/dev/null || exit 3
fi
exec '$wold' "\$@"
SCRIPT
chmod +x slow_wold

hashes() { (cd "$1" && find . -type f ! -path './logs/*' ! -path './tasks/*' ! -name manifest.json -exec sha256sum {} + | sort -k 2); }
is_over() { local jobs && jobs=$(squeue -h) && [ -z "$jobs" ]; }
fail() {
  echo "error: $*" >&2
  scontrol show jobs | grep -E 'JobId|JobState|Reason' >&2 || true
  tail farm/logs/slurm/* >&2
  exit 1
}

"$wold" render film.toml --quiet --out local --passes depth --keep scenes >/dev/null
cluster_up "$folder/cluster" 2
"$here/../../templates/slurm/submit.py" film.toml --out farm --passes depth --keep scenes --wold "$folder/slow_wold"
wait_until 120 test -e renders_on_n2
lose_node n2
wait_until 300 is_over

[ "$(scontrol show jobs | grep -c 'Restarts=[1-9]')" -ge 2 ] || fail "two jobs have to be started again"
diff <(hashes local) <(hashes farm) || fail "the films differ"
[ "$(find farm/passes -name '*.exr' | wc -l)" = 6 ] || fail "there are no passes of every frame"
[ "$(find farm/texels -name '*.vdb' | wc -l)" = 0 ] || fail "texels stay with --keep scenes"
[ -e farm/manifest.json ] || fail "no manifest.json: the last job did not run"
echo "the film of two nodes, one of them lost, is the same: $(hashes farm | wc -l) files"
