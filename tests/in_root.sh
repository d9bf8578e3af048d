#!/usr/bin/env bash
# Runs a command in the root folder of another system, which has this checkout and /tmp at their
# paths. The mounts that this takes are gone when the command has ended:
#
#     tests/in_root.sh ROOT COMMAND...       as root
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
root=$1
if [ "${WOLD_MOUNTED_ROOT:-}" != "$root" ]; then
  WOLD_MOUNTED_ROOT=$root exec unshare --mount "$0" "$@"
fi
for folder in /proc /sys /dev /tmp "$here"; do
  mkdir -p "$root$folder"
  mount --rbind "$folder" "$root$folder"
done
current=$PWD
[ -d "$root$current" ] || current=/
exec chroot "$root" env -C "$current" HOME=/root LC_ALL=C.UTF-8 \
  PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${@:2}"
