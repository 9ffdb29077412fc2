# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The settings of Sphinx."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

project = "vtkHelios"
author = "The vtkHelios authors"
copyright = author
release = re.search(
    r"project\(vtkHelios VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()
).group(1)

extensions = ["myst_parser", "sphinx_copybutton"]
myst_heading_anchors = 4
myst_enable_extensions = ["attrs_inline"]
suppress_warnings = ["myst.header", "misc.highlighting_failure"]
smartquotes = False  # texts have options such as --dry-run

html_theme = "furo"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_title = f"vtkHelios {release}"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f6f5c", "color-brand-content": "#1f6f5c"},
    "dark_css_variables": {"color-brand-primary": "#6fc7ad", "color-brand-content": "#6fc7ad"},
}
html_show_sourcelink = False
html_copy_source = False
html_last_updated_fmt = None  # the same sources give the same pages
