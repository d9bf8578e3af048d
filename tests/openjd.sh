#!/usr/bin/env bash
# Whether the reference tool of Open Job Description takes and runs the template of `wold plan --openjd`:
#
#     tests/openjd.sh
#
# Checks the template of a small film, runs all its steps, and compares the folder, byte for byte,
# with that of `wold render`. Needs what tests/run.sh builds; takes half a minute.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

wold=$here/build/wold
tool=$here/build-openjd/bin/openjd
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The name is one that a shell and the template's format strings could take for more than a name.
write_scene() {
  cat >"$folder/it's \$HOME.toml" <<'EOF'
name = "tiny"
seed = 3
terrain = { size = 4, samples = 33 }
grass = { blades = 20, variants = 2, levels = [30], key_frames = [0.0, 1.0] }
ageing = { frames = [0.1, 0.5] }
camera = { eye = [2, 0.5], target = [2, 3] }
render = { renderer = "povray", size = [32, 18], samples = 1 }
EOF
}

# All files but the records of what took how long.
hashes() {
  (cd "$1" && find . -type f -not -path './tasks/*' -not -path './logs/*' -not -name manifest.json \
    -exec sha256sum {} + | sort -k 2)
}

install python3 python3-venv
python3 -m venv "$here/build-openjd"
"$here/build-openjd/bin/pip" install -q --disable-pip-version-check 'openjd-cli==0.8.*'
write_scene
cd "$folder"
"$wold" render ./*.toml --quiet --out rendered --passes depth,species --keep scenes >/dev/null
"$wold" plan ./*.toml --openjd --out farm --passes depth,species --keep scenes >template.json
say "Open Job Description"
"$tool" check template.json
PATH=$here/build:$PATH "$tool" run template.json >run.log 2>&1 || {
  cat run.log
  exit 1
}
diff <(hashes rendered) <(hashes farm)
[ "$(find farm/frames -name '*.png' | wc -l)" = 2 ]
[ "$(find farm/passes -name '*.exr' | wc -l)" = 2 ]
[ "$(find farm/texels -name '*.vdb' | wc -l)" = 0 ] # --keep scenes
echo "The job's files are those of wold render."
