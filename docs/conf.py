"""The site of the documents, as script/docs has Sphinx make it. Its pages are laid out by docs/site/stage.py."""

import os
import pathlib
import re

_root = pathlib.Path(__file__).resolve().parent.parent
_version = re.search(r"^project\(.*?VERSION ([\d.]+)", (_root / "CMakeLists.txt").read_text(), re.M | re.S)

project = "ringfilm"
author = "the ringfilm authors"
copyright = "the ringfilm authors, Apache-2.0"
version = release = _version.group(1) if _version else ""
language = "en"
smartquotes = False  # words of programs stay as they are typed
html_title = f"ringfilm {release}"

extensions = ["myst_parser", "sphinx.ext.mathjax", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "breathe"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = []
suppress_warnings = ["misc.highlighting_failure", "myst.header"]  # a figure's JSON with "..."; pages that begin at ##

myst_enable_extensions = ["dollarmath", "amsmath"]
myst_dmath_double_inline = True
myst_update_mathjax = False

# Formulas are set by the copy of MathJax in the site: no page asks for anything from elsewhere. As SVG, since browsers
# refuse fonts of pages that are opened as files.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {
    "tex2jax": {
        "inlineMath": [["\\(", "\\)"]],
        "displayMath": [["\\[", "\\]"]],
        "processRefs": False,
        "processEnvironments": False,
    },
    "SVG": {"linebreaks": {"automatic": True}},
    "messageStyle": "none",
    "showMathMenu": False,
}

autodoc_member_order = "bysource"
autodoc_typehints = "none"
breathe_projects = {"ringfilm": os.environ.get("RINGFILM_DOXYGEN_XML", "")}
breathe_default_project = "ringfilm"
breathe_show_include = False
cpp_index_common_prefix = ["ringfilm::"]
primary_domain = None
nitpicky = False

html_theme = "furo"
html_static_path = ["site/static"]
html_css_files = ["site.css"]
html_extra_path = [os.environ["RINGFILM_DOCS_EXTRA"]] if "RINGFILM_DOCS_EXTRA" in os.environ else []
html_copy_source = False
html_show_sourcelink = False
