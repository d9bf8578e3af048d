#!/usr/bin/env bash
# Runs a command in the root folder of another system, which has this checkout and /tmp at their
# paths. The mounts that this takes are gone when the command has ended:
#
#     tests/in_root.sh [--bare] ROOT COMMAND...       as root
#
# --bare: it has neither, and sees nothing of this machine but its processes and devices.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
folders=(/proc /sys /dev)
given=("$@")
if [ "$1" = --bare ]; then shift; else folders+=(/tmp "$here"); fi
root=$1
if [ "${WOLD_MOUNTED_ROOT:-}" != "$root" ]; then
  WOLD_MOUNTED_ROOT=$root exec unshare --mount "$0" "${given[@]}"
fi
for folder in "${folders[@]}"; do
  mkdir -p "$root$folder"
  mount --rbind "$folder" "$root$folder"
done
current=$PWD
[ -d "$root$current" ] || current=/
exec chroot "$root" env -C "$current" HOME=/root LC_ALL=C.UTF-8 \
  PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${@:2}"
