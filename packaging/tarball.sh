# shellcheck shell=bash disable=SC2154  # `here` and `packages` are set by packaging/build.sh
# Sourced by packaging/build.sh: the program with its libraries in one folder that runs wherever it is
# unpacked, on systems with as new a glibc or a newer one.

# The libraries that every system has, and that have to fit its kernel and programs.
base_packages='^(libc6|libstdc\+\+6|libgcc-s1):'

# needed_libraries PROGRAM: what the loader would take, a name and a path each.
needed_libraries() { ldd "$1" | awk '$2 == "=>" {print $1, $3}'; }

# owner FILE: "package:architecture" of a file that may be known by its name before /usr was merged.
owner() {
  local path
  path=$(realpath "$1")
  { dpkg-query -S "$path" || dpkg-query -S "${path#/usr}"; } 2>/dev/null | head -1 | sed 's/: .*//'
}

# copy_library NAME PATH FOLDER: unless it is the system's; of the rest also what its package says of
# its licence. Prints the package and its version.
copy_library() {
  local package
  package=$(owner "$2")
  [[ ! $package =~ $base_packages ]] || return 0
  install_file "$2" "$3/lib/$1"
  # Those that say themselves where their libraries are would find the system's.
  [ -z "$(patchelf --print-rpath "$3/lib/$1")" ] ||
    patchelf --set-rpath "\$ORIGIN" "$3/lib/$1"
  install_file "/usr/share/doc/${package%:*}/copyright" \
    "$3/share/doc/wold/libraries/${package%:*}/copyright"
  dpkg-query -W -f "\${Package} \${Version} (source \${source:Package} \${source:Version})\n" "$package"
}

install_file() { command install -D -m 644 "$1" "$2"; }

# copy_libraries FOLDER: and a list of them.
copy_libraries() {
  local name path
  needed_libraries "$1/bin/wold" | while read -r name path; do
    copy_library "$name" "$path" "$1"
  done | sort -u >"$1/share/doc/wold/libraries.txt.new"
  mv "$1/share/doc/wold/libraries.txt.new" "$1/share/doc/wold/libraries/list.txt"
  # As DT_RPATH, which holds for the libraries of libraries, too; and programs that Wold starts do not
  # inherit it, as they would LD_LIBRARY_PATH.
  patchelf --force-rpath --set-rpath "\$ORIGIN/../lib" "$1/bin/wold"
}

# copy_library_data FOLDER: where gen/core/quiet_gdal.cpp looks for it.
copy_library_data() {
  cp -rL /usr/share/gdal "$1/share/wold/gdal"
  cp -rL /usr/share/proj "$1/share/wold/proj"
}

# pack FOLDER ARCHIVE: the same bytes of the same files.
pack() {
  tar --create --sort=name --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
    --mtime="@$SOURCE_DATE_EPOCH" --directory="$(dirname "$1")" "$(basename "$1")" |
    gzip -n >"$2"
}

make_tarball() {
  local version name folder
  install patchelf
  version=$("$here/build/wold" --version | sed -n 's/^wold //p')
  name=wold-$version-linux-$(uname -m)
  folder=$(mktemp -d)/$name
  cmake --install "$here/build" --prefix "$folder" --strip >/dev/null
  say "Collecting libraries"
  copy_libraries "$folder"
  copy_library_data "$folder"
  pack "$folder" "$packages/$name.tar.gz"
  rm -rf "$(dirname "$folder")"
  echo "$packages/$name.tar.gz"
}
