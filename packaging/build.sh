#!/usr/bin/env bash
# Makes a package of this checkout, for the system that this runs on, and prints its name:
#
#     packaging/build.sh deb           build/packages/wold_VERSION_amd64.deb
#     packaging/build.sh tarball       build/packages/wold-VERSION-linux-x86_64.tar.gz
#     packaging/build.sh container     the image localhost/wold, in the store of buildah
#
# Installs what is missing (asks for sudo when you are not root) and builds. Whoever builds a package
# for others names himself by DEBFULLNAME and DEBEMAIL, as for other packages of Debian. The same
# commit gives the same packages, byte for byte.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"
# shellcheck source=tarball.sh
source "$here/packaging/tarball.sh"
# shellcheck source=container.sh
source "$here/packaging/container.sh"

packages=$here/build/packages

# git_says COMMAND...: nothing outside git.
git_says() { git -C "$here" "$@" 2>/dev/null || true; }

# maintainer: "Name <address>" of who builds, or else of who made the commit.
maintainer() {
  local address=${DEBEMAIL:-$(git_says log -1 --format=%ae)}
  local name=${DEBFULLNAME:-$(git_says log -1 --format=%an)}
  echo "${name:-$(id -un)} <${address:-$(id -un)@$(hostname -f)}>"
}

# homepage: where the sources are from, when that is a page.
homepage() { git_says remote get-url origin | grep -E '^https?://[^@]*$' || true; }

# debian_release: "1~deb12", so that the package of a newer Debian is the newer one; "1" on unstable.
debian_release() {
  local VERSION_ID=
  source /etc/os-release
  echo "1${VERSION_ID:+~deb$VERSION_ID}"
}

# A tree that is built for tests stays so.
build_program() {
  local options=()
  [ -e "$here/build/CMakeCache.txt" ] || options=(-DWOLD_TESTS=OFF -DWOLD_WERROR=OFF)
  install "${build_packages[@]}"
  build "${options[@]}" -- wold
  mkdir -p "$packages"
}

make_deb() {
  install dpkg-dev file
  rm -f "$packages"/wold_*.deb
  (cd "$packages" && cpack -G DEB -B "$packages" --config "$here/build/CPackConfig.cmake" \
    -D "CPACK_PACKAGE_CONTACT=$(maintainer)" -D "CPACK_DEBIAN_PACKAGE_HOMEPAGE=$(homepage)" \
    -D "CPACK_DEBIAN_PACKAGE_RELEASE=$(debian_release)") >&2
  rm -rf "$packages/_CPack_Packages"
  ls "$packages"/wold_*.deb
}

SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git_says log -1 --format=%ct)}
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(stat -c %Y "$here/CMakeLists.txt")}
case "${1:-}" in
  deb | tarball)
    build_program
    "make_$1"
    ;;
  container)
    build_program
    make_deb >&2
    make_container
    ;;
  *)
    echo "usage: packaging/build.sh deb|tarball|container" >&2
    exit 2
    ;;
esac
