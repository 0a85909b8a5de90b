# SPDX-License-Identifier: BSD-3-Clause
"""One look for all figures: fonts, colours, colour maps, notation of quantities.

Settings of matplotlib that the caller has changed (`matplotlib.rcParams`, style sheets, matplotlibrc) go before this
look; `figure.figsize` is then the size of every figure, and sizes of fonts follow `font.size`.

Colours are safe for colour-blind readers: the palette of Okabe and Ito for the two bodies, perceptually uniform maps of
matplotlib for fields and for families of curves.
"""

from __future__ import annotations

import contextlib
import functools
import io
import warnings
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, ParamSpec, TypeVar, cast

import matplotlib
import numpy as np
from matplotlib import font_manager
from matplotlib.colors import Colormap, to_hex
from matplotlib.figure import Figure

from brinell.plot import placing
from brinell.plot.described import described
from brinell.plot.placing import Target

__all__ = [
    "CATEGORIES",
    "CONTACT_LINE",
    "FORMATS",
    "GAP_MAP",
    "LOCKED_IN",
    "LOWER",
    "MINUS",
    "PREFIXES",
    "PRESSURE_MAP",
    "REFERENCE",
    "RESIDUAL_MAP",
    "SIGNED_MAP",
    "STRAIN_MAP",
    "STRESS_MAP",
    "TEMPERATURE_MAP",
    "UPPER",
    "Target",
    "as_written",
    "family_colours",
    "figure",
    "font",
    "length",
    "look",
    "new_figure",
    "number",
    "quantity",
    "save",
]

LOWER = "#0072B2"  # Okabe-Ito blue
UPPER = "#D55E00"  # Okabe-Ito vermilion
LOCKED_IN = "#009E73"  # Okabe-Ito green
CATEGORIES = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")  # Okabe-Ito without yellow and black
REFERENCE = "#666666"  # closed-form curves, asymptotes, zero lines
CONTACT_LINE = "#000000"

PRESSURE_MAP = "viridis"
STRESS_MAP = "magma"
STRAIN_MAP = "cividis"
TEMPERATURE_MAP = "inferno"
GAP_MAP = "Blues"
SIGNED_MAP = "RdBu_r"  # compression blue, tension red
RESIDUAL_MAP = "PuOr"  # diverging about the undeformed surface: pile-up against depth

MINUS = "\N{MINUS SIGN}"
FORMATS = ("png", "pdf", "svg")

# Fonts for letters that DejaVu Sans has not got, such as Chinese ones; the installed ones are asked in this order.
_MORE_FONTS = (
    *("Noto Sans CJK SC", "Noto Sans CJK JP", "Noto Sans SC", "Source Han Sans SC", "WenQuanYi Micro Hei"),
    *("WenQuanYi Zen Hei", "Droid Sans Fallback", "Microsoft YaHei", "SimHei", "PingFang SC", "Hiragino Sans GB"),
    *("Arial Unicode MS", "Unifont"),
)
_INSTALLED = {font.name for font in font_manager.fontManager.ttflist}
_FONTS = ["DejaVu Sans", *(name for name in _MORE_FONTS if name in _INSTALLED)]

_RC: Any = {
    "axes.axisbelow": True,
    "axes.edgecolor": "#333333",
    "axes.labelsize": 10,
    "axes.linewidth": 0.8,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 10,
    "axes.titlepad": 6,
    "figure.constrained_layout.h_pad": 0.06,
    "figure.constrained_layout.w_pad": 0.06,
    "figure.dpi": 100,
    "figure.facecolor": "white",
    "font.family": _FONTS,  # the first one comes with matplotlib: the same picture on every machine
    "font.size": 9,
    "image.cmap": "viridis",
    "legend.fontsize": 9,
    "legend.frameon": False,
    "legend.handlelength": 1.6,
    "legend.title_fontsize": 9,
    "lines.linewidth": 1.6,
    "lines.markersize": 3.5,
    "mathtext.fontset": "dejavusans",
    "pdf.fonttype": 42,
    "savefig.bbox": "tight",
    "savefig.dpi": 200,
    "savefig.pad_inches": 0.08,
    "svg.hashsalt": "brinell",  # two runs write the same file
    "xtick.color": "#333333",
    "xtick.labelcolor": "black",
    "xtick.labelsize": 9,
    "ytick.color": "#333333",
    "ytick.labelcolor": "black",
    "ytick.labelsize": 9,
}

_P = ParamSpec("_P")
_R = TypeVar("_R")


_FONT = 9.0
"""Size of the letters of this look, to which its other sizes of fonts belong."""

_OF_FONTS = tuple(key for key, value in _RC.items() if key.endswith(("size", "title_fontsize")) and value > _FONT - 1)
"""Settings that are sizes of fonts."""


def _is_changed(key: str) -> bool:
    """Whether the caller has changed a setting of matplotlib."""
    now: Any = matplotlib.rcParams
    default: Any = matplotlib.rcParamsDefault
    return bool(now[key] != default[key])


@contextlib.contextmanager
def look() -> Iterator[None]:
    """Context in which matplotlib draws in this style, except for settings that the caller has changed."""
    settings = {key: value for key, value in _RC.items() if not _is_changed(key)}
    if _is_changed("font.size"):
        factor = matplotlib.rcParams["font.size"] / _FONT
        settings |= {key: factor * _RC[key] for key in _OF_FONTS if key in settings}
    if any(_is_changed(key) for key in ("font.family", *_FAMILIES)):
        settings.pop("font.family", None)
    with matplotlib.rc_context(rc=settings):
        yield


_FAMILIES = ("font.sans-serif", "font.serif", "font.monospace")


def font(size: float) -> float:
    """A size of letters [pt] of this look, in proportion to the size that the caller has set."""
    return size * float(matplotlib.rcParams["font.size"]) / _FONT


def figure(draw: Callable[_P, _R]) -> Callable[_P, _R]:
    """Decorator that draws a figure within this style, and into the axes that the caller gives by `ax`.

    It describes the arguments that figures have in common, so that each describes only its own.
    """

    @functools.wraps(draw)
    def wrapper(*args: _P.args, **kwargs: _P.kwargs) -> _R:
        with look(), placing.draws_into(cast(Any, kwargs.pop("ax", None))):
            drawn = draw(*args, **kwargs)
        return cast(_R, drawn.root if isinstance(drawn, placing.Placed) else drawn)

    wrapper.__doc__ = described(draw)
    return wrapper


class _ShownFigure(Figure):
    """A figure that a notebook shows as the value of a cell, without `%matplotlib inline`."""

    def _repr_png_(self) -> bytes:
        image = io.BytesIO()
        with look():
            self.savefig(image, format="png", dpi=_NOTEBOOK_DPI, metadata={"Software": None})
        return image.getvalue()


_NOTEBOOK_DPI = 100


def new_figure(width: float, height: float, *, to_scale: bool = False) -> Figure:
    """An empty figure that belongs to no window and no global list, or the figure or axes that the caller gives.

    Args:
        width: [inch].
        height: [inch].
        to_scale: its axes have equal units along both directions, so their boxes cannot stretch to fill the sheet.
    """
    given = placing.target()
    if given is not None:
        return cast(Figure, given)
    if _is_changed("figure.figsize"):
        width, height = matplotlib.rcParams["figure.figsize"]
    return _ShownFigure(figsize=(width, height), layout="compressed" if to_scale else "constrained")


def save(fig: Figure, folder: str | Path, name: str, formats: Sequence[str] = ("png",)) -> list[Path]:
    """Writes a figure as FOLDER/NAME.png (and .pdf, .svg).

    Args:
        fig: what to write.
        folder: where; made if it is not there.
        name: file name without its ending.
        formats: endings out of FORMATS.

    Returns:
        The files written.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    # No date, no version of matplotlib in the file: equal results give equal files.
    metadata = {"png": {"Software": None}, "pdf": {"CreationDate": None}, "svg": {"Date": None}}
    written = []
    for ending in formats:
        path = folder / f"{name}.{ending}"
        with look():
            fig.savefig(path, metadata=metadata[ending])
        written.append(path)
    return written


def as_written(text: str) -> str:
    r"""A text of the user, such as a title or the name of a folder, for matplotlib to draw as it is written.

    A letter that no font has is drawn as a box, with a warning that says what to install.

    >>> print(as_written("run $NAME_$SIZE"))
    run \$NAME_\$SIZE
    """
    missing = "".join(dict.fromkeys(letter for letter in text if not _is_in_a_font(letter)))
    if unknown := "".join(filter(str.isprintable, missing)):
        warnings.warn(
            f"no installed font has {unknown!r} of {text!r}: boxes are drawn; install a font that has, such as "
            "Noto Sans CJK, and remove matplotlib's list of fonts (fontlist-*.json in matplotlib.get_cachedir())",
            stacklevel=2,
        )
    drawn = "".join((_BOX if letter.isprintable() else " ") if letter in missing else letter for letter in text)
    return drawn.replace("$", r"\$")


_BOX = "\N{WHITE SQUARE}"


@functools.cache
def _is_in_a_font(letter: str) -> bool:
    fonts = (font_manager.get_font(font_manager.findfont(name)) for name in _FONTS)
    return letter == "\n" or any(font.get_char_index(ord(letter)) for font in fonts)


def family_colours(count: int) -> list[str]:
    """Colours of an ordered family of curves, the last one darkest; without yellow, which is not visible on white."""
    cmap: Colormap = matplotlib.colormaps["viridis"]
    return [to_hex(cmap(v)) for v in np.linspace(0.8, 0.0, count)] if count > 1 else [to_hex(cmap(0.0))]


def number(value: float, digits: int = 3) -> str:
    """A number for a label: 3 significant digits, a true minus sign, no exponent for everyday sizes.

    >>> number(0.0223), number(-27.0), number(1234.5)
    ('0.0223', '−27', '1230')
    """
    if value == 0.0:
        return "0"
    rounded = float(f"{value:.{digits}g}")
    if 1e-3 <= abs(rounded) < 1e5:
        text = f"{rounded:.6f}".rstrip("0").rstrip(".")
    else:
        mantissa, exponent = f"{rounded:.{digits - 1}e}".split("e")
        if "." in mantissa:
            mantissa = mantissa.rstrip("0").rstrip(".")
        power = str(int(exponent)).replace("-", MINUS)
        text = rf"{mantissa}$\times 10^{{{power}}}$"
    return text.replace("-", MINUS)


PREFIXES = (
    (1e9, "G"),
    (1e6, "M"),
    (1e3, "k"),
    (1.0, ""),
    (1e-3, "m"),
    (1e-6, "µ"),
    (1e-9, "n"),
    (1e-12, "p"),
    (1e-15, "f"),
    (1e-18, "a"),
)


def quantity(value: float, unit: str, digits: int = 3) -> str:
    """A quantity with the prefix that keeps its number between 1 and 1000.

    >>> quantity(1.4925e9, "Pa"), quantity(2.214e-4, "m")
    ('1.49 GPa', '221 µm')
    """
    for scale, prefix in PREFIXES:
        if abs(float(f"{value:.{digits}g}")) >= scale * (1.0 - 1e-12):
            return f"{number(value / scale, digits)} {prefix}{unit}"
    return f"{number(value, digits)} {unit}"


def length(value: float) -> str:
    """A place, which may be 0.

    >>> length(2.214e-4), length(0.0)
    ('221 µm', '0')
    """
    return quantity(value, "m") if value else "0"
