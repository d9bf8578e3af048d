#!/usr/bin/env bash
# Whether the JSON Schema of scenes says what the program says:
#
#     tests/schema.sh
#
# Needs what tests/run.sh builds; takes half a minute. See schema_check.py.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

install python3 python3-venv
python3 -m venv "$here/build-schema"
"$here/build-schema/bin/pip" install -q --disable-pip-version-check 'jsonschema==4.*' 'tomli==2.*'
say "JSON Schema"
"$here/build-schema/bin/python" "$here/tests/schema_check.py" "$here/build/wold"
