#!/usr/bin/env bash
# Whether all elementary functions come from core/elementary.h:
#
#     tests/elementary_functions.sh PROGRAM LIBRARY...
#
# Lists the functions of the C library and of the compiler's that Wold's libraries, or the program,
# call though versions and processors differ in their last bits, and fails when there is one.
set -euo pipefail

names='a?(cos|sin|tan)h?|sincos|atan2|exp(2|10|m1)?|log(2|10|1p|b)?|pow|cbrt|hypot|erfc?|[tl]?gamma(_r)?'
names+="|[jy][01n]|c(abs|arg|exp|log|pow|sqrt|a?(cos|sin|tan)h?)"
# Of floats, doubles and longs; by finite arguments alone, for lanes; divisions of complex numbers.
forbidden="((__)?($names)[fl]?(_finite)?|_ZGV.*|__div[sdx]c3)(@.*)?"

# Rotations of grids in OpenVDB's headers, which no grid of Wold's has.
openvdb='(vdb[a-z_]*|volume_file|texel_file|voxel_albedo|foreign_texel)[.]cpp[.]o|/wold'
of_openvdb='(pow|sincos|sin|cos)(@.*)?'

calls=$(nm --undefined-only --print-file-name --format=posix "$@" | sed -E 's/:? ([^ ]+) .*/ \1/' |
  grep -E "^[^ ]* $forbidden\$" | grep -vE "($openvdb)[]]? $of_openvdb\$" | sort -u || true)
[ -z "$calls" ] || {
  echo "error: expected elementary functions of core/elementary.h alone, found calls of" >&2
  echo "$calls" >&2
  exit 1
}
