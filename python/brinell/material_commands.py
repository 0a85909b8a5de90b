# SPDX-License-Identifier: BSD-3-Clause
"""Command line of materials: ``brinell material``.

Exit code 0: done; 2: the request or a file is wrong, and one line on the standard error stream describes the error.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import tomli_w

from brinell.commands import reports_errors, reports_warnings
from brinell.errors import InputError
from brinell.materials import PRESETS, MeasuredCurve, preset

__all__ = ["material"]

_MOST_ROWS = 12


@click.group()
def material() -> None:
    """Show what becomes of a measured curve, and materials of standards."""


@material.command("show")
@click.argument("file", type=click.Path(path_type=Path), metavar="FILE")
@click.option(
    "--stress-unit", metavar="UNIT", default="Pa", show_default=True, help="Unit of the stresses, such as MPa."
)
@click.option(
    "--strain-unit", type=click.Choice(["1", "%"]), default="1", show_default=True, help="Unit of the strains."
)
@click.option("--young-modulus", metavar="E", help="Young's modulus, such as 210GPa, for the elastic strains.")
@click.option(
    "--strain-type",
    type=click.Choice(["total", "plastic"]),
    default="total",
    show_default=True,
    help="Whether the strains have an elastic part.",
)
@click.option(
    "--measure",
    type=click.Choice(["true", "engineering"]),
    default="true",
    show_default=True,
    help="True values, or engineering values (per initial length and area).",
)
@click.option(
    "--test",
    type=click.Choice(["automatic", "tension", "compression"]),
    default="automatic",
    show_default=True,
    help="automatic: compression if strains and stresses are below 0.",
)
@click.option(
    "--yield-from",
    type=click.Choice(["offset", "fit", "first_point"]),
    help="Where the material begins to yield; default: offset for total, first_point for plastic strains.",
)
@click.option(
    "--yield-offset", metavar="SHARE", default="0.2%", show_default=True, help="Plastic strain of --yield-from."
)
@click.option(
    "--elastic-slope",
    type=click.Choice(["young_modulus", "curve"]),
    default="young_modulus",
    show_default=True,
    help="Modulus of the elastic strains: --young-modulus, or the slope of the curve.",
)
@click.option("--monotone", is_flag=True, help="Raise stresses below an earlier one to it.")
@click.option(
    "-o",
    "--figure",
    type=click.Path(path_type=Path),
    metavar="PICTURE",
    help="Draw both curves to a file of type .png, .pdf or .svg.",
)
@reports_errors
def _show(file: Path, stress_unit: str, strain_unit: Any, figure: Path | None, **how: Any) -> None:
    """Print the hardening curve of the stress-strain curve in FILE, and what was done to obtain it.

    Each option is a key of material.hardening in a case file, which reads the same file in the same way.
    """
    ending = figure.suffix.lstrip(".").lower() if figure else None
    if figure and ending not in ("png", "pdf", "svg"):
        raise InputError(f"{figure}: cannot draw {figure.suffix!r}; allowed: .png, .pdf, .svg")
    if not file.is_file():
        raise InputError(f"{file}: no such file")
    with reports_warnings(file):
        curve = MeasuredCurve.from_file(file, unit=stress_unit, strain=strain_unit, **how)
    click.echo(_text(curve))
    if figure and ending:
        from brinell.plot import style

        click.echo(style.save(curve.plot(), figure.parent, figure.stem, [ending])[0])


@material.command("presets")
@click.argument("name", required=False)
@click.option(
    "--body", type=click.Choice(["lower", "upper"]), default="lower", show_default=True, help="Body of the table."
)
@click.option("--thermal", is_flag=True, help="With the thermal constants, for a case with heat.")
@reports_errors
def _presets(name: str | None, body: str, thermal: bool) -> None:
    """List materials whose constants a standard gives; of NAME, print the table of a case file."""
    if name is None:
        width = max(map(len, PRESETS))
        for one in PRESETS.values():
            click.echo(f"{one.name:<{width}}  {one.source}")
        return
    found = preset(name, thermal)
    click.echo(f"# {next(one.source for key, one in PRESETS.items() if key.casefold() == name.casefold())}")
    click.echo(tomli_w.dumps({body: {"material": found.to_case()}}), nl=False)


def _text(curve: MeasuredCurve) -> str:
    """The steps, and points of the hardening curve as a table."""
    strain, stress = curve.plastic_strain, curve.flow_stress
    shown = sorted({round(i * (strain.size - 1) / (_MOST_ROWS - 1)) for i in range(_MOST_ROWS)})
    rows = [f"{strain[i]:<16.6g} {stress[i]:.6g}" for i in shown]
    return "\n".join(
        [
            f"{curve.strain.size} points, of which {strain.size} make the hardening curve",
            *curve.notes,
            f"yield stress {curve.yield_stress:.6g} Pa",
            "",
            f"plastic strain   yield stress [Pa]{'' if len(shown) == strain.size else ' (some points)'}",
            *rows,
        ]
    )
