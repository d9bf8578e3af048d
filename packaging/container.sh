# shellcheck shell=bash disable=SC2154  # `here` and `packages` are set by packaging/build.sh
# Sourced by packaging/build.sh: an image of a container, by buildah. Needs no root where users may have
# name spaces of their own. What a machine allows is said by buildah's own variables, such as
# BUILDAH_ISOLATION=chroot and STORAGE_DRIVER=vfs.

# codename: of this Debian, for which the package is.
codename() {
  local VERSION_CODENAME
  source /etc/os-release
  echo "$VERSION_CODENAME"
}

make_container() {
  local context version
  install buildah mmdebstrap
  version=$("$here/build/wold" --version | sed -n 's/^wold //p')
  context=$(mktemp -d)
  cp "$here/packaging/container/Containerfile" "$packages"/wold_*.deb "$context"
  say "Making the container's Debian"
  mmdebstrap --quiet --variant=apt "$(codename)" "$context/base.tar" >&2
  say "Making the container"
  buildah build --layers=false --tag localhost/wold --tag "localhost/wold:$version" "$context" >&2
  rm -rf "$context"
  echo localhost/wold
}
