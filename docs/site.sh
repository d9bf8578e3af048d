#!/usr/bin/env bash
# Makes the manual as pages for a browser, which need no network and are searched without one:
#
#     docs/site.sh                  build-site/html/index.html
#
# Links between pages are checked; a wrong one fails. Takes ten seconds.
set -euo pipefail
source "$(dirname "$0")/../examples/setup.sh"

install python3-sphinx python3-myst-parser python3-sphinx-rtd-theme
site=$here/build-site
rm -rf "$site"
mkdir -p "$site/source/examples/pictures"
cd "$site/source"
cp "$here/CHANGELOG.md" "$here/CONTRIBUTING.md" .
cat "$here/README.md" "$here/docs/site/contents.md" >index.md
cp -r "$here/docs" .
rm -r docs/site docs/site.sh
cp "$here/examples/guide.md" examples/
cp "$here"/examples/pictures/*.{jpg,webp} examples/pictures/
python3 -B "$here/docs/site/gallery.py" >docs/gallery.md
# Debian's own Python has Sphinx, whichever comes first on the PATH.
/usr/bin/python3 -B -m sphinx -q -W --keep-going -E -b html -c "$here/docs/site" . "$site/html"
say "$site/html/index.html"
