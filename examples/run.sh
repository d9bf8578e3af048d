#!/usr/bin/env bash
# From a fresh clone on a bare Debian 12 or 13 to pictures, in one command:
#
#     ./examples/run.sh [SCENE [OPTION...]]     default: examples/hillside.toml
#
# Installs what is missing (asks for sudo when you are not root), builds, renders the scene with
# Blender and POV-Ray and prints where the pictures are. Options are those of `wold render`.
set -euo pipefail
source "$(dirname "$0")/setup.sh"

install "${build_packages[@]}" "${render_packages[@]}"
build -DWOLD_TESTS=OFF -DWOLD_WERROR=OFF -- wold
scene=${1:-$here/examples/hillside.toml}
[ $# -gt 0 ] && shift
say "Rendering $scene"
"$here/build/wold" render "$scene" "$@"
