# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Sphinx: pages in Markdown (myst), the theme furo of Debian. Called by docs/site/build."""
import re
from pathlib import Path

root = Path(__file__).resolve().parents[2]
project = "leastcost"
author = "The leastcost authors"
copyright = "2026, " + author
release = re.search(r"VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text())[1]
extensions = ["myst_parser"]
myst_heading_anchors = 5  # those of GitHub, which our pages link to
html_theme = "furo"
html_title = f"leastcost {release}"
html_static_path = [str(Path(__file__).parent / "static")]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
pygments_style = "friendly"
pygments_dark_style = "monokai"
# Pages of the tree that no page tree holds, such as the READMEs of rooms.
suppress_warnings = ["toc.excluded"]
