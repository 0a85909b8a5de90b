# SPDX-License-Identifier: BSD-3-Clause
"""The documentation site, built by `make docs`.

Its source is the repository's root, so that relative links between pages, cases and sources are the same on the site
and on the code host.
"""

import re
import sys
from pathlib import Path

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.nodes import make_refnode

sys.path.insert(0, str(Path(__file__).resolve().parent))  # case_gallery, gallery_figures
import case_gallery

ROOT = Path(__file__).resolve().parents[1]

project = "brinell"
author = "brinell's authors"
version = release = (ROOT / "VERSION").read_text(encoding="utf-8").strip()

root_doc = "docs/index"
include_patterns = ["docs/**", "cases/*/README.md", "fits/*/README.md", "bench/README.md", "bench/notebook/*.md"]
include_patterns += ["CHANGELOG.md", "CONTRIBUTING.md"]
exclude_patterns = [".git", ".venv", "build", "results", "docs/tutorials", "docs/_templates"]

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_gallery.gen_gallery",
    "sphinx-mathjax-offline",  # the site is complete without a network
]

# --- Pages ------------------------------------------------------------------------------------------------------------
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
copybutton_exclude = ".linenos, .gp, .go"
html_theme = "furo"
html_title = f"brinell {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_extra_path = ["_site"]  # a front door that leads to docs/index.html
html_show_sphinx = False
html_show_copyright = False
templates_path = [str(ROOT / "docs/_templates")]

# --- Python API -------------------------------------------------------------------------------------------------------
default_role = "code"  # `name` in a docstring
autosummary_generate = True
autosummary_ignore_module_all = False
autosummary_imported_members = True
autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {
    name: name for name in ("Array", "ArrayLike", "FloatArray", "Law", "Progress", "Quantity", "Value")
}
autodoc_preserve_defaults = True
napoleon_google_docstring = True
napoleon_numpy_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False

# --- Tutorials: scripts that the build runs ---------------------------------------------------------------------------
sphinx_gallery_conf = {
    "examples_dirs": "docs/tutorials",  # from the root
    "gallery_dirs": "docs/_tutorials",
    "filename_pattern": r"/\d\d_",
    "within_subsection_order": "FileNameSortKey",
    "copyfile_regex": r"GALLERY_HEADER\.rst",
    "download_all_examples": False,
    "show_memory": False,
    "write_computation_times": False,
    "remove_config_comments": True,
    "show_signature": False,
    "abort_on_example_error": True,
    "plot_gallery": True,
    "image_scrapers": ("matplotlib", "gallery_figures"),
}


def draw_cases(_app: Sphinx) -> None:
    """Draws the pictures of the cases, which are not kept in the repository."""
    for name in case_gallery.PICTURES:
        case_gallery.draw(name, ROOT / "docs" / "_gallery")


def show_cases(_app: Sphinx, docname: str, source: list[str]) -> None:
    """Puts the pictures of the cases on their page."""
    if docname == "docs/cases":
        source[0] = source[0].replace(case_gallery.MARK, case_gallery.markdown("_gallery"))


def link_to_tutorials(_app: Sphinx, docname: str, source: list[str]) -> None:
    """A link to a tutorial's script leads to its page."""
    if not docname.startswith("docs/_"):
        source[0] = re.sub(r"\]\(((?:[\w.-]+/)*)tutorials/(\d\d_\w+)\.py\)", r"](\1_tutorials/\2.rst)", source[0])


def link_to_public_name(
    app: Sphinx, env: BuildEnvironment, node: pending_xref, content: nodes.TextElement
) -> nodes.reference | None:
    """A name may be given by the module that defines it; its text stands under the one that exports it."""
    if node.get("refdomain") != "py" or not node["reftarget"].startswith("brinell."):
        return None
    ending = "." + node["reftarget"].rpartition(".")[2]
    for name, found in env.domains.python_domain.objects.items():
        if name.endswith(ending):
            return make_refnode(app.builder, node["refdoc"], found.docname, found.node_id, content, name)
    return None


_summaries: dict[str, list[str]] = {}


def keep_summary(_app: Sphinx, what: str, name: str, _obj: object, _options: object, lines: list[str]) -> None:
    """Napoleon takes what stands before a colon in the text of an attribute for its type; here it never is."""
    if what in {"attribute", "data", "property"}:
        _summaries[name] = list(lines)


def restore_summary(_app: Sphinx, _what: str, name: str, _obj: object, _options: object, lines: list[str]) -> None:
    """The text of an attribute as it was before Napoleon."""
    lines[:] = _summaries.pop(name, lines)


def mark_up(_app: Sphinx, _what: str, _name: str, _obj: object, _options: object, lines: list[str]) -> None:
    """Reads a docstring as Markdown would: an indented block is code, bars and options are only what they are."""
    marked: list[str] = []
    paragraph = ""  # last line that was not indented
    for line in lines:
        is_indented = line.startswith("    ")
        if is_indented and marked and not marked[-1] and paragraph and not re.match(r"\.\. |:|[-*] |.*::$", paragraph):
            marked += ["::", ""]
        if line:
            paragraph = "" if is_indented else line
        if not is_indented and "`" not in line:
            line = re.sub(r"(?<!\S)--[a-z][\w-]*", r"``\g<0>``", line.replace("|", "\\|"))
        marked.append(line)
    lines[:] = marked


def name_arrays(
    _app: Sphinx, _what: str, _name: str, _obj: object, _options: object, signature: str | None, result: str | None
) -> tuple[str | None, str | None]:
    """Types of arrays by the names that the sources give them."""

    def short(text: str | None) -> str | None:
        text = text and re.sub(r"TypeAliasForwardRef\('(\w+)'\)", r"\1", text)
        return text and re.sub(
            r"[~\w.]*ndarray\[tuple\[[~\w.]*Any, \.\.\.\], [~\w.]*dtype\[[~\w.]*float64\]\]", "Array", text
        )

    return short(signature), short(result)


def setup(app: Sphinx) -> None:
    """Called by Sphinx."""
    app.connect("builder-inited", draw_cases)
    app.connect("source-read", show_cases)
    app.connect("source-read", link_to_tutorials)
    app.connect("missing-reference", link_to_public_name)
    app.connect("autodoc-process-signature", name_arrays)
    app.connect("autodoc-process-docstring", keep_summary, priority=400)  # Napoleon has 500
    app.connect("autodoc-process-docstring", restore_summary, priority=600)
    app.connect("autodoc-process-docstring", mark_up, priority=700)
