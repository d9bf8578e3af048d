"""How Sphinx makes the manual's pages; docs/site.sh runs it."""

import re
from pathlib import Path

_top = Path(__file__).resolve().parents[2] / "CMakeLists.txt"
_version = re.search(r"project\(wold VERSION (\S+)", _top.read_text(encoding="utf-8"))

project = "Wold"
author = "the authors of Wold"
release = _version.group(1) if _version else ""
extensions = ["myst_parser"]
myst_heading_anchors = 4
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2}
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
highlight_language = "none"
