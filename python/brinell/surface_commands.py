# SPDX-License-Identifier: BSD-3-Clause
"""Command line of the surfaces: ``brinell surface``.

Exit code 0: done; 2: the request or a file is wrong, and one line on the standard error stream describes the error.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from brinell import _core, surfaces
from brinell.commands import reports_errors, reports_warnings
from brinell.errors import InputError
from brinell.surfaces import HeightMap
from brinell.surfaces.files import TEXT

__all__ = ["surface"]


if TYPE_CHECKING:
    _Type = click.ParamType[Any]  # not every version has the brackets when it runs
else:
    _Type = click.ParamType


class _Length(_Type):
    """A length with its unit."""

    name = "length"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """The length in m."""
        try:
            return value if isinstance(value, float) else _core.length(value)
        except InputError as error:
            self.fail(str(error), param, ctx)


class _Pair(_Type):
    """One value for both axes, or two values separated by a comma."""

    def __init__(self, part: _Type):
        self._part = part
        self.name = part.name

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[Any, Any]:
        """The values along x and along y."""
        if isinstance(value, tuple):
            return value
        words = value.split(",")
        if len(words) > 2:
            self.fail(f"{value!r} has {len(words)} parts; allowed: one, or two as in 'X,Y'", param, ctx)
        parts = [self._part.convert(word.strip(), param, ctx) for word in words]
        return parts[0], parts[-1]


_IN_OPTIONS = (
    ("give spacing=(dx, dy) in m, or as '1 um'", "give --spacing, as 1um or 1um,2um"),
    ("give the argument unit, as unit='um'", "give --unit, as um"),
    (r"(?:give|as) unit ?= ?'(\w+)'", r"give --unit \1"),
    (r"layout = '(\w+)'", r"--layout \1"),
    (r"channel ?= ?('[^']*'|\d+)", r"--channel \1"),
    (r"spacing='([^']*)'", r"--spacing '\1'"),
    (r"spacing = \(([-+.e\d]+), ([-+.e\d]+)\) m is used", r"--spacing \1m,\2m is used"),
    (r"leave out unit = '(\w+)'", r"leave out --unit \1"),
    (r"unit = '(\w+)' is no unit", r"--unit \1 is no unit"),
    (r"surfaces\.read\(file, unit='(\w+)'\) takes", r"--unit \1 takes"),
    (
        r"as surfaces\.read\(file, fill=True\), .* do by a smooth surface, or .* by zero",
        "as --fill does by a smooth surface",
    ),
)
"""Phrases about arguments of Python, and the phrases about options that replace them."""


def _in_options(text: str) -> str:
    """A message of `brinell.surfaces` with the names of options in place of those of arguments."""
    for arguments, options in _IN_OPTIONS:
        text = re.sub(arguments if "\\" in arguments + options else re.escape(arguments), options, text)
    return text


_LENGTH = _Length()
_file = click.argument("file", type=click.Path(path_type=Path), metavar="FILE")


def _reading(command: Callable[..., Any]) -> Callable[..., Any]:
    """Adds the options for properties that a file may not contain."""
    for option in (
        click.option("--level", is_flag=True, help="Subtract the plane that fits best."),
        click.option(
            "--fill", is_flag=True, help="Fill gaps in the measurement (NaN in the file) with a smooth surface."
        ),
        click.option(
            "--channel", metavar="NAME", help="Name or number, counted from 0, of the map if the file contains several."
        ),
        click.option(
            "--layout",
            type=click.Choice(["rows", "points"]),
            help="Whether the lines of a text are rows of heights or points x, y, z; found out by default.",
        ),
        click.option(
            "--unit",
            metavar="UNIT",
            help="Unit of the heights, and of coordinates, if the file does not name one, such as um.",
        ),
        click.option(
            "--spacing",
            type=_Pair(_LENGTH),
            metavar="DX[,DY]",
            help="Distances of the points if the file does not contain them, such as 2um or 2um,3um.",
        ),
    ):
        command = option(command)
    return command


def _read(file: Path, *, level: bool, **options: Any) -> HeightMap:
    """Reads a surface with the options of `surfaces.read`."""
    if not file.is_file():
        raise InputError(f"{file}: no such file")
    try:
        with reports_warnings(file, _in_options):
            heightmap = surfaces.read(file, **options)
            return heightmap.levelled() if level else heightmap
    except ImportError as error:  # which tells what to install
        raise InputError(str(error)) from error
    except InputError as error:
        raise InputError(_in_options(str(error))) from error


@click.group()
def surface() -> None:
    """Make, read, inspect and write surfaces.

    Files of the types .npz, .csv, .txt and .dat contain a surface with the distances of its points; .npy contains its
    heights alone. Text of rows of heights or of points x, y, z is read whatever its ending; everything else is read by
    SurfaceTopography.
    """


@surface.command("make")
@click.argument("out", type=click.Path(path_type=Path), metavar="OUT")
@click.option(
    "--size",
    type=_Pair(_LENGTH),
    metavar="LX[,LY]",
    required=True,
    help="Period, which is the longest wavelength, such as 1mm.",
)
@click.option(
    "--cells",
    type=_Pair(click.IntRange(1, 32768)),
    metavar="NX[,NY]",
    required=True,
    help="Numbers of points along x and y; 8 per cutoff wavelength are enough for contact.",
)
@click.option("--rms-height", type=_LENGTH, help="Root mean square height, such as 0.5um. Give this or --rms-slope.")
@click.option("--rms-slope", type=click.FloatRange(min=0.0), help="Root mean square of the magnitude of the gradient.")
@click.option("--hurst", type=click.FloatRange(0.0, 1.0), default=0.8, show_default=True, help="Hurst exponent.")
@click.option(
    "--rolloff",
    type=_LENGTH,
    help="Roll-off wavelength, above which the power spectral density is constant; default: none.",
)
@click.option("--cutoff", type=_LENGTH, required=True, help="Shortest wavelength.")
@click.option(
    "--seed",
    type=click.IntRange(0, 2**63 - 1),
    default=0,
    show_default=True,
    help="Seed of the random numbers; each seed gives another surface.",
)
@reports_errors
def _make(
    out: Path,
    size: tuple[float, float],
    cells: tuple[int, int],
    rms_height: float | None,
    rms_slope: float | None,
    hurst: float,
    rolloff: float | None,
    cutoff: float,
    seed: int,
) -> None:
    """Make a random, self-affine, periodic surface and write it to OUT.

    A case can have the same surface without a file, by a texture of type "random".
    """
    with reports_warnings(out):
        made = surfaces.random(
            size,
            cells,
            cutoff=cutoff,
            rms_height=rms_height,
            rms_slope=rms_slope,
            hurst=hurst,
            rolloff=rolloff,
            seed=seed,
        )
    surfaces.write(out, made)
    click.echo(_table(made))
    click.echo(out)


@surface.command("show")
@_file
@_reading
@click.option(
    "--figure",
    type=click.Path(path_type=Path),
    metavar="PICTURE",
    help="Draw the surface to a file of type .png, .pdf or .svg.",
)
@reports_errors
def _show(file: Path, figure: Path | None, **options: Any) -> None:
    """Print the roughness of the surface in FILE.

    The figure of --figure shows the map, the power spectral density, the distribution of the heights and the
    bearing-area curve.
    """
    ending = figure.suffix.lstrip(".").lower() if figure else None
    if figure and ending not in ("png", "pdf", "svg"):
        raise InputError(f"{figure}: cannot draw {figure.suffix!r}; allowed: .png, .pdf, .svg")
    heightmap = _read(file, **options)
    click.echo(_table(heightmap))
    if figure and ending:
        from brinell.plot import style
        from brinell.plot.surfaces import surface as drawn

        path = style.save(drawn(heightmap, title=file.name), figure.parent, figure.stem, [ending])[0]
        click.echo(path)


@surface.command("convert")
@click.argument("file", type=click.Path(path_type=Path), metavar="IN")
@click.argument("out", type=click.Path(path_type=Path), metavar="OUT")
@_reading
@reports_errors
def _convert(file: Path, out: Path, spacing: tuple[float, float] | None, **options: Any) -> None:
    """Read the surface in IN and write it to OUT, a file of type .npz, .csv, .txt, .dat or .npy.

    A .npy file contains the heights alone; for it the distances of the points need not be known.
    """
    if spacing is None and out.suffix == ".npy" and file.suffix in (".npy", *TEXT):
        spacing = (1.0, 1.0)
    surfaces.write(out, _read(file, spacing=spacing, **options))
    click.echo(out)


def _table(heightmap: HeightMap) -> str:
    """The roughness with the symbols of ISO 25178-2, as a table."""
    ny, nx = heightmap.heights.shape
    rows = [
        ("points", f"{nx} x {ny}", "along x, along y"),
        ("spacing", " x ".join(f"{d:.6g} m" for d in heightmap.spacing), ""),
        ("size", " x ".join(f"{s:.6g} m" for s in heightmap.size), "periodic" if heightmap.periodic else ""),
        ("Sa", f"{heightmap.Sa:.6g} m", "arithmetic mean height"),
        ("Sq", f"{heightmap.Sq:.6g} m", "root mean square height"),
        ("Sz", f"{heightmap.Sz:.6g} m", "highest peak to deepest pit"),
        ("Ssk", f"{heightmap.Ssk:.4g}", "skewness; 0 if symmetric"),
        ("Sku", f"{heightmap.Sku:.4g}", "kurtosis; 3 if Gaussian"),
        ("Sk", f"{heightmap.Sk:.6g} m", "height of the core of the bearing-area curve"),
        ("Spk", f"{heightmap.Spk:.6g} m", "reduced height of the peaks above the core"),
        ("Svk", f"{heightmap.Svk:.6g} m", "reduced depth of the valleys below it"),
        ("Sdq", f"{heightmap.Sdq:.6g}", "root mean square slope"),
    ]
    if math.isfinite(heightmap.rms_curvature):  # fewer than three points along an axis have none
        rows.append(("curvature", f"{heightmap.rms_curvature:.6g} 1/m", "root mean square of the mean curvature"))
    return "\n".join(f"{name:<10} {value:<28} {text}".rstrip() for name, value, text in rows)
