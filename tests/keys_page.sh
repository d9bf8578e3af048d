#!/usr/bin/env bash
# Prints docs/keys.md, the keys of a scene as the registry has them:
#
#     tests/keys_page.sh [PROGRAM] >docs/keys.md         build/wold without it
#     tests/keys_page.sh --check [PROGRAM]               exit code 1 when docs/keys.md is another
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
check=
if [ "${1:-}" = --check ]; then
  check=yes
  shift
fi
wold=${1:-$here/build/wold}

page() {
  cat <<'MARKDOWN'
# Keys of a scene

A scene is a TOML file. Every key has a default, so a scene states only what it changes.
`wold check SCENE` prints a scene with all of its keys; `wold new NAME` writes a starter scene.
`--set KEY=VALUE` reaches every key from the command line.

"The paper" is [TVT] in grass and ageing, [Wang2010] in clouds and their events, and [He2007] in
snowfall and snow cover; see [REFERENCES.md](REFERENCES.md).

This page is made by `tests/keys_page.sh` from the registry (`gen/scene/registry.h`).

MARKDOWN
  "$wold" --help-keys
}

if [ -z "$check" ]; then
  page
elif ! diff "$here/docs/keys.md" <(page); then
  echo "docs/keys.md is not what the registry has: tests/keys_page.sh >docs/keys.md" >&2
  exit 1
fi
